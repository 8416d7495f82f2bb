#pragma once
// Criteria on the slopes of the curve: h' = d90/d60 for the coarse part, h'' = d90/d15 for the whole [Burenkova 1993],
// its logistic form and the alternative for broadly graded soils [Wan and Fell 2008], as [RMC 2023] gives them.

#include "suffuse/grains/soil.hpp"
#include "suffuse/stability/criterion.hpp"
#include "suffuse/stability/fine_fraction.hpp"

#include <optional>

namespace suffuse::stability {

/// Stable where 0.76 log h'' + 1 < h' < 1.86 log h'' + 1. Tested with sizes up to 100 mm and D60/D10 up to 200; cannot
/// say beyond.
Criterion burenkova(const grains::Grading& grading);

/// The probability that a soil is unstable, P = e^Z/(1 + e^Z). Z has one form for sand-gravel with at most 10 % finer
/// than 0.075 mm, another for silt-sand-gravel. We call a soil unstable from P = 50 % on. Cannot say: without gravel;
/// above Burenkova's band, which was not tested; with more than 10 % of clay; with a fine fraction below 15 % where
/// there is silt. A curve does not give plasticity: the soil is taken as non-plastic (index at most 12).
Criterion wan_fell(const grains::Grading& grading, const std::optional<FineFraction>& fines);

/// For broadly graded silt-sand-gravel with 20 % or more of fine fraction, no gap: unstable where the coarse slope is
/// steep, 30/log(d90/d60) > 80, and the fine slope flat, 15/log(d20/d5) < 22; stable where 30/log(d90/d60) < 70 or
/// 15/log(d20/d5) > 22; transition between. Its number is 30/log(d90/d60).
Criterion wan_fell_alternative(const grains::Grading& grading, const std::optional<FineFraction>& fines);

} // namespace suffuse::stability
