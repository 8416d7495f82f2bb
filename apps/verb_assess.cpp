// assess: internal stability of a soil from its grading, without simulation.

#include "suffuse/base/error.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/base/units.hpp"
#include "suffuse/base/version.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/casefile/load_case.hpp"
#include "suffuse/figures/stability_view.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/read_grading.hpp"
#include "suffuse/job/assessed_soil.hpp"
#include "suffuse/report/page.hpp"
#include "suffuse/stability/open_curve.hpp"

#include <fmt/format.h>

#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/page_folder.hpp"
#include "apps/shared_options.hpp"
#include "apps/typed_value.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using stability::Criterion;

struct AssessVerb final : Verb {
    AssessVerb()
        : Verb(
              "assess", "internal stability of a soil from its grading, without simulation",
              "suffuse assess dyke.csv --fines 0.2mm -i 0.3 -o dyke-stability"
          ) {}

    std::string file;  ///< a grading or a case
    std::string fines; ///< size below which grains are fine, with its unit
    std::optional<double> seepage_gradient, relative_density, porosity;
    std::string density; ///< of the grains, with its unit
    std::optional<double> stress_share;
    bool has_coarse_fabric = false; ///< uniformity of the coarse part alone
    std::string output;

    void add_to(Options& options) override {
        options
            .argument("FILE", file, "a grading: CSV with the columns d [mm], passing [%]; or a case, for all its soils")
            .required();
        options.value("--fines", fines, "size below which grains count as fine; found on the curve unless given")
            .type("D");
        options.value("-i,--gradient", seepage_gradient, "hydraulic gradient of upward seepage, as in 0.4 or 12m/30m")
            .type("I")
            .ratio(0);
        options.value("--relative-density", relative_density, "0 loosest, 1 densest; both unless given")
            .type("ID")
            .ratio(0, 1);
        options.value("--porosity", porosity, "with -i; 0.40 unless given").type("N").ratio(0.05, 0.95);
        options.value("--density", density, "of the grains, with -i; 2650kg/m^3 unless given").type("RHO");
        options.value("--alpha", stress_share, "with -i: mean effective stress in the fines over that of the soil")
            .type("A")
            .ratio(0, 1);
        options.flag("--coarse-fabric", has_coarse_fabric, "D60/D10 of the coarse part decides how far to look at F");
        options.value("-o,--output", output, "folder for a page, its figures and numbers").type("DIR");
    }

    [[nodiscard]] int act(const CommandLine& line, const Console& console) const override;
};

stability::AssessSpec spec_of(const AssessVerb& asked) {
    stability::AssessSpec spec;
    if (!asked.fines.empty()) {
        spec.finer_than = quantity_of(asked.fines, dimension::length, "--fines", false);
    }
    spec.relative_density = asked.relative_density;
    spec.fabric = asked.has_coarse_fabric ? stability::PrimaryFabric::Coarse : stability::PrimaryFabric::Soil;
    const bool asks_more = asked.porosity || asked.stress_share || !asked.density.empty();
    if (asks_more && !asked.seepage_gradient) {
        throw UsageError("--porosity, --density and --alpha go with a gradient: add -i I");
    }
    if (asked.seepage_gradient) {
        stability::UpwardSeepage seepage;
        seepage.gradient = *asked.seepage_gradient;
        seepage.porosity = asked.porosity.value_or(seepage.porosity);
        if (!asked.density.empty()) {
            seepage.grain_density = quantity_of(asked.density, dimension::density, "--density", false);
        }
        seepage.stress_share = asked.stress_share;
        spec.seepage = seepage;
    }
    return spec;
}

/// One soil of a CSV file, or each soil of a case.
std::vector<job::AssessedSoil>
assess_all(const AssessVerb& asked, const stability::AssessSpec& spec, const Console& console) {
    std::vector<job::AssessedSoil> soils;
    if (!asked.file.ends_with(".toml")) {
        const auto grading = io::read_grading(asked.file, io::CurveEnds::MayBeOpen);
        soils.push_back({asked.file, {}, stability::assess_measured(grading, spec)});
        return soils;
    }
    const casefile::Case what = load_asked_case(asked.file, {}, console);
    for (const auto& [name, soil] : what.soils) {
        stability::AssessSpec own = spec;
        own.finer_than = spec.finer_than ? spec.finer_than : soil.finer_than;
        soils.push_back(
            {asked.file + ", soil " + name, what.soils.size() > 1 ? name : "",
             stability::assess_measured(soil.measured ? *soil.measured : grains::asked_grading(soil), own)}
        );
    }
    if (soils.empty()) {
        throw CaseError(asked.file + ": the case has no soil; its packing is imported, and has no grading to assess");
    }
    return soils;
}

void write_page(
    const job::AssessedSoil& soil, const stability::AssessSpec& spec, const json& about, const fs::path& folder,
    const std::string& command
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
    data.provenance = {{"program", "suffuse"}, {"version", version()}, {"commit", commit()}, {"command", command}};
    data.cited = {version(), commit()};
    data.redraw = command;
    report::write_report(folder, data, page_folder());
    io::write_file(folder / "assessment.json", json_text(about) + "\n");
}

int AssessVerb::act(const CommandLine& line, const Console& console) const {
    const stability::AssessSpec spec = spec_of(*this);
    json soils = json::array();
    std::string text;
    for (const job::AssessedSoil& soil : assess_all(*this, spec, console)) {
        soils.push_back(job::soil_json(soil, spec));
        text += (text.empty() ? "" : "\n\n") + job::text_of(soil, spec, terminal_width());
        if (!output.empty()) {
            const fs::path folder = fs::path(output) / soil.folder;
            write_page(soil, spec, soils.back(), folder, line.typed);
            soils.back()["written"] = (folder / "report.html").string();
            text += fmt::format("\n{}", (folder / "report.html").string());
        }
    }
    console.result(text);
    console.talk(fmt::format(
        "a simulation tells how many grains are free to go: suffuse {} {}",
        file.ends_with(".toml") ? "run" : "new --psd", shell_word(file)
    ));
    console.document(json_text({{"soils", soils}}));
    return Done;
}

} // namespace

MadeVerb make_assess_verb() {
    return std::make_unique<AssessVerb>();
}

} // namespace suffuse::apps
