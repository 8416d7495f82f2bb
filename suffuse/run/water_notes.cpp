#include "suffuse/run/water_notes.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/flow/reynolds.hpp"

#include <fmt/format.h>

#include <cmath>

namespace suffuse::run {
namespace {

/// Below this Yade's law is too permeable by 40 % and more: validation/permeability.md.
constexpr double open_packing = 0.55;

} // namespace

void note_network(
    StageWork& work, const std::string& when, const flow::FlowSource& source, double porosity, bool would_resolve
) {
    if (would_resolve && source.solver == flow::Solver::Network && source.doubt != flow::Doubt::None) {
        work.warnings.push_back(fmt::format(
            "{}: solver \"auto\" would resolve the flow {} ({}), and the cell is sheared: the network's is taken",
            work.place(), when, name_of(source.doubt)
        ));
    }
    if (const std::string words = flow::words_of(source, when); !words.empty()) {
        work.warnings.push_back(fmt::format("{}: {}", work.place(), words));
    }
    const double solid_fraction = 1 - porosity;
    const bool is_yades =
        source.solver == flow::Solver::Network && work.what.fluid.conductance == flow::Conductance::Yade;
    if (is_yades && solid_fraction < open_packing) {
        work.warnings.push_back(fmt::format(
            "{}: the solid fraction {} is {:.3f}: below {} the permeability of conductance = \"yade\" is too high by "
            "40 % and more (validation/permeability.md), and its ratio to a denser state's is too high as well; the "
            "fluid forces still balance the gradient",
            work.place(), when, solid_fraction, open_packing
        ));
    }
}

void note_closed_voids(StageWork& work, const std::string& when, const flow::ClosedVoids& closed) {
    const std::string words = flow::words_of(closed, [](std::uint32_t id) { return std::to_string(id); });
    if (!words.empty()) {
        work.warnings.push_back(fmt::format("{}: {}{}", work.place(), when, words));
    }
}

void note_fast_water(StageWork& work, const std::string& when, double gradient, double reynolds, double porosity) {
    const std::string words = flow::words_of_inertia(when, gradient, reynolds, porosity);
    if (!words.empty()) {
        work.warnings.push_back(fmt::format("{}: {}", work.place(), words));
    }
}

std::string describe_hits(const erosion::ProbeResult& probe) {
    const double travel = erosion::free_travel(probe);
    if (travel <= erosion::far_travel) {
        return "";
    }
    return fmt::format(
        "at i = {} one fine grain in 20 would travel {} of its diameter or more during the probe; above {} fines hit "
        "others before they are judged, and fewer count as detachable the steeper the gradient: take i = {} or less, "
        "or a shorter ramp and watch",
        short_number(probe.gradient), short_number(travel), short_number(erosion::far_travel),
        short_number(std::abs(probe.gradient) * erosion::far_travel / travel)
    );
}

void note_probe(StageWork& work, const erosion::DetachSpec& rule, const erosion::ProbeResult& probe, bool decides) {
    if (probe.reached_floor) {
        work.warnings.push_back(fmt::format(
            "{}: the equilibrium could be relaxed to an unbalanced force of {:.1e} only: double precision, or grains "
            "that creep",
            work.place(), probe.unbalanced_force
        ));
    }
    if (decides && noise_decides(rule, probe)) {
        work.flaws.push_back(fmt::format(
            "{}: {} of {} fines move with the water, but not enough faster than their own twins without: detachment is "
            "undecided; use another seed, more `relax_limit`, or `by = \"displacement\"`",
            work.place(), probe.hidden_by_noise, probe.id.size()
        ));
    }
    if (const std::string words = describe_hits(probe); !words.empty()) {
        work.warnings.push_back(fmt::format("{}: {}", work.place(), words));
    }
    if (probe.beyond_viscous_time && !probe.id.empty()) { // without fines there is no such time
        work.warnings.push_back(fmt::format(
            "{}: ramp and watch last {:.3g} s, longer than the viscous time {:.3g} s of the fines: the constant force "
            "overstates how far they move",
            work.place(), static_cast<double>(probe.ramp + probe.watch) * probe.time_step, probe.viscous_time
        ));
    }
}

} // namespace suffuse::run
