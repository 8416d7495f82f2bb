// The text of a case for a surrogate of the user's soil.

#include "suffuse/base/units.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/erosion/refined_ramp.hpp"
#include "suffuse/grains/surrogate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/own_case_parts.hpp"
#include "apps/own_surrogate.hpp"
#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace suffuse::apps {
namespace {

constexpr std::string_view surrogate_form =
    R"(# Which gradients move the fines of {name}? The soil is too wide to simulate. Two fractions stand for it:
# a surrogate, with its fines content and {ratio_note}
# `#~` marks assumed values; the report lists them on its first page.
# What a key means: suffuse explain KEY.
schema = 1
title  = "Gradients that move the fines of {name}, by a surrogate"
seed   = 1
preset = "quick"                      # quick: one sample | standard: as written below; --preset NAME picks one

[presets.quick]
replicates = 1                        #~ one sample does not show how much samples differ

{material}{gravity}
[soil.{name}]
psd               = "data/{name}.csv" # d [mm], passing [%]: the soil itself
surrogate         = {{ finer_than = "{limit:.6g} mm" }} #~ {content:.3g} % of the mass; {reason}
grading_tolerance = "4 %"             # few coarse grains follow the curve less closely

[study.surrogate]
soil        = "{name}"
replicates  = 3                       #~
sample_size = {{ coarse_grains = {coarse}, cell_width = 10, at_least = 1_500 }} #~ whichever takes fewer grains
{sweep}
[[study.surrogate.stage]]
name     = "cloud"
do       = "pack"                     # no overlaps, periodic cell
porosity = 0.65                       #~

[[study.surrogate.stage]]
name     = "initial"
do       = "compact"
pressure = {pressure:<27}{pressure_mark} the skeleton is held, so stress has little effect
{protocol}prepare  = {{ friction = "10 deg" }}    #~ during compaction only: lower is denser, and density matters
{stages})";

constexpr std::string_view stage_form = R"(
[[study.surrogate.stage]]
name      = "{name}"
from      = "initial"
do        = "detach"                  # which gradient moves the fines against their weight; nothing is removed
gradients = {{ up_to = {last:g}, steps = {steps} }} #~ borne one after the other
direction = {direction}
{specified})";

std::string stage_text(const FlowWay& way, const OwnConditions& conditions) {
    constexpr double usual_last = 1.2, beyond_specified = 1.5;
    const std::optional<double>& gradient = conditions.gradient;
    const double last = std::max(usual_last, beyond_specified * gradient.value_or(0));
    return fmt::format(
        stage_form, fmt::arg("name", stability::kind_of(way)), fmt::arg("last", last),
        fmt::arg("steps", static_cast<int>(std::ceil(last / erosion::widest_step * (1 - 1e-9)))),
        fmt::arg(
            "specified",
            gradient
                ? fmt::format("asked_gradient = {:<21g}# as specified: the factor of safety is against it\n", *gradient)
                : ""
        ),
        fmt::arg("direction", direction_text(way))
    );
}

} // namespace

std::string own_case_text(const OwnSurrogate& own, const OwnConditions& conditions) {
    const grains::Surrogate& surrogate = *own.soil.surrogate;
    const double pressure = conditions.pressure.value_or(assumed_pressure);
    std::string stages;
    const std::vector<FlowWay> ways = conditions.flow ? std::vector{*conditions.flow} // both where none is specified
                                                      : std::vector{stability::level_flow, stability::upward};
    for (const FlowWay& way : ways) {
        stages += stage_text(way, conditions);
    }
    const bool is_wide =
        own.ratios.front() * std::sqrt(surrogate.coarse_width * surrogate.fines_width) >= casefile::wide_grading;
    const std::string of_soil = short_number(surrogate.ratio_of_soil);
    return fmt::format(
        surrogate_form, fmt::arg("name", own.name),
        fmt::arg(
            "ratio_note", own.is_extrapolated() ? fmt::format(
                                                      "size ratios up to {:g}.\n# The soil's ratio D50/d50 of {} would "
                                                      "take too many grains: what happens "
                                                      "there is an extrapolation.",
                                                      own.ratios.back(), of_soil
                                                  )
                                                : fmt::format("its size ratio D50/d50 of {}.", of_soil)
        ),
        fmt::arg(
            "material", material_text(
                            own.soil.coarse->diameter.back() / own.soil.fines->diameter.front(), pressure,
                            casefile::good_squeezed / casefile::strongest_of_wide
                        )
        ),
        fmt::arg("gravity", gravity_text), fmt::arg("limit", 1e3 * surrogate.finer_than),
        fmt::arg("content", 100 * own.soil.fines_content), fmt::arg("reason", own.reason),
        fmt::arg("coarse", own.coarse_grains),
        fmt::arg(
            "protocol",
            is_wide ? "protocol = \"wide\"                     # for fines much smaller than the coarse grains\n" : ""
        ),
        fmt::arg(
            "sweep", own.is_extrapolated()
                         ? fmt::format(
                               "sweep       = {{ size_ratio = [{}] }} #~ up to the largest in reach\n",
                               fmt::join(own.ratios, ", ")
                           )
                         : ""
        ),
        fmt::arg("pressure", '"' + print_quantity(pressure, dimension::pressure) + '"'),
        fmt::arg("pressure_mark", conditions.pressure ? "# as specified:" : "#~"), fmt::arg("stages", stages)
    );
}

} // namespace suffuse::apps
