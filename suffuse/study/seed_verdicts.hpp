#pragma once
// What several seeds decide together.

#include "suffuse/study/finding.hpp"

#include <algorithm>
#include <vector>

namespace suffuse::study {

/// What all of them say; nothing where they disagree, or one is undecided.
inline Verdict agreed(const std::vector<Verdict>& of_seed) {
    const auto all = [&](bool wanted) {
        return !of_seed.empty() &&
               std::all_of(of_seed.begin(), of_seed.end(), [&](const Verdict& v) { return v == wanted; });
    };
    return all(true) ? Verdict(true) : all(false) ? Verdict(false) : std::nullopt;
}

inline bool has(const std::vector<Verdict>& of_seed, bool wanted) {
    return std::find(of_seed.begin(), of_seed.end(), Verdict(wanted)) != of_seed.end();
}

} // namespace suffuse::study
