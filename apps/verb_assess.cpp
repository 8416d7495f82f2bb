// assess: internal stability of a soil from its grading, without simulation.

#include "suffuse/base/units.hpp"
#include "suffuse/base/version.hpp"
#include "suffuse/casefile/read_grading.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/report/page.hpp"
#include "suffuse/report/stability_view.hpp"
#include "suffuse/stability/assess.hpp"

#include <fmt/format.h>

#include "apps/exit_code.hpp"
#include "apps/page_folder.hpp"
#include "apps/verbs.hpp"
#include "apps/wording.hpp"
#include <cmath>
#include <filesystem>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using stability::Assessment;
using stability::Criterion;

struct AssessedSoil {
    std::string name; ///< as shown: the file, and the soil where a case has it
    fs::path folder;  ///< below -o, where there are several
    Assessment assessment;
};

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
        stability::Seepage seepage;
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
std::vector<AssessedSoil>
assess_all(const CommandLine& line, const stability::AssessSpec& spec, const Console& console) {
    std::vector<AssessedSoil> soils;
    if (!line.subject.ends_with(".toml")) {
        soils.push_back({line.subject, {}, stability::assess(casefile::read_grading(line.subject), spec)});
        return soils;
    }
    const casefile::Case what = load_asked_case(line, console);
    for (const auto& [name, soil] : what.soils) {
        stability::AssessSpec own = spec;
        own.finer_than = spec.finer_than ? spec.finer_than : soil.finer_than;
        soils.push_back(
            {line.subject + ", soil " + name, what.soils.size() > 1 ? name : "",
             stability::assess(grains::asked_grading(soil), own)}
        );
    }
    if (soils.empty()) {
        throw CaseError(line.subject + ": the case has no soil; its packing is imported, and has no grading to assess");
    }
    return soils;
}

json optional_json(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? json(*value) : json(nullptr);
}

json criterion_json(const Criterion& criterion) {
    static const char* const senses[] = {"at-least", "at-most", "between"};
    return {
        {"id", criterion.id},
        {"name", criterion.name},
        {"measure", criterion.measure},
        {"value", optional_json(criterion.value)},
        {"limit", optional_json(criterion.limit)},
        {"upper", optional_json(criterion.upper)},
        {"sense", senses[static_cast<int>(criterion.sense)]},
        {"verdict", stability::verdict_word(criterion.verdict)},
        {"verified", criterion.verified},
        {"remark", criterion.remark},
        {"source", criterion.source},
        {"diameter", optional_json(criterion.diameter)}};
}

json list_json(const std::vector<Criterion>& criteria) {
    json list = json::array();
    for (const Criterion& criterion : criteria) {
        list.push_back(criterion_json(criterion));
    }
    return list;
}

json soil_json(const AssessedSoil& soil, const stability::AssessSpec& spec) {
    const Assessment& found = soil.assessment;
    json sizes = json::object();
    for (const int percent : {5, 10, 15, 50, 60, 85, 90}) {
        sizes[fmt::format("d{}", percent)] = grains::size_at(found.grading, percent / 100.0);
    }
    const stability::Tally tally = stability::count_verdicts(found.criteria);
    const stability::FinesBesideConstrictions& constrictions = found.constrictions;
    json about = {
        {"soil", soil.name},
        {"sizes", sizes},
        {"uniformity", grains::uniformity(found.grading)},
        {"gap", nullptr},
        {"fine_fraction", nullptr},
        {"finer_limit", found.finer_limit},
        {"criteria", list_json(found.criteria)},
        {"gradients", list_json(found.gradients)},
        {"seepage", nullptr},
        {"constrictions",
         {{"split", constrictions.split},
          {"d35_densest", constrictions.densest_d35},
          {"d35_loosest", constrictions.loosest_d35},
          {"fines_d85_by_surface", constrictions.fines_d85},
          {"fines_smaller_densest", constrictions.densest_passes},
          {"fines_smaller_loosest", constrictions.loosest_passes}}},
        {"tally",
         {{"stable", tally.stable},
          {"transition", tally.transition},
          {"unstable", tally.unstable},
          {"cannot_say", tally.cannot_say},
          {"unverified", tally.unverified}}},
        {"summary", stability::summary(found.criteria)}};
    if (found.gap) {
        about["gap"] = {{"from", found.gap->fine_end}, {"to", found.gap->coarse_end}, {"finer", found.gap->finer}};
    }
    if (found.fines) {
        about["fine_fraction"] = {
            {"finer_than", found.fines->finer_than}, {"content", found.fines->content}, {"basis", found.fines->basis}};
    }
    if (spec.seepage) {
        about["seepage"] = {
            {"gradient", spec.seepage->gradient},
            {"porosity", spec.seepage->porosity},
            {"grain_density", spec.seepage->grain_density},
            {"stress_share", optional_json(spec.seepage->stress_share)}};
    }
    return about;
}

std::string mm(double size) {
    return fmt::format("{:.3g}", 1e3 * size);
}

std::string opening(const AssessedSoil& soil) {
    const grains::Grading& grading = soil.assessment.grading;
    const auto size = [&grading](double share) { return mm(grains::size_at(grading, share)); };
    std::string text = fmt::format(
        "{}  d10 {}  d50 {}  d60 {} mm  Cu {:.3g}", soil.name, size(0.10), size(0.50), size(0.60),
        grains::uniformity(grading)
    );
    if (const auto& gap = soil.assessment.gap) {
        text += fmt::format("  gap at {}-{} mm", mm(gap->fine_end), mm(gap->coarse_end));
    }
    if (const auto& fines = soil.assessment.fines) {
        text +=
            fmt::format("  fines {:.3g} % below {} mm ({})", 100 * fines->content, mm(fines->finer_than), fines->basis);
    }
    return text + "\n";
}

/// "Kezdi 1979   D15c/d85f 11.4   <= 4   unstable   remark"; on narrow terminals the remark stands below.
std::string line_of(const Criterion& criterion) {
    constexpr std::size_t wide = 120;
    const std::string number =
        criterion.value ? fmt::format("{} {:.3g}", criterion.measure, *criterion.value) : criterion.measure;
    const std::string first =
        fmt::format("  {:25}{:27}{:14}", criterion.name, number, stability::limit_text(criterion));
    const char* const verdict = stability::verdict_word(criterion.verdict);
    return terminal_width() < wide ? fmt::format("{}{}\n      {}\n", first, verdict, criterion.remark)
                                   : fmt::format("{}{:12}{}\n", first, verdict, criterion.remark);
}

std::string heading(const char* first) {
    return fmt::format("  {:25}{:27}{:14}{}\n", first, "number", "stable if", "verdict");
}

std::string gradient_lines(const stability::Seepage& seepage, const Assessment& found) {
    std::string text = fmt::format(
        "\n  upward seepage, i = {:.4g}; porosity {:.3g}, grains {:.4g} kg/m3\n", seepage.gradient, seepage.porosity,
        seepage.grain_density
    );
    for (const Criterion& criterion : found.gradients) {
        text += line_of(criterion);
    }
    return text;
}

std::string text_of(const AssessedSoil& soil, const stability::AssessSpec& spec) {
    const Assessment& found = soil.assessment;
    std::string text = opening(soil) + "\n" + heading("criterion");
    for (const Criterion& criterion : found.criteria) {
        text += criterion.verified ? line_of(criterion) : "";
    }
    text += "\n  unverified: limits not read in a source, so not counted\n";
    for (const Criterion& criterion : found.criteria) {
        text += criterion.verified ? "" : line_of(criterion);
    }
    if (spec.seepage) {
        text += gradient_lines(*spec.seepage, found);
    }
    const stability::FinesBesideConstrictions& constrictions = found.constrictions;
    text += fmt::format(
        "\n  constrictions between the grains above {} mm: Dc35 = {} mm at the densest, {} mm at the loosest;\n"
        "  {:.0f} to {:.0f} % of the finer grains are smaller than that\n",
        mm(constrictions.split), mm(constrictions.densest_d35), mm(constrictions.loosest_d35),
        100 * constrictions.densest_passes, 100 * constrictions.loosest_passes
    );
    return text + "\n" + stability::summary(found.criteria);
}

void write_page(const AssessedSoil& soil, const json& about, const fs::path& folder, const CommandLine& line) {
    report::ReportData data;
    data.title = "Internal stability of " + soil.name;
    data.run = folder.filename().empty() ? folder.parent_path().filename().string() : folder.filename().string();
    data.answer = {"By its grading alone: " + stability::summary(soil.assessment.criteria) + "."};
    for (const Criterion& criterion : soil.assessment.gradients) {
        data.answer.push_back(fmt::format(
            "{} at i = {:.3g}: {}; {}.", criterion.name, *criterion.value, stability::verdict_word(criterion.verdict),
            criterion.remark
        ));
    }
    data.tables = {report::stability_table(soil.assessment)};
    data.figures = {report::stability_grading(soil.assessment), report::stability_shape(soil.assessment)};
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
    for (const AssessedSoil& soil : assess_all(line, spec, console)) {
        soils.push_back(soil_json(soil, spec));
        text += (text.empty() ? "" : "\n\n") + text_of(soil, spec);
        if (!line.output.empty()) {
            const fs::path folder = fs::path(line.output) / soil.folder;
            write_page(soil, soils.back(), folder, line);
            soils.back()["written"] = (folder / "report.html").string();
            text += fmt::format("\n{}", (folder / "report.html").string());
        }
    }
    console.result(text);
    console.talk("a simulation tells how many grains are free to go: suffuse new my-soil --from fontainebleau-2016");
    console.document(json_text({{"soils", soils}}));
    return Done;
}

} // namespace suffuse::apps
