#include "suffuse/run/report_data.hpp"

#include "suffuse/base/shell_word.hpp"
#include "suffuse/io/text_file.hpp"
#include "suffuse/report/headlines.hpp"
#include "suffuse/report/removal_table.hpp"
#include "suffuse/report/warnings.hpp"
#include "suffuse/run/assumed_values.hpp"
#include "suffuse/run/erosion_figures.hpp"
#include "suffuse/run/erosion_table.hpp"
#include "suffuse/run/fines_findings.hpp"
#include "suffuse/run/folder.hpp"
#include "suffuse/run/measure.hpp"
#include "suffuse/run/report_answer.hpp"
#include "suffuse/run/report_wishes.hpp"
#include "suffuse/run/result_json.hpp"
#include "suffuse/run/scene_data.hpp"
#include "suffuse/run/section_tables.hpp"
#include "suffuse/run/stored.hpp"
#include "suffuse/run/strength_words.hpp"
#include "suffuse/run/study_figures.hpp"
#include "suffuse/run/triaxial_table.hpp"
#include "suffuse/run/water_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::run {
namespace {

using nlohmann::json;

constexpr double largest_good_hold_error = 0.1; // of a stress that a test holds: the stiffness read there is off

/// The largest error of the stresses that a stage was to be in balance under, over that stress; not a number for other
/// stages.
double stress_error(const casefile::Stage& stage, const Mat3& stress) {
    Vec3 wanted{};
    if (const auto* compact = std::get_if<packing::CompactSpec>(&stage.spec)) {
        wanted = {compact->pressure, compact->pressure, compact->pressure};
    } else if (const auto* settle = std::get_if<dem::SettleSpec>(&stage.spec)) {
        for (int a = 0; a < 3; ++a) {
            const cell::AxisControl& axis = settle->loading.axis[static_cast<std::size_t>(a)];
            wanted[a] = axis.control == cell::Control::Stress ? axis.value : 0;
        }
    }
    double error = std::numeric_limits<double>::quiet_NaN();
    for (int a = 0; a < 3; ++a) {
        if (wanted[a] > 0) {
            error = std::fmax(error, std::abs(stress(a, a) - wanted[a]) / wanted[a]);
        }
    }
    return error;
}

report::StageRow stage_row(const casefile::Case& what, const FinishedStage& stage) {
    const json& n = stage.numbers;
    const casefile::StageSpec& spec = stage.stage->spec;
    const double none = std::numeric_limits<double>::quiet_NaN();
    const auto number = [&](const char* name) { return n.at(name).is_null() ? none : n[name].get<double>(); };
    const auto* test = std::get_if<triaxial::TriaxialSpec>(&spec);
    const bool settles =
        std::holds_alternative<packing::CompactSpec>(spec) || std::holds_alternative<dem::SettleSpec>(spec) ||
        std::holds_alternative<erosion::ErodeSpec>(spec) || std::holds_alternative<erosion::RemoveSpec>(spec) ||
        (test != nullptr && (test->deviator_stress || test->stress_ratio));
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
        row.overlap = {number("max_overlap_ratio"), largest_good_overlap};
        row.stress_error = {stress_error(*stage.stage, n.at("stress").get<Mat3>()), what.balance.stress_error};
    }
    row.inertial_number.value = number("inertial_number_max") > 0 ? number("inertial_number_max") : none;
    if (test != nullptr) { // its rate was set by the number that its own rows hold
        if (const auto error = triaxial::largest_hold_error(stage.findings.curve, test->path)) {
            row.stress_error = {*error, largest_good_hold_error};
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

/// The thresholds that the figures mark, each with one standard deviation to both sides.
void mark_thresholds(const std::vector<report::ContentThreshold>& thresholds, report::FinesStudy& study) {
    const auto add = [](std::vector<report::Threshold>& to, const char* name, const report::Scatter& at) {
        to.push_back({name, at.mean, at.mean - at.standard_deviation, at.mean + at.standard_deviation});
    };
    for (const report::ContentThreshold& each : thresholds) {
        if (each.at.seeds == 0) {
            continue;
        }
        if (each.from.ends_with("loose")) {
            add(study.density, "FC_threshold of e", each.at);
        } else if (each.from.ends_with("(e_min)")) {
            add(study.density, "FC_threshold of e_min", each.at);
        } else if (each.name == "FC_active") {
            add(study.activity, each.from.starts_with("strong") ? "FC_active by strong LS" : "FC_active by b", each.at);
        }
    }
}

/// What the case marks and the run has taken over, without what was typed when it began.
std::vector<report::AssumedValue> assumed_in(const std::filesystem::path& folder, const casefile::Case& what) {
    const std::filesystem::path given = folder / "case.toml", options = folder / options_file;
    if (!std::filesystem::exists(given)) {
        return {}; // a program that runs cases of its own leaves none
    }
    const json asked = std::filesystem::exists(options) ? read_json(options) : json::object();
    const std::vector<std::string> nothing;
    return take_from(options, [&] {
        return assumed_values(
            io::read_text(given), what.preset, asked.value("overrides", nothing), asked.value("studies", nothing)
        );
    });
}

/// Of a value of the provenance; of its calls, how many there were.
std::string provenance_text(const json& value) {
    if (value.is_array()) {
        return std::to_string(value.size());
    }
    return value.is_string() ? value.get<std::string>() : value.dump();
}

} // namespace

report::ReportData describe_run(
    const casefile::Case& what, const std::filesystem::path& folder, const std::vector<FinishedStage>& stages,
    const json& provenance, RunRemarks remarks
) {
    const ErosionStory story = find_story(stages);
    report::ReportData data;
    data.title = what.title;
    data.run = folder.filename().string();
    std::optional<FinesSweep> sweep = find_fines_sweep(what, stages);
    const std::optional<FinesResults> fines = gather_fines(what, stages);
    data.answer = sweep ? answer_of_fines(*sweep) : std::vector<std::string>{};
    if (const std::string sentence = thresholds_sentence(fines); !sentence.empty()) {
        data.answer.insert(data.answer.begin() + (data.answer.empty() ? 0 : 1), sentence); // after what was asked
    }
    if (sweep && fines) {
        mark_thresholds(fines->thresholds, sweep->curves);
    }
    const std::vector<StrengthChange> strength = compare_strength(stages);
    for (std::string& sentence : answer_of_erosion(story, stages, strength)) {
        data.answer.push_back(std::move(sentence));
    }
    data.paper = what.paper;
    if (!what.paper.empty()) { // another soil has nothing to meet
        data.findings = std::move(remarks.findings);
    }
    if (auto table = thresholds_table(fines)) {
        data.tables.push_back(std::move(*table));
    }
    if (fines) {
        if (auto table = report::removal_table(fines->removals)) {
            data.tables.push_back(std::move(*table));
        }
        data.headlines = report::fines_headlines(fines->thresholds);
    }
    for (report::Headline& headline : report::erosion_headlines(story.erosion)) {
        data.headlines.push_back(std::move(headline));
    }
    if (auto headline = strength_headline(strength)) {
        data.headlines.push_back(std::move(*headline));
    }
    if (auto headline = report::findings_headline(data.findings)) {
        data.headlines.push_back(std::move(*headline));
    }
    data.warnings = std::move(remarks.flaws);
    data.warnings.insert(data.warnings.end(), remarks.warnings.begin(), remarks.warnings.end());
    data.warnings = report::merged_warnings(data.warnings);
    data.case_warnings = std::move(remarks.case_warnings);
    data.unfinished = std::move(remarks.unfinished);
    data.assumed = assumed_in(folder, what);
    data.figures = draw_study(what, folder, stages, sweep ? &*sweep : nullptr);
    for (report::Figure& figure : draw_erosion(what, folder, story)) {
        data.figures.push_back(std::move(figure));
    }
    for (report::Figure& figure : draw_fluxes(stages, story)) {
        data.figures.push_back(std::move(figure));
    }
    show_stability(what, story, data);
    for (std::optional<report::PageTable> table :
         {tabulate_removals(stages), tabulate_strength(strength), tabulate_tests(what, stages),
          tabulate_water(folder, stages, story, what.fluid), tabulate_erosions(stages)}) {
        if (table) {
            data.tables.push_back(std::move(*table));
        }
    }
    heed_wishes(what.report, data);
    data.scene = describe_scene(folder, stages, story.eroded);
    for (const FinishedStage& stage : stages) {
        data.stages.push_back(stage_row(what, stage));
    }
    for (const auto& [key, value] : provenance.items()) {
        data.provenance.emplace_back(key, provenance_text(value));
    }
    data.redraw = "suffuse report " + shell_word(folder.string());
    return data;
}

} // namespace suffuse::run
