#include "suffuse/report/quality.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/facts/shown.hpp"
#include "suffuse/report/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::report {

namespace {

constexpr std::size_t most_shown = 40; ///< stages in an open table; more are folded away

std::string number(double value, const char* format) {
    return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : std::string("–");
}

/// The value, and the limit where it is beyond it.
std::string against_limit(const Measured& measured) {
    constexpr double rounding = 1e-12;
    const std::string value =
        measured.value >= 0 && measured.value < rounding ? "exact" : short_number(measured.value, 2);
    return measured.is_beyond() ? "▲ " + value + " (at most " + short_number(measured.limit, 2) + ")" : value;
}

std::string state_table(const std::vector<StageRow>& stages, Numbering& numbering) {
    std::vector<std::vector<std::string>> rows;
    for (const StageRow& stage : stages) {
        rows.push_back(
            {stage.name, grouped(stage.grains), number(stage.void_ratio, "{:.4f}"), number(stage.porosity, "{:.4f}"),
             number(stage.coordination, "{:.3f}"), facts::text_shown("mean_stress", stage.mean_stress),
             facts::text_shown("deviator_stress", stage.deviator_stress), grouped(stage.steps),
             number(stage.seconds, "{:.1f}")}
        );
    }
    std::vector<bool> numeric(9, true);
    numeric[0] = false;
    return html_table(
        {"stage", "grains", facts::title("void_ratio"), facts::title("porosity"), facts::title("coordination"),
         facts::title("mean_stress"), facts::title("deviator_stress"), "steps", "time [s]"},
        rows, numeric, "stages", fmt::format("<b>{} State at the end of each stage.</b>", numbering.next_table())
    );
}

std::string quality_table(const std::vector<StageRow>& stages, Numbering& numbering) {
    std::vector<std::vector<std::string>> rows;
    for (const StageRow& stage : stages) {
        rows.push_back(
            {stage.name, against_limit(stage.unbalanced_force), against_limit(stage.stress_error),
             against_limit(stage.overlap), against_limit(stage.inertial_number), short_number(stage.kinetic_share, 2),
             stage.time_step > 0 ? short_number(stage.time_step, 3) : "–"}
        );
    }
    std::vector<bool> numeric(7, true);
    numeric[0] = false;
    return html_table(
        {"stage", facts::title("unbalanced_force"), "error of the stress [-]", "largest overlap / r [-]",
         "largest inertial number [-]", "kinetic energy / (p V) [-]", "time step [s]"},
        rows, numeric, "stages quality", fmt::format("<b>{} Equilibrium of each stage.</b>", numbering.next_table())
    );
}

/// "unbalanced force 0.001": a limit that any stage has.
void name_limit(
    const std::vector<StageRow>& stages, const char* name, Measured StageRow::*measured, std::vector<std::string>& named
) {
    std::vector<double> limits;
    for (const StageRow& stage : stages) {
        const double limit = (stage.*measured).limit;
        if (std::isfinite(limit) && std::find(limits.begin(), limits.end(), limit) == limits.end()) {
            limits.push_back(limit);
        }
    }
    std::string text;
    for (const double limit : limits) {
        text += (text.empty() ? "" : " or ") + short_number(limit, 2);
    }
    if (!text.empty()) {
        named.push_back(std::string(name) + " " + text);
    }
}

std::string verdict(const std::vector<StageRow>& stages) {
    std::vector<std::string> limits;
    std::size_t beyond = 0;
    for (const auto& [name, measured] :
         {std::pair{"unbalanced force (of stages that settle)", &StageRow::unbalanced_force},
          {"error of the stress (of tests: that is held)", &StageRow::stress_error},
          {"overlap", &StageRow::overlap},
          {"inertial number (of tests)", &StageRow::inertial_number}}) {
        name_limit(stages, name, measured, limits);
        for (const StageRow& stage : stages) {
            beyond += (stage.*measured).is_beyond() ? 1U : 0U;
        }
    }
    if (limits.empty()) {
        return "";
    }
    std::string text = "Limits in force: ";
    for (std::size_t k = 0; k < limits.size(); ++k) {
        text += (k == 0 ? "" : ", ") + limits[k];
    }
    text += beyond == 0
                ? ". All stages keep them."
                : fmt::format(". {} {} beyond its limit, marked ▲.", beyond, beyond == 1 ? "value is" : "values are");
    return "<p>" + escaped(text) + "</p>\n";
}

const char* const conventions =
    "<details><summary>Conventions</summary><p>Compression and contraction are positive. q = σ₁ − σ₃, p = (σ₁ + σ₂ + "
    "σ₃)/3, εᵥ = ε₁ + ε₂ + ε₃. Void ratio e = volume of voids over volume of solids, porosity n = e/(1 + e); e_g "
    "counts all fines as voids, e_eq the inactive ones. Fines content is by mass. A grain is active when it has at "
    "least two contacts. The unbalanced force is the mean resultant over grains with at least two contacts, over the "
    "mean contact force. The inertial number is ε̇ d √(ρ/p), of tests with the axial strain rate, which the case sets, "
    "of other stages with the largest component of the velocity gradient. The hydraulic gradient i is without unit; it "
    "acts as the body force ρ g i.</p></details>\n";

} // namespace

std::string quality_section(const std::vector<StageRow>& stages, Numbering& numbering) {
    std::string tables = quality_table(stages, numbering);
    tables += state_table(stages, numbering);
    if (stages.size() <= most_shown) {
        return verdict(stages) + tables + conventions;
    }
    return verdict(stages) + fmt::format("<details><summary>All {} stages</summary>\n", grouped(std::ssize(stages))) +
           tables + "</details>\n" + conventions;
}

} // namespace suffuse::report
