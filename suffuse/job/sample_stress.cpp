#include "suffuse/job/sample_stress.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/casefile/load_case.hpp"
#include "suffuse/casefile/stage_traits.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/stored.hpp"
#include "suffuse/study/study_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace suffuse::job {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The gradient that a stage of the sample specifies; nothing where none does.
std::optional<double> gradient_of(const casefile::Variant& variant) {
    for (const casefile::Stage& stage : variant.stages) {
        if (const auto* detach = std::get_if<erosion::DetachStageSpec>(&stage.spec);
            detach && detach->specified_gradient) {
            return detach->specified_gradient;
        }
        if (const auto* erode = std::get_if<erosion::ErodeSpec>(&stage.spec)) {
            return erode->gradient;
        }
    }
    return std::nullopt;
}

/// The last state of the sample that still has all its grains and was not sheared: what a stage with water starts from.
const casefile::Stage* loaded_stage(const casefile::Variant& variant, const fs::path& run) {
    const casefile::Stage* found = nullptr;
    for (const casefile::Stage& stage : variant.stages) {
        const casefile::StageTraits& traits = casefile::traits_of(stage);
        const bool is_test = casefile::laboratory_test(stage.spec) != nullptr;
        if (traits.loses_grains || is_test) {
            break;
        }
        if (traits.ends_balanced && fs::exists(record::stage_folder(run, variant, stage) / "stage.json")) {
            found = &stage;
        }
    }
    return found;
}

} // namespace

SampleStress read_sample_stress(const fs::path& run, const std::string& soil) {
    record::check_is_run(run);
    const casefile::Case what = casefile::load_case((run / record::resolved_case_file).string()).value;
    SampleStress stress;
    std::vector<double> alphas, porosities;
    for (const casefile::Study& study : what.studies) {
        for (const casefile::Variant& variant : study.variants) {
            const casefile::Stage* const stage =
                !soil.empty() && variant.soil_name != soil ? nullptr : loaded_stage(variant, run);
            if (stage == nullptr) {
                continue;
            }
            const fs::path file = record::stage_folder(run, variant, *stage) / "stage.json";
            const json numbers = record::read_json(file);
            record::take_from(file, [&] {
                const auto alpha = numbers.find("alpha_fines");
                if (alpha != numbers.end() && alpha->is_number() && numbers.at("mean_stress").get<double>() > 0) {
                    alphas.push_back(*alpha);
                    porosities.push_back(numbers.at("porosity"));
                    stress.stage = stage->name;
                    stress.grain_density = variant.material.density;
                    stress.specified_gradient =
                        stress.specified_gradient ? stress.specified_gradient : gradient_of(variant);
                }
                return 0;
            });
        }
    }
    if (alphas.empty()) {
        throw StateError(fmt::format(
            "{}: no sample{} has fines that were under stress, and alpha, the share of the stress that fines carry, is "
            "of such a sample; take a run whose soil says which grains are fine, and that has compacted it",
            run.string(), soil.empty() ? "" : fmt::format(" of the soil \"{}\"", soil)
        ));
    }
    const study::Scatter alpha = study::scatter_of(alphas);
    stress.alpha = alpha.mean;
    stress.deviation = alpha.standard_deviation;
    stress.samples = alpha.seeds;
    stress.porosity = study::scatter_of(porosities).mean;
    return stress;
}

stability::Seepage seepage_of(
    const SampleStress& stress, std::optional<double> gradient, std::optional<double> porosity,
    std::optional<double> density
) {
    stability::Seepage seepage;
    seepage.gradient = gradient.value_or(stress.specified_gradient.value_or(0));
    seepage.porosity = porosity.value_or(stress.porosity);
    seepage.grain_density = density.value_or(stress.grain_density);
    seepage.stress_share = stress.alpha;
    return seepage;
}

std::string words_of(const SampleStress& stress, const std::string& run) {
    return fmt::format(
        "alpha = {:.3g}{} of {} of {} (stage {})", stress.alpha,
        stress.samples > 1 ? fmt::format(" ± {:.2g}", stress.deviation) : "",
        stress.samples == 1 ? "one sample" : fmt::format("{} samples", stress.samples), run, stress.stage
    );
}

} // namespace suffuse::job
