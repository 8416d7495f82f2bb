#include "suffuse/casefile/weight_words.hpp"

#include "suffuse/casefile/stage_traits.hpp"

#include <algorithm>
#include <variant>

namespace suffuse::casefile {

bool weighs_fines(const Stage& stage) {
    if (const auto* detach = std::get_if<erosion::DetachStageSpec>(&stage.spec)) {
        return detach->probe.gravity.has_value();
    }
    if (const auto* migrate = std::get_if<erosion::MigrateSpec>(&stage.spec)) {
        return migrate->gravity.has_value();
    }
    const auto* erode = std::get_if<erosion::ErodeSpec>(&stage.spec);
    return erode != nullptr && erode->probe.gravity && !erode->forced;
}

std::string weight_sentence(const Case& what) {
    const auto probes = [](const Stage& stage) { return traits_of(stage).probes_fines(); };
    const bool needs_mobility = std::ranges::any_of(what.studies, [&](const Study& study) {
        return std::ranges::any_of(study.variants, [&](const Variant& variant) {
            return std::ranges::any_of(variant.stages, probes);
        });
    });
    if (!needs_mobility) {
        return "";
    }
    return what.gravity
               ? "fines have weight in stages with water (detach, erode, migrate); all other stages are weightless"
               : "nothing has weight, as in the paper: any gradient removes the same grains; with a table "
                 "[gravity] it removes those whose weight it lifts";
}

} // namespace suffuse::casefile
