#pragma once
// What several figures say of a pass in the same way.

#include "suffuse/erosion/result.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::report {

inline std::string pass_name(int pass) {
    return "pass " + std::to_string(pass);
}

inline std::vector<std::string> pass_names(const erosion::ErosionResult& erosion) {
    std::vector<std::string> names;
    for (const erosion::PassResult& pass : erosion.passes) {
        names.push_back(pass_name(pass.pass));
    }
    return names;
}

/// p, compression positive [Pa].
inline double mean_stress(const Mat3& stress) {
    return trace(stress) / 3;
}

/// Share of the mean stress lost at constant volume [-]; nothing where there was no stress to lose.
inline std::optional<double> stress_loss(const erosion::PassResult& pass) {
    const double before = mean_stress(pass.stress_before);
    return before > 0 ? std::optional(1 - mean_stress(pass.stress_constant_volume) / before) : std::nullopt;
}

} // namespace suffuse::report
