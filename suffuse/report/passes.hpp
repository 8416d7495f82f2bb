#pragma once
// What several figures say of a pass in the same way.

#include "suffuse/erosion/result.hpp"

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

} // namespace suffuse::report
