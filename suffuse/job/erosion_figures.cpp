#include "suffuse/job/erosion_figures.hpp"

#include "suffuse/figures/figures.hpp"
#include "suffuse/figures/stability_view.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/known_state.hpp"
#include "suffuse/stability/open_curve.hpp"
#include "suffuse/study/trace_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::job {
namespace {

/// The sample before a stage: the state of the stage that it starts from.
std::vector<double> radii_before(const std::filesystem::path& folder, const record::FinishedStage& stage) {
    if (stage.stage->parent < 0) {
        return {};
    }
    const casefile::Stage& parent = stage.variant->stages[static_cast<std::size_t>(stage.stage->parent)];
    return record::KnownState(record::stage_folder(folder, *stage.variant, parent) / "state.h5")
        .load()
        .world.grains.radius;
}

figures::GradingAxis axis_of(const casefile::Case& what) {
    return what.report.reversed_size_axis ? figures::GradingAxis::Reversed : figures::GradingAxis::LeftToRight;
}

void add(std::optional<figures::Figure> figure, std::vector<figures::Figure>& figures) {
    if (figure) {
        figures.push_back(std::move(*figure));
    }
}

std::vector<figures::NamedErosion> named_erosions(const study::ErosionStory& story) {
    const auto name_of = [&](const record::FinishedStage& stage) {
        return story.others.empty() ? "" : stage.stage->name;
    };
    std::vector<figures::NamedErosion> erosions{{name_of(*story.eroded), &story.erosion}};
    for (const record::FinishedStage* other : story.others) {
        erosions.emplace_back(name_of(*other), &*other->findings.erosion);
    }
    return erosions;
}

/// A limit with all of the soil on one side is warned of when the case is read; the criteria need both.
stability::Assessment assess_with(const grains::Grading& grading, const std::optional<double>& finer_than) {
    stability::AssessSpec spec;
    if (finer_than && grains::passing(grading, *finer_than) > 0 && grains::passing(grading, *finer_than) < 1) {
        spec.finer_than = finer_than;
    }
    return stability::assess_measured(grading, spec);
}

} // namespace

grains::Grading sampled_grading(const std::vector<double>& radius, const std::optional<grains::Soil>& soil) {
    const auto [least, most] = std::minmax_element(radius.begin(), radius.end());
    grains::Grading grading;
    constexpr int points = 60;
    for (int k = 0; k <= points; ++k) {
        grading.diameter.push_back(
            2 * *least * std::pow(*most / *least, static_cast<double>(k) / points) * (1 + 1e-12 * k)
        );
    }
    std::vector<double> corners = soil ? grains::specified_grading(*soil).diameter : std::vector<double>{};
    if (soil && soil->finer_than) {
        corners.push_back(*soil->finer_than);
    }
    const double finest = grading.diameter.front(), coarsest = grading.diameter.back();
    for (const double size : corners) {
        if (size > finest && size < coarsest) {
            grading.diameter.push_back(size);
        }
    }
    std::ranges::sort(grading.diameter);
    const auto repeated = std::unique(grading.diameter.begin(), grading.diameter.end());
    grading.diameter.erase(repeated, grading.diameter.end());
    grading.passing = grains::sample_curve(radius, grading.diameter);
    return grading;
}

std::vector<figures::Figure>
draw_erosion(const casefile::Case& what, const std::filesystem::path& folder, const study::ErosionStory& story) {
    std::vector<figures::Figure> figures;
    if (story.eroded != nullptr) {
        add(figures::erosion_loop(story.erosion), figures);
        const std::vector<double> radius = radii_before(folder, *story.eroded);
        if (!radius.empty()) {
            add(draw_grading(what, folder, *story.eroded), figures);
            add(figures::speed_by_gradient(story.probes), figures);
            add(figures::speed_by_pass(story.erosion), figures);
            add(figures::eroded_mass(story.erosion), figures);
            add(figures::eroded_coordination(story.erosion), figures);
            add(figures::stress_path(story.erosion), figures);
            add(figures::porosity_path(story.erosion), figures);
            add(figures::rules_compared(story.probes, named_erosions(story)), figures);
            add(figures::compared_with_twin(story.erosion), figures);
            add(figures::constriction_sizes(story.erosion), figures);
            add(figures::transport_by_pass(story.erosion), figures);
            add(figures::eroded_grading(
                    sampled_grading(radius, story.eroded->variant->soil), story.erosion, axis_of(what)
                ),
                figures);
            add(figures::permeability_by_pass(story.erosion), figures);
        }
    } else {
        add(figures::speed_by_gradient(story.probes), figures);
    }
    for (figures::Figure& figure : figures) {
        const record::FinishedStage* const drawn = figure.id == "fig09" ? story.probed : story.eroded;
        if (drawn != nullptr && drawn->study->variants.size() > 1) {
            figure.caption += fmt::format(" Of one sample: {}.", study::in_words_of_sample(*drawn));
        }
    }
    return figures;
}

std::optional<figures::Figure>
draw_grading(const casefile::Case& what, const std::filesystem::path& folder, const record::FinishedStage& stage) {
    const std::vector<double> radius = radii_before(folder, stage);
    const auto& soil = stage.variant->soil;
    if (radius.empty() || !soil) {
        return std::nullopt;
    }
    return figures::grading_curves(
        grains::specified_grading(*soil), sampled_grading(radius, soil), soil->finer_than, axis_of(what)
    );
}

void show_stability(const casefile::Case& what, const grains::Soil& soil, report::ReportData& data) {
    const grains::Grading simulated = grains::specified_grading(soil);
    const grains::Grading& given = soil.measured ? *soil.measured : simulated;
    const std::optional<double> finer_than =
        soil.surrogate ? std::optional(soil.surrogate->finer_than) : soil.finer_than;
    const stability::Assessment assessment = assess_with(given, finer_than);
    data.tables.push_back(figures::stability_table(assessment));
    data.tables.back().title = soil.measured ? "Internal stability by the whole grading, as measured"
                                             : "Internal stability by the simulated grading";
    if (soil.measured) {
        data.tables.push_back(figures::stability_table(assess_with(simulated, soil.finer_than)));
        data.tables.back().title = soil.surrogate ? "Internal stability by the grading of the surrogate"
                                                  : "Internal stability by the part of the grading that was simulated";
        data.tables.back().note += " The table above is of the soil itself.";
    } else {
        data.tables.back().note += " All is of the grading that was simulated: where it is a part of the soil's curve, "
                                   "without the finest or the coarsest grains, the whole soil may be less stable. "
                                   "suffuse assess judges that.";
    }
    add(figures::surrogate_grading(soil, axis_of(what)), data.figures);
    data.figures.push_back(figures::stability_grading(assessment, axis_of(what)));
    data.figures.push_back(figures::stability_shape(assessment));
}

} // namespace suffuse::job
