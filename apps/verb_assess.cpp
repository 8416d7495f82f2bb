// assess: internal stability of a soil from its grading, without simulation.

#include "suffuse/base/shell_word.hpp"
#include "suffuse/base/version.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/figures/stability_view.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/read_grading.hpp"
#include "suffuse/job/assessed_soil.hpp"
#include "suffuse/report/page.hpp"
#include "suffuse/stability/open_curve.hpp"

#include <fmt/format.h>

#include "apps/exit_code.hpp"
#include "apps/page_folder.hpp"
#include "apps/verbs.hpp"
#include <filesystem>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using stability::Criterion;

stability::AssessSpec spec_of(const CommandLine& line) {
    stability::AssessSpec spec;
    if (!line.fines.empty()) {
        spec.finer_than = quantity_of(line.fines, dimension::length, "--fines", false);
    }
    spec.relative_density = line.relative_density;
    spec.fabric = line.coarse_fabric ? stability::PrimaryFabric::Coarse : stability::PrimaryFabric::Soil;
    const bool asks_more = line.porosity || line.stress_share || !line.density.empty();
    if (asks_more && !line.seepage_gradient) {
        throw UsageError("--porosity, --density and --alpha go with a gradient: add -i I");
    }
    if (line.seepage_gradient) {
        stability::UpwardSeepage seepage;
        seepage.gradient = *line.seepage_gradient;
        seepage.porosity = line.porosity.value_or(seepage.porosity);
        if (!line.density.empty()) {
            seepage.grain_density = quantity_of(line.density, dimension::density, "--density", false);
        }
        seepage.stress_share = line.stress_share;
        spec.seepage = seepage;
    }
    return spec;
}

/// One soil of a CSV file, or each soil of a case.
std::vector<job::AssessedSoil>
assess_all(const CommandLine& line, const stability::AssessSpec& spec, const Console& console) {
    std::vector<job::AssessedSoil> soils;
    if (!line.subject.ends_with(".toml")) {
        const auto grading = io::read_grading(line.subject, io::CurveEnds::MayBeOpen);
        soils.push_back({line.subject, {}, stability::assess_measured(grading, spec)});
        return soils;
    }
    const casefile::Case what = load_asked_case(line, console);
    for (const auto& [name, soil] : what.soils) {
        stability::AssessSpec own = spec;
        own.finer_than = spec.finer_than ? spec.finer_than : soil.finer_than;
        soils.push_back(
            {line.subject + ", soil " + name, what.soils.size() > 1 ? name : "",
             stability::assess_measured(soil.measured ? *soil.measured : grains::asked_grading(soil), own)}
        );
    }
    if (soils.empty()) {
        throw CaseError(line.subject + ": the case has no soil; its packing is imported, and has no grading to assess");
    }
    return soils;
}

void write_page(
    const job::AssessedSoil& soil, const stability::AssessSpec& spec, const json& about, const fs::path& folder,
    const CommandLine& line
) {
    report::ReportData data;
    data.title = "Internal stability of " + soil.name;
    data.run = folder.filename().empty() ? folder.parent_path().filename().string() : folder.filename().string();
    data.answer = {"By its grading alone: " + stability::summary(soil.assessment.criteria) + "."};
    if (spec.seepage) {
        data.answer.push_back(as_sentence(job::seepage_text(*spec.seepage)) + ":");
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
    data.figures = {figures::stability_grading(soil.assessment), figures::stability_shape(soil.assessment)};
    data.provenance = {{"program", "suffuse"}, {"version", version()}, {"commit", commit()}, {"command", line.typed}};
    data.redraw = line.typed;
    report::write_report(folder, data, page_folder());
    io::write_file(folder / "assessment.json", json_text(about) + "\n");
}

} // namespace

int assess_verb(const CommandLine& line, const Console& console) {
    const stability::AssessSpec spec = spec_of(line);
    json soils = json::array();
    std::string text;
    for (const job::AssessedSoil& soil : assess_all(line, spec, console)) {
        soils.push_back(job::soil_json(soil, spec));
        text += (text.empty() ? "" : "\n\n") + job::text_of(soil, spec, terminal_width());
        if (!line.output.empty()) {
            const fs::path folder = fs::path(line.output) / soil.folder;
            write_page(soil, spec, soils.back(), folder, line);
            soils.back()["written"] = (folder / "report.html").string();
            text += fmt::format("\n{}", (folder / "report.html").string());
        }
    }
    console.result(text);
    console.talk(fmt::format(
        "a simulation tells how many grains are free to go: suffuse {} {}",
        line.subject.ends_with(".toml") ? "run" : "new --psd", shell_word(line.subject)
    ));
    console.document(json_text({{"soils", soils}}));
    return Done;
}

} // namespace suffuse::apps
