#include "suffuse/run/measure.hpp"

#include "suffuse/base/units.hpp"
#include "suffuse/casefile/wide_checks.hpp"
#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/record/result_json.hpp"
#include "suffuse/stats/backbone.hpp"
#include "suffuse/stats/coordination.hpp"
#include "suffuse/stats/fabric.hpp"
#include "suffuse/stats/fines.hpp"
#include "suffuse/stats/stress_by_fraction.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::run {
namespace {

using nlohmann::json;

/// What does not exist for this sample is null, not zero.
json number_if(bool exists, double value) {
    return exists ? or_null(value) : json();
}

json shares_json(const stats::PerClass<double>& share) {
    return {{"LL", share.large_large}, {"LS", share.large_small}, {"SS", share.small_small}};
}

void add_fines(const dem::World& world, const stats::Coordination& coordination, json& numbers) {
    const stats::FinesState state = stats::measure_fines(world);
    const stats::StressByFraction stress = stats::measure_stress_by_fraction(world);
    const bool has_fines = state.fines_content > 0, has_coarse = state.fines_content < 1;
    numbers["fines_content"] = state.fines_content;
    numbers["intergranular_void_ratio"] = number_if(has_coarse, state.intergranular_void_ratio);
    numbers["equivalent_void_ratio"] = number_if(true, state.equivalent_void_ratio);
    numbers["active_fines_fraction"] = number_if(has_fines, state.active_fraction);
    numbers["contact_share"] = shares_json(state.contact_share);
    numbers["strong_contact_share"] = shares_json(state.strong_contact_share);
    numbers["coordination_by_class"] = {
        {"coarse_coarse", number_if(has_coarse, coordination.coarse_coarse)},
        {"coarse_fine", number_if(has_coarse, coordination.coarse_fine)},
        {"fine_coarse", number_if(has_fines, coordination.fine_coarse)},
        {"fine_fine", number_if(has_fines, coordination.fine_fine)}};
    numbers["fines_stress_share"] = stress.fines_share;
    numbers["alpha_fines"] = number_if(has_fines, stress.alpha_fines);
    numbers["alpha_coarse"] = number_if(has_coarse, stress.alpha_coarse);
}

void add_network(const dem::World& world, json& numbers) {
    const stats::Fabric fabric = stats::measure_fabric(world);
    const stats::ForceDistribution forces = stats::measure_forces(world);
    numbers["fabric"] = {
        {"deviator", fabric.deviator},
        {"contact_anisotropy", stats::deviator_of(fabric.contact_anisotropy)},
        {"normal_force_anisotropy", stats::deviator_of(fabric.normal_force_anisotropy)},
        {"shear_force_anisotropy", stats::deviator_of(fabric.shear_force_anisotropy)}};
    numbers["force_distribution"] = {
        {"mean_normal_force", forces.mean_normal_force},
        {"mean_force", forces.mean_force},
        {"variation", forces.variation},
        {"median_ratio", forces.median_ratio},
        {"p90_ratio", forces.p90_ratio},
        {"max_ratio", forces.max_ratio},
        {"strong_share", forces.strong_share},
        {"strong_pressure_share", forces.strong_pressure_share},
        {"sliding_share", forces.sliding_share}};
}

} // namespace

std::string words_on_overlap(double ratio, const grains::Material& material, double notable) {
    if (!(ratio > notable)) {
        return "";
    }
    const double modulus = casefile::stiffer_modulus(material, ratio / casefile::good_squeezed);
    return fmt::format(
        "the largest overlap is {:.1f} % of the smaller radius; a contact.modulus of {} keeps it below {:.0f} %, and a "
        "lower pressure makes it smaller",
        100 * ratio, print_quantity(modulus, dimension::pressure), 100 * casefile::good_squeezed
    );
}

std::string words_on_hold(const std::vector<triaxial::PathRow>& rows, triaxial::Path path) {
    const auto error = triaxial::find_hold_error(rows, path);
    if (!error || error->usual <= triaxial::good_hold_error || triaxial::summarize(rows, path).lost_at) {
        return "";
    }
    return fmt::format(
        "the {} stress that the test holds was off by up to {:.2g} % in 19 of 20 rows, by {:.2g} % at most; a "
        "quasi-static test keeps it within {:.0f} % in 19 of 20: take a smaller inertial_number, or more grains",
        path == triaxial::Path::Drained ? "lateral" : "mean", 100 * error->usual, 100 * error->most,
        100 * triaxial::good_hold_error
    );
}

json measure_state(const dem::World& world, bool has_fractions) {
    const dem::Equilibrium balance = dem::measure_equilibrium(world);
    const Mat3 stress = dem::mean_stress_tensor(world);
    const stats::Coordination coordination = stats::measure_coordination(world);
    const stats::Backbone backbone = stats::measure_backbone(world, stats::least_contacts(world.material));
    json numbers{
        {"grains", world.grains.size()},
        {"contacts", balance.contacts},
        {"cell", world.cell.h},
        {"stress", stress},
        {"mean_stress", dem::mean_stress(stress)},
        {"deviator_stress", dem::deviator_stress(stress)},
        {"void_ratio", dem::void_ratio(world)},
        {"porosity", dem::porosity(world)},
        {"coordination", coordination.mean},
        {"mechanical_coordination", coordination.mechanical},
        {"backbone_coordination", backbone.coordination},
        {"rattlers", balance.rattlers},
        {"backbone_rattlers", backbone.rattlers},
        {"stiffness_to_pressure", stats::stiffness_to_pressure(world)},
        {"unbalanced_force", balance.unbalanced_force},
        {"unbalanced_force_yade", balance.unbalanced_force_all},
        {"max_overlap_ratio", balance.max_overlap_ratio},
        {"kinetic_energy", balance.kinetic_energy},
        {"state_hash", fmt::format("{:016x}", dem::state_hash(world))},
    };
    if (balance.contacts > 0) {
        add_network(world, numbers);
    }
    const auto fines = std::count(world.grains.fine.begin(), world.grains.fine.end(), std::uint8_t{1});
    const bool has_both = fines > 0 && fines < static_cast<std::ptrdiff_t>(world.grains.size());
    if ((has_fractions || has_both) && !world.grains.id.empty()) {
        add_fines(world, coordination, numbers);
    }
    return numbers;
}

} // namespace suffuse::run
