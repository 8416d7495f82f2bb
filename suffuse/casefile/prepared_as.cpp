#include "suffuse/casefile/prepared_as.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::casefile {
namespace {

constexpr double same_content = 1e-9; // fines contents that differ by less are one [-]
constexpr const char* content_key = "fines_content";

std::optional<double> content_to_prepare_by(const Stage& stage) {
    const auto* compact = std::get_if<packing::CompactSpec>(&stage.spec);
    return compact == nullptr ? std::nullopt : compact->prepared_as;
}

double content_of(const Variant& variant) {
    return variant.soil ? variant.soil->fines_content : 0;
}

bool differ_in_content_alone(const Variant& a, const Variant& b) {
    const auto without_content = [](std::map<std::string, Scalar> values) {
        values.erase(content_key);
        return values;
    };
    return a.replicate == b.replicate && without_content(a.values) == without_content(b.values);
}

} // namespace

bool is_prepared_as_another(const Variant& variant, const Stage& stage) {
    const std::optional<double> content = content_to_prepare_by(stage);
    return content && content_of(variant) > *content + same_content;
}

const Variant* sample_to_prepare_by(const Study& study, const Variant& variant, const Stage& stage) {
    const double content = *content_to_prepare_by(stage);
    const auto found = std::ranges::find_if(study.variants, [&](const Variant& other) {
        return std::abs(content_of(other) - content) <= same_content && differ_in_content_alone(other, variant);
    });
    return found == study.variants.end() ? nullptr : &*found;
}

const Stage* find_stage(const Variant& variant, const std::string& name) {
    const auto found = std::ranges::find(variant.stages, name, &Stage::name);
    return found == variant.stages.end() ? nullptr : &*found;
}

void check_prepared_as(ReadContext& context, const Study& study) {
    for (const Stage& stage : study.stages) {
        const std::optional<double> content = content_to_prepare_by(stage);
        if (!content) {
            continue;
        }
        const bool is_found = std::ranges::all_of(study.variants, [&](const Variant& variant) {
            if (find_stage(variant, stage.name) == nullptr || !is_prepared_as_another(variant, stage)) {
                return true;
            }
            const Variant* other = sample_to_prepare_by(study, variant, stage);
            return other != nullptr && find_stage(*other, stage.name) != nullptr;
        });
        if (!is_found) {
            context.problems.error(
                "E406", context.places[fmt::format("study.{}.stage.{}.prepared_as", study.name, stage.name)],
                fmt::format(
                    "stage \"{}\" is prepared as in the sample at a fines content of {:.4g} %, and [study.{}] has no "
                    "such sample that does this stage",
                    stage.name, 100 * *content, study.name
                ),
                "name a value of `fines_content` that the study sweeps, for which `only` does not leave the stage out"
            );
        }
    }
}

} // namespace suffuse::casefile
