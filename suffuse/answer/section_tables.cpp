#include "suffuse/answer/section_tables.hpp"

#include "suffuse/base/grouped.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/facts/shown.hpp"
#include "suffuse/flow/reynolds.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/known_state.hpp"
#include "suffuse/study/trace_curves.hpp"

#include <fmt/format.h>

namespace suffuse::answer {
namespace {

using nlohmann::json;

/// What the water finds in one state. A tortuosity of 0: not known, of a run of an earlier version.
struct Seepage {
    double permeability, porosity, tortuosity;
};

/// A row of the table on water. @param radius of its grains [m]
std::vector<std::string> water_row(
    const std::string& state, const Seepage& seepage, const std::vector<double>& radius, const flow::Fluid& fluid
) {
    const double by_formula = kozeny_carman(radius, seepage.porosity);
    return {
        state,
        fmt::format("{:.4f}", seepage.porosity),
        short_number(seepage.permeability),
        number_with_power(flow::conductivity(seepage.permeability, fluid)),
        short_number(by_formula),
        short_number(seepage.permeability / by_formula, 2),
        seepage.tortuosity > 0 ? fmt::format("{:.2f}", seepage.tortuosity) : "–"};
}

std::vector<double> radii_in(const std::filesystem::path& state) {
    return std::filesystem::exists(state) ? record::KnownState(state).load().world.grains.radius
                                          : std::vector<double>{};
}

/// Permeability along the flow, of the numbers of a stage; null where there is none.
json along_flow(const json& numbers) {
    return numbers.value("permeability_along", numbers.value("permeability", json()));
}

void add_flows(
    const std::filesystem::path& folder, const std::vector<record::FinishedStage>& stages, const flow::Fluid& fluid,
    std::vector<std::vector<std::string>>& rows
) {
    for (const record::FinishedStage& stage : stages) {
        const json along = along_flow(stage.numbers);
        if (!along.is_number()) {
            continue;
        }
        const json tortuosity = stage.numbers.value("tortuosity", json());
        const std::filesystem::path state = record::stage_folder(folder, *stage.variant, *stage.stage) / "state.h5";
        rows.push_back(water_row(
            study::in_words_of_sample(stage),
            {along, stage.numbers.at("porosity"), tortuosity.is_number() ? tortuosity.get<double>() : 0},
            radii_in(state), fluid
        ));
        if (stage.numbers.contains("resolved")) {
            const json& resolved = stage.numbers["resolved"];
            rows.push_back(water_row(
                study::in_words_of_sample(stage) + ", resolved",
                {along_flow(resolved), stage.numbers.at("porosity"), 0}, radii_in(state), fluid
            ));
        }
    }
}

void add_passes(
    const std::filesystem::path& folder, const study::ErosionStory& story, const flow::Fluid& fluid,
    std::vector<std::vector<std::string>>& rows
) {
    if (story.eroded == nullptr || story.eroded->stage->parent < 0) {
        return;
    }
    const casefile::Variant& variant = *story.eroded->variant;
    const casefile::Stage& parent = variant.stages[static_cast<std::size_t>(story.eroded->stage->parent)];
    const auto& passes = story.erosion.passes;
    for (std::size_t k = 0; k < passes.size(); ++k) {
        const study::StagePass& made = story.made_in[k];
        const std::filesystem::path place = record::stage_folder(folder, variant, *made.stage->stage);
        const std::filesystem::path after = made.is_last ? place / "state.h5" : record::pass_file(place, made.number);
        if (k == 0 && passes[k].permeability_before > 0) {
            rows.push_back(water_row(
                "before erosion",
                {passes[k].permeability_before, passes[k].porosity_before, passes[k].tortuosity_before},
                radii_in(record::stage_folder(folder, variant, parent) / "state.h5"), fluid
            ));
        }
        if (passes[k].permeability_after > 0) {
            rows.push_back(water_row(
                fmt::format("after pass {}", passes[k].pass),
                {passes[k].permeability_after, passes[k].porosity_after, passes[k].tortuosity_after}, radii_in(after),
                fluid
            ));
        }
    }
}

/// A row of the table on removal, from a pass, or from a whole stage with its last pass.
std::vector<std::string>
removal_row(const std::string& name, const json& whole, const json& pass, double mass_percent, double strain) {
    std::int64_t grains = 0, contacts = 0;
    for (const auto& [number, count] : whole.at("coordination_histogram").items()) {
        grains += count.get<std::int64_t>();
        contacts += std::stoll(number) * count.get<std::int64_t>();
    }
    const double mean = grains > 0 ? static_cast<double>(contacts) / static_cast<double>(grains) : 0;
    return {
        name,
        fmt::format("{}", pass.at("pass").get<int>()),
        grouped(grains),
        fmt::format("{:.2f}", mass_percent),
        fmt::format("{:.2f}", mean),
        percent_beyond_noise(100 * pass.at("stress_loss").get<double>()),
        percent_beyond_noise(100 * strain),
        fmt::format("{:.4f}", pass.at("porosity_after").get<double>())};
}

} // namespace

double kozeny_carman(const std::vector<double>& radius, double porosity) {
    const double d = flow::sauter_diameter(radius), solid = 1 - porosity;
    return porosity * porosity * porosity * d * d / (180 * solid * solid);
}

std::optional<figures::PageTable> tabulate_removals(const std::vector<record::FinishedStage>& stages) {
    constexpr std::size_t most_rows = 60;
    std::vector<std::vector<std::string>> by_pass, by_stage;
    for (const record::FinishedStage& stage : stages) {
        const auto* spec = std::get_if<erosion::RemoveSpec>(&stage.stage->spec);
        if (spec == nullptr || spec->takes_all_fines_at_once() || !stage.numbers.contains("passes")) {
            continue;
        }
        const std::string name = study::in_words_of_sample(stage);
        double mass = 0;
        for (const json& pass : stage.numbers.at("passes")) {
            mass += pass.at("eroded_mass_percent_of_initial").get<double>();
            by_pass.push_back(removal_row(name, pass, pass, mass, pass.at("volumetric_strain")));
        }
        by_stage.push_back(removal_row(
            name, stage.numbers, stage.numbers.at("passes").back(), mass, stage.numbers.at("volumetric_strain")
        ));
    }
    if (by_stage.empty()) {
        return std::nullopt;
    }
    figures::PageTable table;
    table.section = "Tests";
    table.title = "Fines taken out without water";
    table.note =
        "Mass removed so far is of the mass before the first pass; contacts are those of the grains that went. The "
        "loss of mean stress is at constant volume, the strain under the stresses held before, contraction positive.";
    table.header = {
        "stage",
        by_pass.size() <= most_rows ? "pass" : "passes",
        "grains",
        "mass removed so far [%]",
        "contacts a grain [-]",
        "loss of mean stress [%]",
        facts::short_title("volumetric_strain"),
        "porosity after [-]"};
    table.numeric.assign(table.header.size(), true);
    table.numeric[0] = false;
    table.rows = by_pass.size() <= most_rows ? std::move(by_pass) : std::move(by_stage);
    return table;
}

std::optional<figures::PageTable> tabulate_water(
    const std::filesystem::path& folder, const std::vector<record::FinishedStage>& stages,
    const study::ErosionStory& story, const flow::Fluid& fluid
) {
    figures::PageTable table;
    table.section = "Water";
    table.title = "Permeability";
    const char* const above =
        fluid.conductance == flow::Conductance::Bounded
            ? "The pore network is above it by 6 to 7 % for equal spheres. "
            : "The pore network by Yade's law is above it, by 13 % at n = 0.365 and 50 % at n = 0.48 for equal "
              "spheres: a ratio of two states' permeabilities carries the difference. ";
    table.note = fmt::format(
        "From the slow flow through the pores, along the gradient; also as a conductivity K = k ρ g/μ of this fluid. "
        "For comparison: Kozeny and Carman's for spheres of the sample's Sauter diameter d, k = n³ d²/(180 (1 − n)²). "
        "{}\"Resolved\" is the flow between the grains themselves, on a grid. Tortuosity: the mean speed of the water "
        "from pore to pore over that of its mean motion.",
        above
    );
    table.header = {
        "state",
        facts::title("porosity"),
        facts::title("permeability"),
        "conductivity K [m/s]",
        "k by Kozeny and Carman [m²]",
        "ratio [-]",
        facts::title("tortuosity")};
    table.numeric = {false, true, true, true, true, true, true};
    add_flows(folder, stages, fluid, table.rows);
    add_passes(folder, story, fluid, table.rows);
    return table.rows.empty() ? std::nullopt : std::optional(std::move(table));
}

} // namespace suffuse::answer
