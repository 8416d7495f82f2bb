#pragma once
// Can these stages be? Estimates before the first step: overlap at the pressure, gradient against the critical one,
// fines to erode, a stress to start from. Estimates only: the run itself measures.

#include "suffuse/casefile/reader.hpp"

#include <optional>
#include <string>

namespace suffuse::casefile {

/// That grains are too soft for a stress, and what to do.
struct TooSoft {
    std::string message, advice;
    bool is_error = false; ///< the contact law no longer describes grains
};

/// Nothing where they are stiff enough. @param pressure [Pa]
std::optional<TooSoft> check_stiffness(const grains::Material& material, double pressure);

/// Reports what cannot work as an error and what is doubtful as a warning. `settings` has material, fluid and balance.
void check_physics(ReadContext& context, const Case& settings, const Study& study, const Variant& variant);

} // namespace suffuse::casefile
