// The text of a case for a soil of the user's.

#include "suffuse/base/spelling.hpp"
#include "suffuse/base/units.hpp"

#include <fmt/format.h>

#include "apps/own_case_parts.hpp"
#include "apps/own_soil.hpp"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>

namespace suffuse::apps {
namespace {

constexpr std::string_view case_form =
    R"(# Suffusion of {name}: a sample is packed from its grading, compacted, eroded, and sheared before and after.
# `#~` marks assumed values; the report lists them on its first page. Two of these values are those of your
# site: the `pressure` on the soil and the `gradient` of the water. {weight_note}
# What a key means: suffuse explain KEY.
schema = 1
title  = "Suffusion of {name}"
seed   = 1
preset = "quick"                      # quick: few grains | standard: as written below; --preset NAME picks one

[presets.quick]
particles       = {quick:<20}{quick_mark}
inertial_number = "loose"             #~ 1e-3 while shearing
triaxial_strain = "5 %"               #~

{material}{gravity}
[soil.{name}]
psd   = "data/{name}.csv"             # d [mm], passing [%]
{sizes}fines = {{ finer_than = "{limit:.4g} mm" }} #~ {content}; {reason}

[study.erosion]
soil      = "{name}"
particles = {standard:<26}#~ cost grows with it; suffuse plan shows how much

[[study.erosion.stage]]
name     = "cloud"
do       = "pack"                     # no overlaps, periodic cell
porosity = 0.65                       #~

[[study.erosion.stage]]
name     = "initial"
do       = "compact"
pressure = {pressure:<27}{pressure_mark} the effective stress, which decides the strength
prepare  = {{ friction = "10 deg" }}    #~ during compaction only: lower is denser
measure  = ["void-ratios", "porosity", "permeability"]

{mobility}[[study.erosion.stage]]
name      = "erosion"
do        = "erode"
gradient  = {gradient:<26}{gradient_mark} the hydraulic gradient i of the seepage
direction = {direction}
passes    = 2                         #~ each removes the grains that are free to move, then lets the soil settle
measure   = ["flow", "constrictions", "coordination-of-eroded", "stress", "volumetric-strain", "porosity", "grading"]

[[study.erosion.stage]]               # strength with its fines, and without those that left
name    = "shear-before"
from    = "initial"
do      = "triaxial"                  # drained: lateral stress held
strain  = "10 %"                      #~
measure = ["stress-strain"]

[[study.erosion.stage]]
name    = "shear-after"
from    = "erosion"
do      = "triaxial"
strain  = "10 %"                      #~
measure = ["stress-strain"]
)";

constexpr std::string_view mobility_form =
    R"([[study.erosion.stage]]               # which gradient moves the fines against their weight; nothing is removed
name           = "mobility"
do             = "detach"
gradients      = {{ up_to = {last:g}, steps = 24 }} #~ borne one after the other
asked_gradient = {gradient:<21}{gradient_mark} what the soil has to bear: the factor of safety is against it
direction      = {direction}

)";

/// The stage that finds which gradient moves the fines; nothing where they have no weight.
std::string mobility_stage(const OwnConditions& conditions, std::string_view gradient_mark) {
    constexpr double usual_last = 1.2, beyond_specified = 1.5;
    if (!conditions.flow) {
        return "";
    }
    const double specified = conditions.gradient.value_or(assumed_gradient);
    return fmt::format(
        mobility_form, fmt::arg("last", std::max(usual_last, beyond_specified * specified)),
        fmt::arg("gradient", specified), fmt::arg("gradient_mark", gradient_mark),
        fmt::arg("direction", direction_text(conditions.flow))
    );
}

std::string_view weight_note(const std::optional<FlowWay>& flow) {
    return flow ? "Fines have weight here: the report begins with the\n# gradient that moves them."
                : "(Grains have no weight here: fines that carry no load\n# leave under any gradient; suffuse new "
                  "--flow level gives them weight.)";
}

} // namespace

std::string own_case_text(const OwnSoil& soil, const OwnConditions& conditions) {
    constexpr std::int64_t standard_over_quick = 4;
    const double pressure = conditions.pressure.value_or(assumed_pressure);
    const std::string_view few = "#~ as few as possible: a cell of four largest grains, enough fines and coarse grains";
    return fmt::format(
        case_form, fmt::arg("name", soil.name), fmt::arg("quick", soil.quick_grains),
        fmt::arg("quick_mark", soil.is_size_given ? "# as specified" : few),
        fmt::arg("standard", standard_over_quick * soil.quick_grains), fmt::arg("limit", 1e3 * soil.finer_than),
        fmt::arg("content", fines_text(soil)), fmt::arg("reason", soil.reason),
        fmt::arg("pressure", '"' + print_quantity(pressure, dimension::pressure) + '"'),
        fmt::arg("pressure_mark", site_mark(conditions.pressure)),
        fmt::arg("gradient", conditions.gradient.value_or(assumed_gradient)),
        fmt::arg("gradient_mark", site_mark(conditions.gradient)),
        fmt::arg("material", material_text(soil.grading.diameter.back() / soil.grading.diameter.front(), pressure)),
        fmt::arg("sizes", sizes_line(soil.grading, soil.left_out)),
        fmt::arg("weight_note", weight_note(conditions.flow)),
        fmt::arg("gravity", conditions.flow ? gravity_text : std::string_view()),
        fmt::arg("mobility", mobility_stage(conditions, site_mark(conditions.gradient))),
        fmt::arg("direction", direction_text(conditions.flow))
    );
}

std::string own_grading_text(const grains::Grading& measured, const std::string& path) {
    std::string text =
        fmt::format("# {}: percent passing by mass.\n", shown(std::filesystem::path(path).filename().string()));
    text += "d [mm],passing [%]\n";
    for (std::size_t k = 0; k < measured.diameter.size(); ++k) {
        text += fmt::format("{:.10g},{:.10g}\n", 1e3 * measured.diameter[k], 100 * measured.passing[k]);
    }
    return text;
}

} // namespace suffuse::apps
