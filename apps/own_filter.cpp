#include "apps/own_filter.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/units.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/packing/stack.hpp"

#include <fmt/format.h>

#include "apps/own_case_parts.hpp"
#include <algorithm>
#include <cmath>

namespace suffuse::apps {
namespace {

constexpr double across = 3.1;           ///< largest grains across the stack
constexpr double base_depth = 5;         ///< largest base grains along the base, of which a screen takes the first
constexpr double filter_depth = 4;       ///< largest grains along the filter
constexpr double stack_tolerance = 0.10; ///< of percent passing: a stack has few filter grains
constexpr double rough = 0.5; ///< median filter grains that the base is thick at least: its face is that rough

constexpr std::string_view stack_case_form =
    R"(# Does {filter} hold {base}? The base is packed on its filter, and water takes it there.
# `#~` marks assumed values; the report lists them on its first page. Two of these values are those of your
# site: the `pressure` on the soils and the `gradients` of the water in the base.
# What a key means: suffuse explain KEY.
schema = 1
title  = "{base} on {filter}"
seed   = 1
preset = "quick"                      # quick: short holds | standard: as written below; --preset NAME picks one

[presets.quick]
hold_at_most = "200 ms"               #~ the results say where motion had not ended

{material}
[gravity]                             # the water goes along z, {way}
down = {down}

[balance]
unbalanced_force = 3e-3               #~ enough for a base that is about to move

[soil.{base}]
psd               = "data/{base}.csv"
{base_sizes}grading_tolerance = "{tolerance:.0f} %"           #~

[soil.{filter}]
psd               = "data/{filter}.csv"
{filter_sizes}grading_tolerance = "{tolerance:.0f} %"           #~

[[study.filter.stage]]
name   = "cloud"
do     = "pack"                       # {base_grains} grains of the base, {filter_grains} of the filter
layers = [{{ soil = "{base}", thickness = "{base_thickness:.4g} mm" }}, {{ soil = "{filter}", thickness = "{filter_thickness:.4g} mm" }}]
width  = "{width:.4g} mm"             #~ three of the largest grains: as few as possible

[[study.filter.stage]]
name     = "initial"
do       = "compact"
pressure = {pressure:<27}{pressure_mark} the effective stress
protocol = "wide"

[[study.filter.stage]]
name         = "flow"
do           = "migrate"
gradients    = {gradient:<23}{gradient_mark} the hydraulic gradient in the base
hold_at_most = "2 s"                  #~ real tests hold a gradient for minutes
direction    = "z"
)";

grains::Soil soil_of(const grains::Grading& curve) {
    grains::Soil soil;
    soil.whole = curve;
    soil.grading_tolerance = stack_tolerance;
    return soil;
}

std::size_t draw(const std::string& name, const grains::Grading& curve, double solid) {
    try {
        return packing::sample_layer(soil_of(curve), solid).grains.radius.size();
    } catch (const CaseError& problem) {
        throw CaseError(
            fmt::format("--filter: a stack of a few grains cannot follow the curve of {}: {}", name, problem.what())
        );
    }
}

std::string millimeters(double length) {
    return fmt::format("{:.3g} mm", 1e3 * length);
}

} // namespace

OwnStack model_own_stack(
    const grains::Grading& base, const std::string& base_name, const grains::Grading& filter,
    const std::string& filter_name, const std::string& words
) {
    OwnStack stack;
    stack.base = soil_name(base_name);
    stack.filter = soil_name(filter_name);
    if (stack.base == stack.filter) {
        stack.filter += "-filter";
    }
    stack.base_curve = measured_part(base, base_name);
    stack.filter_curve = measured_part(filter, filter_name);
    stack.base_left_out = left_out_of(base, base.diameter.front(), base.diameter.back());
    stack.filter_left_out = left_out_of(filter, filter.diameter.front(), filter.diameter.back());
    const double fine = grains::size_at(stack.base_curve, 0.5), coarse = grains::size_at(stack.filter_curve, 0.5);
    if (coarse <= fine) {
        throw CaseError(fmt::format(
            "--filter: {} (D50 = {}) is not coarser than its base {} (D50 = {}) and holds all of it; exchange the two "
            "files if the flow goes the other way",
            stack.filter, millimeters(coarse), stack.base, millimeters(fine)
        ));
    }
    const double largest = grains::size_at(stack.filter_curve, 1), base_grain = grains::size_at(stack.base_curve, 1);
    stack.width = across * std::max(largest, base_grain);
    stack.filter_thickness = filter_depth * largest;
    stack.base_thickness = std::max(base_depth * base_grain, rough * coarse);
    const packing::Layer layer{stack.base, stack.base_thickness};
    const double solid = packing::solid_of(layer, stack.width);
    const double count = solid * grains::grains_per_volume(stack.base_curve);
    if (count > most_stack_grains) {
        throw CaseError(fmt::format(
            "--filter: the thinnest layer of {} on this filter has about {:.2g} grains, more than {:.0f}: give a base "
            "without its finest sizes, or a filter without its coarsest; suffuse assess {} judges the curves as they "
            "are",
            stack.base, count, most_stack_grains, words
        ));
    }
    stack.base_grains = draw(stack.base, stack.base_curve, solid);
    stack.filter_grains =
        draw(stack.filter, stack.filter_curve, packing::solid_of({stack.filter, stack.filter_thickness}, stack.width));
    return stack;
}

std::string own_case_text(const OwnStack& stack, const OwnConditions& conditions) {
    const FlowWay way = conditions.flow.value_or(stability::downward);
    const double rise = stability::lift_of(way), ahead = std::sqrt(std::max(0.0, 1 - rise * rise));
    const double pressure = conditions.pressure.value_or(assumed_pressure);
    const double finest = stack.base_curve.diameter.front();
    return fmt::format(
        stack_case_form, fmt::arg("base", stack.base), fmt::arg("filter", stack.filter),
        fmt::arg("material", material_text(grains::size_at(stack.filter_curve, 1) / finest, pressure)),
        fmt::arg("way", stability::kind_of(way)),
        fmt::arg("down", fmt::format("[{:.4f}, 0, {:.4f}]", 0 - ahead, 0 - rise)),
        fmt::arg("base_sizes", sizes_line(stack.base_curve, stack.base_left_out)),
        fmt::arg("filter_sizes", sizes_line(stack.filter_curve, stack.filter_left_out)),
        fmt::arg("tolerance", 100 * stack_tolerance), fmt::arg("base_grains", stack.base_grains),
        fmt::arg("filter_grains", stack.filter_grains), fmt::arg("base_thickness", 1e3 * stack.base_thickness),
        fmt::arg("filter_thickness", 1e3 * stack.filter_thickness), fmt::arg("width", 1e3 * stack.width),
        fmt::arg("pressure", '"' + print_quantity(pressure, dimension::pressure) + '"'),
        fmt::arg("pressure_mark", site_mark(conditions.pressure)),
        fmt::arg("gradient", fmt::format("[{:g}]", conditions.gradient.value_or(assumed_base_gradient))),
        fmt::arg("gradient_mark", site_mark(conditions.gradient))
    );
}

} // namespace suffuse::apps
