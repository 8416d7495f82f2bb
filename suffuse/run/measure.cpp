#include "suffuse/run/measure.hpp"

#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/run/result_json.hpp"
#include "suffuse/stats/backbone.hpp"
#include "suffuse/stats/coordination.hpp"
#include "suffuse/stats/fines.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::run {
namespace {

void add_fines(const dem::World& world, nlohmann::json& numbers) {
    const auto fines = std::count(world.grains.fine.begin(), world.grains.fine.end(), std::uint8_t{1});
    if (fines == 0 || fines == static_cast<std::ptrdiff_t>(world.grains.size())) {
        return;
    }
    const stats::FinesState state = stats::measure_fines(world);
    numbers["fines_content"] = state.fines_content;
    numbers["intergranular_void_ratio"] = state.intergranular_void_ratio;
    numbers["equivalent_void_ratio"] = state.equivalent_void_ratio;
    numbers["active_fines_fraction"] = state.active_fraction;
    const auto shares = [](const stats::PerClass<double>& share) {
        return nlohmann::json{{"LL", share.large_large}, {"LS", share.large_small}, {"SS", share.small_small}};
    };
    numbers["contact_share"] = shares(state.contact_share);
    numbers["strong_contact_share"] = shares(state.strong_contact_share);
}

} // namespace

nlohmann::json measure_state(const dem::World& world) {
    const dem::Equilibrium balance = dem::measure_equilibrium(world);
    const Mat3 stress = dem::mean_stress_tensor(world);
    const stats::Coordination coordination = stats::measure_coordination(world);
    const stats::Backbone backbone = stats::measure_backbone(world, stats::least_contacts(world.material));
    nlohmann::json numbers{
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
        {"state_hash", fmt::format("{:016x}", dem::state_hash(world))},
    };
    add_fines(world, numbers);
    return numbers;
}

} // namespace suffuse::run
