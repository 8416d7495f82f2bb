#pragma once
// Values that a study adds to one of its sweeps, where a measured curve has its extreme: what they are, and the copies
// of the study that they make. Which values are wanted is known only when the others have been run.

#include "suffuse/casefile/case.hpp"

#include <map>
#include <string>
#include <vector>

namespace suffuse::casefile {

/// The value at `share` of the way from `a` to `b`, written as they are, with at most six digits: of "30 %" and "35 %"
/// the half is "32.5 %". Both are quantities of the same dimension.
Scalar value_between(const Scalar& a, const Scalar& b, double share);

/// The copies of a study of `c` for one value of each of its sweeps, with every replicate. @throws CaseProblems where a
/// value cannot be had.
std::vector<Variant> variants_at(const Case& c, const std::string& study, const std::map<std::string, Scalar>& values);

} // namespace suffuse::casefile
