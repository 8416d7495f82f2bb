#include "suffuse/record/samples.hpp"

#include "suffuse/casefile/stage_traits.hpp"

#include <algorithm>

namespace suffuse::record {
namespace {

/// Stages up to the one named `until`, itself included; 0 where there is none.
int stages_until(const std::vector<casefile::Stage>& stages, const std::string& until) {
    if (until.empty()) {
        return static_cast<int>(stages.size());
    }
    const auto last = std::find_if(stages.begin(), stages.end(), [&](const auto& s) { return s.name == until; });
    return last == stages.end() ? 0 : static_cast<int>(last - stages.begin()) + 1;
}

} // namespace

std::vector<Sample> list_samples(const casefile::Case& what, const std::string& until, const std::string& only) {
    std::vector<Sample> samples;
    int number = 0, stage = 1;
    for (const casefile::Study& study : what.studies) {
        for (const casefile::Variant& variant : study.variants) {
            ++number;
            const int stages = stages_until(variant.stages, until);
            if (stages > 0 && (only.empty() || variant.folder == only)) {
                samples.push_back({&study, &variant, number, stage, stages});
            }
            stage += static_cast<int>(variant.stages.size());
        }
    }
    return samples;
}

std::string stage_name(const casefile::Variant& variant, const casefile::Stage& stage) {
    return variant.folder + "/" + stage.name;
}

bool writes(const casefile::OutputSpec& output, std::string_view format) {
    return std::find(output.formats.begin(), output.formats.end(), format) != output.formats.end();
}

bool leaves_tables(const casefile::Case& what, const casefile::Variant& variant, const casefile::Stage& stage) {
    const casefile::Stage* origin = &stage;
    while (origin->parent >= 0) {
        origin = &variant.stages[static_cast<std::size_t>(origin->parent)];
    }
    return stage.name == variant.stages.back().name || casefile::traits_of(*origin).origin == casefile::Origin::File ||
           writes(what.output, "csv");
}

bool has_fractions(const casefile::Variant& variant) {
    return variant.soil && (variant.soil->fines || variant.soil->finer_than || variant.soil->kenney_lau);
}

} // namespace suffuse::record
