#include "suffuse/run/report_data.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/io/checkpoint.hpp"
#include "suffuse/report/figure_options.hpp"
#include "suffuse/report/figures.hpp"
#include "suffuse/report/headlines.hpp"
#include "suffuse/report/stability_view.hpp"
#include "suffuse/report/words.hpp"
#include "suffuse/run/findings_by_seed.hpp"
#include "suffuse/run/fines_findings.hpp"
#include "suffuse/run/folder.hpp"
#include "suffuse/run/measured_points.hpp"
#include "suffuse/run/scene_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>

namespace suffuse::run {
namespace {

using nlohmann::json;

/// What the erosion figures are drawn from: the first study with an erosion, and the probes of the same study.
struct ErosionStory {
    const FinishedStage* eroded = nullptr;
    std::vector<erosion::ProbeResult> probes;
    erosion::ErosionResult erosion;
    std::vector<report::ResponseCurve> responses;
};

ErosionStory find_story(const std::vector<FinishedStage>& stages) {
    ErosionStory story;
    for (const FinishedStage& stage : stages) {
        if (story.eroded == nullptr && stage.findings.erosion) {
            story.eroded = &stage;
            story.erosion = *stage.findings.erosion;
        }
    }
    for (const FinishedStage& stage : stages) {
        if (story.eroded != nullptr && stage.study != story.eroded->study) {
            continue;
        }
        if (story.probes.empty()) {
            story.probes = stage.findings.probes;
        }
    }
    for (const FinishedStage& stage : stages) {
        if (stage.findings.curve.empty()) {
            continue;
        }
        report::ResponseCurve curve{stage.variant->folder + " / " + stage.stage->name, {}};
        for (const triaxial::PathRow& row : stage.findings.curve) {
            curve.rows.push_back(
                {row.axial_strain, row.volumetric_strain, row.deviator_stress, row.mean_stress, row.void_ratio}
            );
        }
        story.responses.push_back(std::move(curve));
    }
    return story;
}

/// The sample's own grading at the sizes of the curve asked for, and at many between.
grains::Grading sampled_grading(const std::vector<double>& radius) {
    const auto [least, most] = std::minmax_element(radius.begin(), radius.end());
    grains::Grading grading;
    constexpr int points = 60;
    for (int k = 0; k <= points; ++k) {
        grading.diameter.push_back(
            2 * *least * std::pow(*most / *least, static_cast<double>(k) / points) * (1 + 1e-12 * k)
        );
    }
    grading.passing = grains::sample_curve(radius, grading.diameter);
    return grading;
}

/// The sample before erosion: the state of the stage that the erosion starts from.
std::vector<double> radii_before(const std::filesystem::path& folder, const FinishedStage& eroded) {
    if (eroded.stage->parent < 0) {
        return {};
    }
    const casefile::Stage& parent = eroded.variant->stages[static_cast<std::size_t>(eroded.stage->parent)];
    return io::load_world(stage_folder(folder, *eroded.variant, parent) / "state.h5").world.grains.radius;
}

void add(std::optional<report::Figure> figure, std::vector<report::Figure>& figures) {
    if (figure) {
        figures.push_back(std::move(*figure));
    }
}

std::vector<report::Figure>
draw_figures(const casefile::Case& what, const std::filesystem::path& folder, const ErosionStory& story) {
    std::vector<report::Figure> figures;
    const auto axis = what.report.reversed_size_axis ? report::GradingAxis::Reversed : report::GradingAxis::LeftToRight;
    if (story.eroded != nullptr) {
        add(report::erosion_loop(story.erosion), figures);
        const std::vector<double> radius = radii_before(folder, *story.eroded);
        const auto& soil = story.eroded->variant->soil;
        if (!radius.empty()) {
            const grains::Grading sampled = sampled_grading(radius);
            if (soil) {
                add(report::grading_curves(grains::asked_grading(*soil), sampled, soil->finer_than, axis), figures);
            }
            add(report::speed_by_gradient(story.probes), figures);
            add(report::speed_by_pass(story.erosion), figures);
            add(report::eroded_mass(story.erosion), figures);
            add(report::eroded_coordination(story.erosion), figures);
            add(report::stress_path(story.erosion), figures);
            add(report::porosity_path(story.erosion), figures);
            add(report::rules_compared(story.probes, story.erosion), figures);
            add(report::constriction_sizes(story.erosion), figures);
            add(report::eroded_grading(sampled, story.erosion, axis), figures);
            add(report::permeability_by_pass(story.erosion), figures);
        }
    } else {
        add(report::speed_by_gradient(story.probes), figures);
    }
    add(report::triaxial_response(story.responses), figures);
    return figures;
}

/// Internal stability of the eroded soil by its grading, ahead of the figures of the section "Soils".
void show_stability(const casefile::Case& what, const ErosionStory& story, report::ReportData& data) {
    if (story.eroded == nullptr || !story.eroded->variant->soil) {
        return;
    }
    const grains::Soil& soil = *story.eroded->variant->soil;
    const grains::Grading asked = grains::asked_grading(soil);
    stability::AssessSpec spec;
    // A limit with all of the soil on one side is warned of when the case is read; the criteria need both.
    if (soil.finer_than && grains::passing(asked, *soil.finer_than) > 0 &&
        grains::passing(asked, *soil.finer_than) < 1) {
        spec.finer_than = soil.finer_than;
    }
    const stability::Assessment assessment = stability::assess(asked, spec);
    data.tables.push_back(report::stability_table(assessment));
    const auto axis = what.report.reversed_size_axis ? report::GradingAxis::Reversed : report::GradingAxis::LeftToRight;
    data.figures.push_back(report::stability_grading(assessment, axis));
    data.figures.push_back(report::stability_shape(assessment));
}

std::string answer_to_erosion(const erosion::ErosionResult& erosion) {
    std::string text;
    for (const erosion::PassResult& pass : erosion.passes) {
        const double before = dem::mean_stress(pass.stress_before);
        const double loss = before > 0 ? 100 * (1 - dem::mean_stress(pass.stress_constant_volume) / before) : 0;
        text += fmt::format(
            "Pass {}: {} of {} detachable fines left, {:.2f} % of the initial mass; porosity {:.4f} to {:.4f}, "
            "permeability "
            "{} to {} m²; at constant volume the skeleton lost {} % of its mean stress, and resettling strained it by "
            "{} %. ",
            pass.pass, report::grouped(pass.removed), report::grouped(pass.detachable),
            pass.eroded_mass_percent_of_initial, pass.porosity_before, pass.porosity_after,
            report::short_number(pass.permeability_before), report::short_number(pass.permeability_after),
            report::short_number(loss), report::short_number(100 * pass.volumetric_strain)
        );
    }
    return text;
}

std::string answer_to_probes(const std::vector<erosion::ProbeResult>& probes) {
    const report::Detached first = report::count_detached(probes.front());
    std::string text = fmt::format("Of {} fines ", report::grouped(first.yes + first.no));
    for (std::size_t k = 0; k < probes.size(); ++k) {
        const std::int64_t yes = report::count_detached(probes[k]).yes;
        text += fmt::format(
            "{}{} at the gradient i = {:g}",
            k == 0                   ? ""
            : k + 1 == probes.size() ? " and "
                                     : ", ",
            yes == 0 ? "none" : report::grouped(yes), probes[k].gradient
        );
    }
    return text + " are detachable.";
}

std::vector<std::string> answer(const ErosionStory& story, const std::vector<FinishedStage>& stages) {
    std::vector<std::string> sentences;
    if (story.eroded != nullptr) {
        const std::size_t parent = static_cast<std::size_t>(std::max(0, story.eroded->stage->parent));
        const std::string start = story.eroded->variant->stages[parent].name;
        for (const FinishedStage& stage : stages) {
            if (stage.variant != story.eroded->variant || stage.stage->name != start) {
                continue;
            }
            sentences.push_back(fmt::format(
                "{} grains carry {:.4g} kPa at void ratio {:.3f} (porosity {:.3f}, {:.2f} contacts a grain, {} "
                "rattlers).",
                report::grouped(stage.numbers.at("grains").get<std::int64_t>()),
                stage.numbers.at("mean_stress").get<double>() / 1e3, stage.numbers.at("void_ratio").get<double>(),
                stage.numbers.at("porosity").get<double>(), stage.numbers.at("coordination").get<double>(),
                report::grouped(stage.numbers.at("rattlers").get<std::int64_t>())
            ));
        }
    }
    if (!story.probes.empty()) {
        sentences.push_back(answer_to_probes(story.probes));
    }
    if (!story.erosion.passes.empty()) {
        sentences.push_back(answer_to_erosion(story.erosion));
    }
    for (const FinishedStage& stage : stages) {
        if (!stage.numbers.contains("response")) {
            continue;
        }
        const json& response = stage.numbers.at("response");
        sentences.push_back(fmt::format(
            "Triaxial compression {}/{}: peak q = {:.4g} kPa at {:.3g} % axial strain (q/p = {:.2f}), E50 = {:.3g} "
            "MPa, "
            "dilatancy {:.2f}.",
            stage.variant->folder, stage.stage->name, response.at("peak_deviator").get<double>() / 1e3,
            100 * response.at("peak_strain").get<double>(), response.at("peak_ratio").get<double>(),
            response.at("stiffness").get<double>() / 1e6, response.at("dilatancy").get<double>()
        ));
    }
    return sentences;
}

/// What [report] asks of the figures. What cannot be done is warned of: a long run ends with its report all the same.
void heed_wishes(const casefile::ReportSpec& spec, report::ReportData& data) {
    std::erase_if(data.figures, [&](const report::Figure& figure) {
        return !report::is_asked_for(spec.figures, figure);
    });
    for (report::Figure& figure : data.figures) {
        if (spec.dilation_up) {
            report::draw_dilation_up(figure);
        }
    }
    for (const auto& [word, file] : spec.overlay) {
        const std::string id = report::figure_id(word);
        const auto figure = std::find_if(data.figures.begin(), data.figures.end(), [&](const report::Figure& each) {
            return each.id == id;
        });
        if (figure == data.figures.end()) {
            data.warnings.push_back(fmt::format("report.overlay: this run has no {} to lay {} over", word, file));
            continue;
        }
        try {
            if (!report::lay_over(*figure, read_points(file), std::filesystem::path(file).filename().string())) {
                data.warnings.push_back(fmt::format(
                    "report.overlay: {} has no two columns of {} that make up a panel; figures/{}.csv shows their "
                    "names",
                    file, word, id
                ));
            }
        } catch (const Error& error) {
            data.warnings.push_back(fmt::format("report.overlay: {}", error.what()));
        }
    }
}

report::StageRow stage_row(const FinishedStage& stage) {
    const json& n = stage.numbers;
    report::StageRow row;
    row.name = stage.variant->folder + "/" + stage.stage->name;
    row.grains = n.at("grains");
    row.void_ratio = n.at("void_ratio");
    row.porosity = n.at("porosity");
    row.coordination = n.at("coordination");
    row.mean_stress = n.at("mean_stress");
    row.deviator_stress = n.at("deviator_stress");
    row.unbalanced_force = n.at("unbalanced_force");
    row.max_overlap_ratio = n.at("max_overlap_ratio");
    row.inertial_number_max = n.at("inertial_number_max");
    row.steps = n.value("steps", std::int64_t{0});
    row.seconds = n.at("wall_seconds");
    return row;
}

/// Values marked `#~` in the case as given: our choice where the paper gives none.
std::vector<report::AssumedValue> assumed_values(const std::filesystem::path& folder) {
    std::vector<report::AssumedValue> values;
    std::ifstream file(folder / "case.toml");
    for (std::string line; std::getline(file, line);) {
        const std::size_t mark = line.find("#~"), equals = line.find('=');
        if (mark == std::string::npos || equals == std::string::npos || equals > mark) {
            continue;
        }
        const auto trimmed = [](std::string text) {
            const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
            return first == std::string::npos ? std::string{} : text.substr(first, last - first + 1);
        };
        values.push_back(
            {trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1, mark - equals - 1)),
             trimmed(line.substr(mark + 2))}
        );
    }
    return values;
}

} // namespace

report::ReportData describe_run(
    const casefile::Case& what, const std::filesystem::path& folder, const std::vector<FinishedStage>& stages,
    const json& provenance, const std::vector<std::string>& warnings, const std::vector<std::string>& flaws
) {
    const ErosionStory story = find_story(stages);
    report::ReportData data;
    data.title = what.title;
    data.run = folder.filename().string();
    data.answer = answer(story, stages);
    const std::optional<FinesResults> fines = gather_fines(what, stages);
    if (const std::string sentence = thresholds_sentence(fines); !sentence.empty()) {
        data.answer.insert(data.answer.begin(), sentence);
    }
    data.findings = judge_fines_of(fines);
    for (report::Finding& finding : judge_erosion_by_seed(stages)) {
        data.findings.push_back(std::move(finding));
    }
    if (auto table = thresholds_table(fines)) {
        data.tables.push_back(std::move(*table));
    }
    data.headlines = report::erosion_headlines(story.erosion, data.findings);
    data.warnings = flaws;
    data.warnings.insert(data.warnings.end(), warnings.begin(), warnings.end());
    data.assumed = assumed_values(folder);
    data.figures = draw_figures(what, folder, story);
    show_stability(what, story, data);
    heed_wishes(what.report, data);
    data.scene = describe_scene(folder, stages, story.eroded);
    for (const FinishedStage& stage : stages) {
        data.stages.push_back(stage_row(stage));
    }
    for (const auto& [key, value] : provenance.items()) {
        data.provenance.emplace_back(key, value.is_string() ? value.get<std::string>() : value.dump());
    }
    data.redraw = "suffuse report " + folder.string();
    return data;
}

} // namespace suffuse::run
