#pragma once
// Which grains of a packing that was not drawn from the soil's curves are fine: by size, where the soil has a limit.

#include "suffuse/base/error.hpp"
#include "suffuse/casefile/stage_traits.hpp"
#include "suffuse/grains/grains.hpp"
#include "suffuse/grains/sampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace suffuse::record {

/// Whether a stage of the sample removes fines, or finds which would leave.
inline bool needs_fines(const casefile::Variant& variant) {
    return std::ranges::any_of(variant.stages, [](const casefile::Stage& stage) {
        return casefile::traits_of(stage).needs_fines_rule;
    });
}

/// @param origin the packing's file
/// @throws CaseError where size does not determine the fines, or where a stage needs them and the packing has none (or
/// no skeleton).
inline void mark_fines(const casefile::Variant& variant, const std::string& origin, grains::Grains& grains) {
    const auto is_fine = [](std::uint8_t fine) { return fine != 0; };
    const auto& soil = variant.soil;
    if (!soil) {
        return;
    }
    const bool is_mixture = soil->coarse && soil->fines;
    if (is_mixture && std::ranges::any_of(grains.fine, is_fine)) { // the file names them: two curves may overlap
        if (needs_fines(variant) && std::ranges::all_of(grains.fine, is_fine)) {
            throw CaseError(
                origin + ": the file marks all grains as fine, but a stage finds which fines move between coarse "
                         "grains; mark the coarse grains by 0, or leave the marks out",
                origin
            );
        }
        return;
    }
    const std::optional<double> limit = grains::fines_limit(*soil);
    if (!limit) {
        return;
    }
    for (std::size_t g = 0; g < grains.size(); ++g) {
        grains.fine[g] = 2 * grains.radius[g] < *limit ? 1 : 0;
    }
    const bool has_one_part = is_mixture && (soil->fines_content <= 0 || soil->fines_content >= 1);
    const auto fines = std::ranges::count_if(grains.fine, is_fine);
    if (needs_fines(variant) && !has_one_part && (fines == 0 || fines == std::ssize(grains.fine))) {
        const auto [least, most] = std::ranges::minmax(grains.radius);
        throw CaseError(
            fmt::format(
                "{}: grains run from {:.6g} to {:.6g} mm, and fines are those below {:.6g} mm: that leaves no {}; "
                "choose the size of the soil's fines between (finer_than), or the soil that this packing is of",
                origin, 2e3 * least, 2e3 * most, *limit * 1e3, fines == 0 ? "fines" : "skeleton"
            ),
            origin
        );
    }
}

} // namespace suffuse::record
