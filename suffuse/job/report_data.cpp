#include "suffuse/job/report_data.hpp"

#include "suffuse/answer/answer_fines.hpp"
#include "suffuse/answer/erosion_table.hpp"
#include "suffuse/answer/filter_words.hpp"
#include "suffuse/answer/migration_words.hpp"
#include "suffuse/answer/mobility_words.hpp"
#include "suffuse/answer/opening.hpp"
#include "suffuse/answer/readings_table.hpp"
#include "suffuse/answer/removal_table.hpp"
#include "suffuse/answer/report_answer.hpp"
#include "suffuse/answer/samples_table.hpp"
#include "suffuse/answer/section_tables.hpp"
#include "suffuse/answer/strength_words.hpp"
#include "suffuse/answer/surrogate_words.hpp"
#include "suffuse/answer/triaxial_table.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/casefile/stage_loading.hpp"
#include "suffuse/casefile/stage_traits.hpp"
#include "suffuse/figures/figures_mobility.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/io/text_file.hpp"
#include "suffuse/job/assumed_values.hpp"
#include "suffuse/job/erosion_figures.hpp"
#include "suffuse/job/report_options.hpp"
#include "suffuse/job/scene_data.hpp"
#include "suffuse/job/study_figures.hpp"
#include "suffuse/job/water_figures.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/result_json.hpp"
#include "suffuse/record/stored.hpp"
#include "suffuse/report/warnings.hpp"
#include "suffuse/run/measure.hpp"
#include "suffuse/study/fines_findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <variant>

namespace suffuse::job {
namespace {

using nlohmann::json;

/// The largest error of the stresses that a stage was to be in balance under, over that stress; not a number for other
/// stages.
double stress_error(const casefile::Stage& stage, const Mat3& stress) {
    const cell::Loading loading = casefile::loading_at_end(stage.spec).value_or(cell::Loading{});
    double error = std::numeric_limits<double>::quiet_NaN();
    for (int a = 0; a < 3; ++a) {
        const cell::AxisControl& axis = loading.axis[static_cast<std::size_t>(a)];
        if (axis.control == cell::Control::Stress && axis.value > 0) {
            error = std::fmax(error, std::abs(stress(a, a) - axis.value) / axis.value);
        }
    }
    return error;
}

report::StageRow stage_row(const casefile::Case& what, const record::FinishedStage& stage) {
    const json& n = stage.numbers;
    const casefile::StageSpec& spec = stage.stage->spec;
    const double none = std::numeric_limits<double>::quiet_NaN();
    const auto number = [&](const char* name) { return n.at(name).is_null() ? none : n[name].get<double>(); };
    const triaxial::TriaxialSpec* const test = casefile::laboratory_test(spec);
    const bool settles = casefile::traits_of(spec).ends_balanced || (test != nullptr && test->stops_at_stress());
    const bool touches = n.at("contacts").get<std::int64_t>() > 0;
    report::StageRow row;
    row.name = stage.name();
    row.grains = n.at("grains");
    row.void_ratio = number("void_ratio");
    row.porosity = number("porosity");
    row.coordination = number("coordination");
    row.mean_stress = number("mean_stress");
    row.deviator_stress = number("deviator_stress");
    if (touches) {
        row.unbalanced_force = {number("unbalanced_force"), settles ? what.balance.unbalanced_force : none};
        row.overlap = {number("max_overlap_ratio"), run::largest_good_overlap};
        row.stress_error = {stress_error(*stage.stage, n.at("stress").get<Mat3>()), what.balance.stress_error};
    }
    row.inertial_number.value = number("inertial_number_max") > 0 ? number("inertial_number_max") : none;
    if (test != nullptr) { // its rate was set by the number that its own rows hold
        if (const auto error = triaxial::find_hold_error(stage.findings.curve, test->path)) {
            row.stress_error = {*error, triaxial::good_hold_error};
        }
        row.inertial_number = {0, test->inertial_number};
        for (const triaxial::PathRow& each : stage.findings.curve) {
            row.inertial_number.value = std::max(row.inertial_number.value, each.inertial_number);
        }
    }
    const double volume = std::abs(determinant(n.at("cell").get<Mat3>()));
    if (touches && n.contains("kinetic_energy") && row.mean_stress > 0) {
        row.kinetic_share = n.at("kinetic_energy").get<double>() / (row.mean_stress * volume);
    }
    row.time_step = n.at("time_step");
    row.steps = n.value("steps", std::int64_t{0});
    row.seconds = n.at("wall_seconds");
    return row;
}

/// What the case marks and the run has taken over, without what was typed when it began.
std::vector<report::AssumedValue> assumed_in(const std::filesystem::path& folder, const casefile::Case& what) {
    const std::filesystem::path given = folder / "case.toml", options = folder / record::options_file;
    if (!std::filesystem::exists(given)) {
        return {}; // a program that runs cases of its own leaves none
    }
    const json run_options = std::filesystem::exists(options) ? record::read_json(options) : json::object();
    const std::vector<std::string> nothing;
    return record::take_from(options, [&] {
        return assumed_values(
            io::read_text(given), what.preset, run_options.value("overrides", nothing),
            run_options.value("studies", nothing)
        );
    });
}

/// The paper says "at equilibrium", and no number: what the state was relaxed to that the probes start from decides
/// what a threshold on speed takes.
std::optional<report::AssumedValue> assumed_unbalance(const casefile::Case& what) {
    std::set<double> values;
    for (const casefile::Study& study : what.studies) {
        for (const casefile::Variant& variant : study.variants) {
            for (const casefile::Stage& stage : variant.stages) {
                if (const auto* erode = std::get_if<erosion::ErodeSpec>(&stage.spec);
                    erode != nullptr && !erode->forced) {
                    values.insert(erode->probe.unbalanced_force);
                } else if (const auto* detach = std::get_if<erosion::DetachStageSpec>(&stage.spec)) {
                    values.insert(detach->probe.unbalanced_force);
                }
            }
        }
    }
    if (values.empty()) {
        return std::nullopt;
    }
    return report::AssumedValue{
        "probe_unbalanced_force", fmt::format("{}", fmt::join(values, ", ")),
        "of the equilibrium that the probes start from"};
}

/// "dyke.csv (0.1 to 2 mm); 100 kPa; i = 0.2": of the sample that is judged, as the case has it.
std::string request_text(const casefile::Variant& variant) {
    std::vector<std::string> parts;
    if (variant.soil) {
        const grains::Grading curve = grains::specified_grading(*variant.soil);
        const std::string sizes = fmt::format(
            "{} to {} mm", short_number(1e3 * curve.diameter.front()), short_number(1e3 * curve.diameter.back())
        );
        const std::string file = std::filesystem::path(curve.origin).filename().string();
        parts.push_back(file.empty() ? "grains of " + sizes : fmt::format("{} ({})", file, sizes));
    }
    for (const casefile::Stage& stage : variant.stages) {
        if (const auto* compact = std::get_if<packing::CompactSpec>(&stage.spec)) {
            parts.push_back(fmt::format("{} kPa", short_number(1e-3 * compact->pressure)));
        } else if (const auto* detach = std::get_if<erosion::DetachStageSpec>(&stage.spec);
                   detach != nullptr && detach->specified_gradient) {
            parts.push_back(fmt::format("i = {}", short_number(*detach->specified_gradient)));
        } else if (const auto* erode = std::get_if<erosion::ErodeSpec>(&stage.spec);
                   erode != nullptr && !erode->forced) {
            parts.push_back(fmt::format("i = {}", short_number(erode->gradient)));
        }
    }
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    return fmt::format("{}", fmt::join(parts, "; "));
}

/// What the case marks, and what it need not say to be assumed.
std::vector<report::AssumedValue> all_assumed(const std::filesystem::path& folder, const casefile::Case& what) {
    std::vector<report::AssumedValue> values = assumed_in(folder, what);
    const bool is_marked = std::ranges::any_of(values, [](const report::AssumedValue& value) {
        return value.key.ends_with("probe_unbalanced_force");
    });
    if (auto unbalance = what.paper.empty() || is_marked ? std::nullopt : assumed_unbalance(what)) {
        values.push_back(std::move(*unbalance));
    }
    return values;
}

std::string provenance_text(const json& value) {
    return value.is_string() ? value.get<std::string>() : value.dump();
}

/// The calls that made the run, oldest first; those of a version that kept no list are one.
std::vector<report::Call> calls_in(const json& provenance) {
    std::vector<report::Call> calls;
    for (const json& call : provenance.value("calls", json::array({provenance}))) {
        calls.push_back(
            {call.value("command", ""), call.value("finished", ""),
             fmt::format("{} {}", call.value("version", ""), call.value("commit", "")), call.value("wall_seconds", 0.0)}
        );
    }
    return calls;
}

} // namespace

void take_provenance(report::ReportData& data, const std::filesystem::path& folder, const json& provenance) {
    record::take_from(folder / record::provenance_file, [&] {
        for (const auto& [key, value] : provenance.items()) {
            if (key != "calls") { // a table of their own
                data.provenance.emplace_back(key, provenance_text(value));
            }
        }
        data.calls = calls_in(provenance);
        data.cited = {provenance_text(provenance.at("version")), provenance_text(provenance.at("commit")), true};
    });
}

report::ReportData describe_run(
    const study::RunResults& results, const std::filesystem::path& folder, const json& provenance, RunRemarks remarks
) {
    const casefile::Case& what = *results.what;
    const std::vector<record::FinishedStage>& stages = results.stages;
    const study::ErosionStory& story = results.story;
    report::ReportData data;
    data.title = what.title;
    data.project = what.report.project;
    data.author = what.report.author;
    data.run = folder.filename().string();
    data.answer = results.fines_sweep ? answer::answer_of_fines(*results.fines_sweep) : std::vector<std::string>{};
    if (const std::string sentence = answer::thresholds_sentence(results.fines); !sentence.empty()) {
        data.answer.insert(data.answer.begin() + (data.answer.empty() ? 0 : 1), sentence); // after the question
    }
    for (std::string& sentence : answer::answer_of_mobility(results.mobility)) {
        data.answer.push_back(std::move(sentence));
    }
    for (std::string& sentence : answer::answer_of_erosion(results)) {
        data.answer.push_back(std::move(sentence));
    }
    if (auto sentence = answer::what_weight_would_change(stages)) {
        data.answer.push_back(std::move(*sentence));
    }
    data.paper = what.paper;
    if (!what.paper.empty()) { // another soil has nothing to meet
        data.findings = results.findings;
    }
    if (auto table = answer::thresholds_table(results.fines)) {
        data.tables.push_back(std::move(*table));
    }
    if (results.fines) {
        if (auto table = answer::removal_table(results.fines->removals)) {
            data.tables.push_back(std::move(*table));
        }
    }
    data.opening = answer::open_answer(results, data.findings);
    data.flaws = report::merged_warnings(remarks.flaws);
    data.warnings = report::merged_warnings(remarks.warnings);
    data.case_warnings = std::move(remarks.case_warnings);
    data.unfinished = std::move(remarks.unfinished);
    data.assumed = all_assumed(folder, what);
    for (const study::StudyOutcome& outcome : results.outcomes) {
        if (auto table =
                answer::tabulate_samples(outcome, what.fluid, results.fines_sweep ? &*results.fines_sweep : nullptr)) {
            data.tables.push_back(std::move(*table));
        }
    }
    data.figures = draw_study(results, folder);
    for (figures::Figure& figure : draw_erosion(what, folder, story)) {
        data.figures.push_back(std::move(figure));
    }
    const study::MobilityStory* const surrogate = answer::nearest_surrogate(results.mobility);
    const study::MobilityStory* const weighed =
        surrogate != nullptr ? surrogate : study::main_mobility(results.mobility);
    const record::FinishedStage* const judged = story.eroded != nullptr ? story.eroded
                                                : weighed != nullptr    ? weighed->first
                                                                        : nullptr;
    data.request = judged == nullptr ? "" : request_text(*judged->variant);
    if (judged != nullptr && judged != story.eroded) {
        if (auto figure = draw_grading(what, folder, *judged)) {
            data.figures.push_back(std::move(*figure));
        }
    }
    for (figures::Figure& figure : draw_mobility(results.mobility)) {
        data.figures.push_back(std::move(figure));
    }
    for (figures::Figure& figure : draw_migration(stages)) {
        data.figures.push_back(std::move(figure));
    }
    for (figures::Figure& figure : draw_fluxes(stages, story)) {
        data.figures.push_back(std::move(figure));
    }
    if (judged != nullptr && judged->variant->soil) {
        show_stability(what, *judged->variant->soil, data);
    }
    for (std::optional<figures::PageTable> table :
         {answer::tabulate_surrogate(results.mobility), figures::mobility_table(results.mobility),
          answer::tabulate_removals(stages), answer::tabulate_strength(results.strength),
          answer::tabulate_tests(results), answer::tabulate_water(folder, stages, story, what.fluid),
          answer::tabulate_filters(stages), answer::tabulate_migrations(stages), answer::tabulate_erosions(stages)}) {
        if (table) {
            data.tables.push_back(std::move(*table));
        }
    }
    if (auto table = answer::tabulate_readings(what.paper.empty() ? std::vector<study::Reading>{} : results.readings)) {
        data.tables.push_back(std::move(*table));
    }
    apply_report_options(what.report, data);
    data.scene = describe_scene(folder, stages, story);
    for (const record::FinishedStage& stage : stages) {
        data.stages.push_back(stage_row(what, stage));
    }
    take_provenance(data, folder, provenance);
    data.redraw = "suffuse report " + shell_word(folder.string());
    return data;
}

} // namespace suffuse::job
