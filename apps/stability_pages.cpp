#include "apps/stability_pages.hpp"

#include "suffuse/base/version.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/figures/stability_overlay.hpp"
#include "suffuse/figures/stability_view.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/job/atlas_words.hpp"
#include "suffuse/job/draw_figures.hpp"
#include "suffuse/job/scratch_folder.hpp"
#include "suffuse/job/stability_matrix.hpp"
#include "suffuse/report/page.hpp"

#include <fmt/format.h>

#include "apps/json_text.hpp"
#include "apps/page_folder.hpp"
#include <utility>

namespace suffuse::apps {

namespace fs = std::filesystem;

using nlohmann::json;
using stability::Criterion;

namespace {

report::ReportData begin_page(const fs::path& folder, const std::string& command) {
    report::ReportData data;
    data.run = folder.filename().empty() ? folder.parent_path().filename().string() : folder.filename().string();
    data.provenance = {{"program", "suffuse"}, {"version", version()}, {"commit", commit()}, {"command", command}};
    data.cited = {version(), commit()};
    data.redraw = command;
    return data;
}

std::vector<figures::NamedAssessment> named(const std::vector<job::AssessedSoil>& soils) {
    std::vector<figures::NamedAssessment> list;
    for (const job::AssessedSoil& soil : soils) {
        list.push_back({soil.name, &soil.assessment});
    }
    return list;
}

std::string filter_sentence(const job::AssessedSoil& soil) {
    return as_sentence(job::filter_summary(*soil.filter)) + ".";
}

figures::Figure soil_and_filter(const job::AssessedSoil& soil) {
    return figures::filter_overlay(
        {soil.name, &soil.assessment}, {soil.filter->name, &soil.filter->check.own}, filter_sentence(soil)
    );
}

/// What it says, above its table; where it has none, among the answers.
void add_atlas(const job::AssessedSoil& soil, const stability::AssessSpec& spec, report::ReportData& data) {
    job::AtlasWords words = job::atlas_words(job::consult_atlas(soil.measured, spec), *spec.seepage);
    std::string note = as_sentence(words.heading) + ".";
    for (const std::string& sentence : words.notes) {
        note += " " + as_sentence(sentence) + ".";
    }
    if (words.table) {
        words.table->note = note;
        data.tables.push_back(std::move(*words.table));
    } else {
        data.answer.push_back(note);
    }
}

} // namespace

fs::path write_soil_page(
    const job::AssessedSoil& soil, const stability::AssessSpec& spec, const json& about, const fs::path& folder,
    const std::string& command
) {
    report::ReportData data = begin_page(folder, command);
    data.title = "Internal stability of " + soil.name;
    data.answer = {"By its grading alone: " + stability::summary(soil.assessment.criteria) + "."};
    const stability::Tally tally = stability::count_verdicts(soil.assessment.criteria);
    data.opening.verdict = {fmt::format(
        "{} of {} criteria say unstable.", tally.unstable, tally.unstable + tally.transition + tally.stable
    )};
    data.opening.confidence = "Grading only";
    data.opening.about_confidence =
        "The criteria ignore density, stress and flow. A simulation shows which grains are free to move.";
    if (spec.seepage) {
        const bool lifts = spec.seepage->lifts();
        data.answer.push_back(as_sentence(job::seepage_text(*spec.seepage)) + (lifts ? ":" : "."));
        if (!lifts) {
            data.answer.push_back(as_sentence(job::no_heave_text) + ".");
        }
    }
    for (const Criterion& criterion : soil.assessment.gradients) {
        data.answer.push_back(
            fmt::format("{}: {}; {}.", criterion.name, stability::verdict_word(criterion.verdict), criterion.remark)
        );
    }
    if (soil.assessment.has_constrictions) {
        data.answer.push_back(as_sentence(job::constrictions_text(soil.assessment)) + ".");
    }
    data.tables = {figures::stability_table(soil.assessment)};
    if (spec.seepage) {
        add_atlas(soil, spec, data);
    }
    data.figures = {figures::stability_grading(soil.assessment), figures::stability_shape(soil.assessment)};
    if (soil.filter) {
        data.opening.verdict.push_back(fmt::format("The filter {} {}.", soil.filter->name, soil.filter->check.outcome));
        data.answer.push_back(filter_sentence(soil));
        data.answer.push_back(job::summary_of(soil.filter->simulated));
        data.tables.push_back(figures::filter_table(soil.filter->check, soil.filter->name));
        data.figures.push_back(soil_and_filter(soil));
    }
    report::write_report(folder, data, page_folder());
    io::write_file(folder / "assessment.json", json_text(about) + "\n");
    return folder / "report.html";
}

fs::path write_overlay_page(
    const std::vector<job::AssessedSoil>& soils, const json& matrix, const fs::path& folder, const std::string& command
) {
    report::ReportData data = begin_page(folder, command);
    const job::AssessedSoil& worst = soils[job::find_worst(soils)];
    data.title = fmt::format("Internal stability of {} soils", soils.size());
    data.answer = {fmt::format("The worst is {}: {}.", worst.name, stability::summary(worst.assessment.criteria))};
    for (const job::AssessedSoil& soil : soils) {
        if (soil.filter) {
            data.answer.push_back(fmt::format("{}: {}", soil.name, filter_sentence(soil)));
        }
    }
    data.tables = {figures::stability_matrix(named(soils))};
    data.figures = {figures::stability_overlay(named(soils))};
    report::write_report(folder, data, page_folder());
    io::write_file(folder / "assessments.json", json_text(matrix) + "\n");
    return folder / "report.html";
}

void draw_curves(const std::vector<job::AssessedSoil>& soils, const fs::path& file) {
    const job::ScratchFolder scratch(file.has_parent_path() ? file.parent_path() : ".");
    report::ReportData data = begin_page(scratch.path(), "");
    if (soils.size() == 1) {
        data.figures = {
            soils.front().filter ? soil_and_filter(soils.front())
                                 : figures::stability_grading(soils.front().assessment)};
    } else {
        data.figures = {figures::stability_overlay(named(soils))};
    }
    report::write_report(scratch.path(), data, page_folder());
    job::draw_figure(scratch.path(), data.figures.front().id, file, page_folder());
}

} // namespace suffuse::apps
