#pragma once
// What a test along a stress or strain path takes: its strain at its rate, and the strain until a stress.

#include "suffuse/plan/price_stage.hpp"
#include "suffuse/triaxial/run_path.hpp"

namespace suffuse::plan {

/// The price of a test; `sample` goes to the state that is expected at its end.
StagePrice price_test(
    const casefile::Case& what, const casefile::Variant& variant, const triaxial::TriaxialSpec& spec,
    PricedSample& sample
);

} // namespace suffuse::plan
