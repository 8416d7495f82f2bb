#pragma once
// What several figures say of a pass in the same way.

#include "suffuse/erosion/result.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace suffuse::study {

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

using SomePasses = std::vector<const erosion::PassResult*>;

/// Those that a figure draws, and a caption names, where there are many: the first, the last and others evenly
/// between, `most` in all.
inline SomePasses few_of(const SomePasses& passes, std::size_t most) {
    const std::size_t shown = std::min(passes.size(), most);
    SomePasses few;
    for (std::size_t k = 0; k < shown; ++k) {
        few.push_back(passes[shown < 2 ? k : k * (passes.size() - 1) / (shown - 1)]);
    }
    return few;
}

inline SomePasses few_passes(const erosion::ErosionResult& erosion, std::size_t most) {
    SomePasses all;
    for (const erosion::PassResult& pass : erosion.passes) {
        all.push_back(&pass);
    }
    return few_of(all, most);
}

inline std::vector<std::string> pass_names(const SomePasses& passes) {
    std::vector<std::string> names;
    for (const erosion::PassResult* pass : passes) {
        names.push_back(pass_name(pass->pass));
    }
    return names;
}

/// " (4 of 22 passes)" where not all are shown.
inline std::string part_of_passes(const SomePasses& few, std::size_t all) {
    return few.size() == all ? "" : " (" + std::to_string(few.size()) + " of " + std::to_string(all) + " passes)";
}

} // namespace suffuse::study
