#pragma once
// Can these stages be? Estimates before the first step: overlap at the pressure, gradient against the critical one,
// fines to erode, a stress to start from. Estimates only: the run itself measures.

#include "suffuse/casefile/reader.hpp"

namespace suffuse::casefile {

/// Reports what cannot work as an error and what is doubtful as a warning. `settings` has material, fluid and balance.
void check_physics(ReadContext& context, const Case& settings, const Study& study, const Variant& variant);

} // namespace suffuse::casefile
