#pragma once
// The state at the end of a stage.

#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/facts/fact.hpp"
#include "suffuse/stats/backbone.hpp"
#include "suffuse/stats/coordination.hpp"
#include "suffuse/stats/fabric.hpp"
#include "suffuse/stats/fines.hpp"
#include "suffuse/stats/stress_by_fraction.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <string>

namespace suffuse::facts {

/// What the facts of any state are read from.
struct State {
    const dem::World& world;
    dem::Equilibrium balance = dem::measure_equilibrium(world);
    Mat3 stress = dem::mean_stress_tensor(world);
    stats::Coordination coordination = stats::measure_coordination(world);
    stats::Backbone backbone = stats::measure_backbone(world, stats::least_contacts(world.material));
};

/// Those of a state whose grains touch.
struct Network {
    const dem::World& world;
    stats::Fabric fabric = stats::measure_fabric(world);
    stats::ForceDistribution forces = stats::measure_forces(world);
};

inline std::optional<double> anisotropy(const stats::Fabric& fabric, Mat3 stats::ForceAnisotropy::*of) {
    return fabric.force_anisotropy ? std::optional(stats::deviator_of((*fabric.force_anisotropy).*of)) : std::nullopt;
}

/// Those of a soil with a fine fraction. What does not exist in this sample is nothing, not zero.
struct Fines {
    const dem::World& world;
    const stats::Coordination& coordination;
    stats::FinesState state = stats::measure_fines(world);
    stats::StressByFraction stress = stats::measure_stress_by_fraction(world);

    [[nodiscard]] std::optional<double> if_fine(double value) const {
        return state.fines_content > 0 ? std::optional(value) : std::nullopt;
    }

    [[nodiscard]] std::optional<double> if_coarse(double value) const {
        return state.fines_content < 1 ? std::optional(value) : std::nullopt;
    }
};

inline std::map<std::string, double> shares_by_name(const stats::PerClass<double>& share) {
    return {{"LL", share.large_large}, {"LS", share.large_small}, {"SS", share.small_small}};
}

inline constexpr std::tuple state{
    row<[](const State& s) { return s.world.grains.size(); }>("grains", "-", "number of grains"),
    row<[](const State& s) { return s.balance.contacts; }>("contacts", "-", "number of contacts that touch"),
    row<[](const State& s) { return s.world.cell.h; }>("cell", "m", "3 × 3, rows; the columns are the cell vectors"),
    row<[](const State& s) { return s.stress; }>("stress", "Pa", "3 × 3, mean over the cell"),
    row<[](const State& s) { return dem::mean_stress(s.stress); }>("mean_stress", "Pa", "p")
        .as(Shown{"mean stress", "p", "kPa"}),
    row<[](const State& s) { return dem::deviator_stress(s.stress); }>(
        "deviator_stress", "Pa", "√(3 J₂) of the full tensor"
    )
        .as(Shown{"deviator stress", "q", "kPa"}),
    row<[](const State& s) { return dem::void_ratio(s.world); }>("void_ratio", "-", "e, voids over solid")
        .as(Shown{"void ratio", "e", "-"}),
    row<[](const State& s) { return dem::porosity(s.world); }>("porosity", "-", "n, voids over all")
        .as(Shown{"porosity", "n", "-"}),
    row<[](const State& s) { return s.coordination.mean; }>("coordination", "-", "contacts a grain, 2 Nc/N")
        .as(Shown{"coordination", "Z", "-"}),
    row<[](const State& s) { return s.coordination.mechanical; }>(
        "mechanical_coordination", "-", "the same without rattlers"
    ),
    row<[](const State& s) { return s.backbone.coordination; }>(
        "backbone_coordination", "-",
        "contacts a grain when grains that contacts cannot hold are taken off again and again "
        "([measures](theory/measures.md))"
    ),
    row<[](const State& s) { return s.balance.rattlers; }>("rattlers", "-", "grains with fewer than 2 contacts"),
    row<[](const State& s) { return s.backbone.rattlers; }>("backbone_rattlers", "-", "grains taken off so"),
    row<[](const State& s) { return stats::stiffness_to_pressure(s.world); }>(
        "stiffness_to_pressure", "-", "k_n/(p d) of two equal grains"
    ),
    row<[](const State& s) { return s.balance.unbalanced_force; }>(
        "unbalanced_force", "-",
        "mean resultant over grains with at least 2 contacts / mean contact force, normal and shear"
    )
        .as(Kind::Computation)
        .as(Shown{"unbalanced force", "", "-", 2}),
    row<[](const State& s) { return s.balance.unbalanced_force_all; }>(
        "unbalanced_force_yade", "-", "mean resultant over all grains / mean contact force"
    )
        .as(Kind::Computation),
    row<[](const State& s) { return s.balance.max_overlap_ratio; }>(
        "max_overlap_ratio", "-", "largest overlap / smaller radius"
    ),
    row<[](const State& s) { return s.balance.kinetic_energy; }>(
        "kinetic_energy", "J", "translation and rotation, relative to the mean motion"
    )
        .as(Kind::Computation),
    row<[](const State& s) { return fmt::format("{:016x}", dem::state_hash(s.world)); }>(
        "state_hash", "",
        "16 hexadecimal digits, of what steps change: cell, servo, step number, motion of the grains, memory of the "
        "contacts; and of the grains' ids, radii and holds; not of material and masses. The same for any number of "
        "threads and any storage order"
    )
        .as(Kind::Origin),
};

/// Where grains touch.
inline constexpr std::tuple network{
    row<[](const Network& n) { return n.fabric.deviator; }>(
        "fabric.deviator", "-", "√(3/2 a:a) of the fabric tensor's deviator"
    ),
    row<[](const Network& n) { return stats::deviator_of(n.fabric.contact_anisotropy); }>(
        "fabric.contact_anisotropy", "-", "the same of the anisotropy of contacts"
    ),
    row<[](const Network& n) { return anisotropy(n.fabric, &stats::ForceAnisotropy::normal); }>(
        "fabric.normal_force_anisotropy", "-",
        "of that of normal forces; null where contacts point too little to some side for it"
    ),
    row<[](const Network& n) { return anisotropy(n.fabric, &stats::ForceAnisotropy::shear); }>(
        "fabric.shear_force_anisotropy", "-", "of that of shear forces, likewise"
    ),
    row<[](const Network& n) { return n.forces.mean_normal_force; }>(
        "force_distribution.mean_normal_force", "N", "mean normal force of a contact"
    ),
    row<[](const Network& n) { return n.forces.mean_force; }>(
        "force_distribution.mean_force", "N", "normal and shear together"
    ),
    row<[](const Network& n) { return n.forces.variation; }>(
        "force_distribution.variation", "-", "standard deviation of the normal force / its mean"
    ),
    row<[](const Network& n) { return n.forces.median_ratio; }>(
        "force_distribution.median_ratio", "-", "median normal force / mean"
    ),
    row<[](const Network& n) { return n.forces.p90_ratio; }>(
        "force_distribution.p90_ratio", "-", "nine tenths of the contacts carry less / mean"
    ),
    row<[](const Network& n) { return n.forces.max_ratio; }>("force_distribution.max_ratio", "-", "largest / mean"),
    row<[](const Network& n) { return n.forces.strong_share; }>(
        "force_distribution.strong_share", "-", "share of the contacts with more than the mean normal force"
    ),
    row<[](const Network& n) { return n.forces.strong_pressure_share; }>(
        "force_distribution.strong_pressure_share", "-", "share of the mean stress that they carry"
    ),
    row<[](const Network& n) { return n.forces.sliding_share; }>(
        "force_distribution.sliding_share", "-", "share of the contacts at the limit of friction"
    ),
};

/// Soils with a fine fraction.
inline constexpr std::tuple fines{
    row<[](const Fines& f) { return f.state.fines_content; }>("fines_content", "-", "FC, by mass"),
    row<[](const Fines& f) { return f.if_coarse(f.state.intergranular_void_ratio); }>(
        "intergranular_void_ratio", "-", "e_g: fines count as voids"
    ),
    row<[](const Fines& f) { return f.state.equivalent_void_ratio; }>(
        "equivalent_void_ratio", "-", "e_eq: inactive fines count as voids"
    ),
    row<[](const Fines& f) { return f.if_fine(f.state.active_fraction); }>(
        "active_fines_fraction", "-", "b: volume of fines with at least 2 contacts / volume of fines"
    ),
    row<[](const Fines& f) { return shares_by_name(f.state.contact_share); }>(
        "contact_share", "-", "`LL`, `LS`, `SS`: shares of the number of contacts, between large and small grains"
    ),
    row<[](const Fines& f) { return shares_by_name(f.state.strong_contact_share); }>(
        "strong_contact_share", "-", "`LL`, `LS`, `SS`: of the contacts whose force exceeds the mean over all contacts"
    ),
    row<[](const Fines& f) { return f.if_coarse(f.coordination.coarse_coarse); }>(
        "coordination_by_class.coarse_coarse", "-", "contacts with coarse grains, per coarse grain"
    ),
    row<[](const Fines& f) { return f.if_coarse(f.coordination.coarse_fine); }>(
        "coordination_by_class.coarse_fine", "-", "contacts with fine grains, per coarse grain"
    ),
    row<[](const Fines& f) { return f.if_fine(f.coordination.fine_coarse); }>(
        "coordination_by_class.fine_coarse", "-", "contacts with coarse grains, per fine grain"
    ),
    row<[](const Fines& f) { return f.if_fine(f.coordination.fine_fine); }>(
        "coordination_by_class.fine_fine", "-", "contacts with fine grains, per fine grain"
    ),
    row<[](const Fines& f) { return f.stress.fines_share; }>(
        "fines_stress_share", "-",
        "part of the mean stress that the fines carry, `fines_content` · `alpha_fines`; not α"
    ),
    row<[](const Fines& f) { return f.if_fine(f.stress.alpha_fines); }>(
        "alpha_fines", "-",
        "α: mean effective stress in the fines over that of the soil "
        "([measures](theory/measures.md#stress-of-the-fines-statsstress_by_fractioncpp))"
    ),
    row<[](const Fines& f) { return f.if_coarse(f.stress.alpha_coarse); }>(
        "alpha_coarse", "-", "the same of the coarse grains"
    ),
};

} // namespace suffuse::facts
