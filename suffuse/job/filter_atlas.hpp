#pragma once
// What simulated bases like this one did on a filter of this D15: the atlas of filters, next to the rules.

#include "suffuse/atlas/filter_look_up.hpp"
#include "suffuse/grains/grading.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace suffuse::job {

/// What the rules take of the two curves: the base regraded where they regrade it.
struct BaseOnFilter {
    double ratio = 0; ///< D15 of the filter over d85 of the base [-]
    double width = 0; ///< d85/d15 of the base [-]
};

struct FilterAtlasAnswer {
    std::optional<BaseOnFilter> pair; ///< nothing where a size was not measured
    std::vector<atlas::FilterFound> found;
    std::optional<double> error; ///< of the interpolation, of the base's mass, the largest of all gradients [-]
    std::string extent;          ///< of the atlas: "D15/d85 of 3 to 9, d85/d15 up to 2"
};

FilterAtlasAnswer consult_filter_atlas(
    const grains::Grading& base, const grains::Grading& filter,
    const std::vector<atlas::FilterRow>& rows = atlas::shipped_filter_rows()
);

/// What passed, and whether motion ended, or why there is no answer: one or two sentences.
std::string summary_of(const FilterAtlasAnswer& answer);

/// The same without points, a line for each gradient and how far to trust them, for a terminal.
std::string text_of(const FilterAtlasAnswer& answer);

/// The names are a promise (docs/formats.md).
nlohmann::json filter_atlas_json(const FilterAtlasAnswer& answer);

} // namespace suffuse::job
