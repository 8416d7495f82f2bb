#include "suffuse/stats/fines.hpp"

#include "suffuse/dem/inspect.hpp"
#include "suffuse/stats/coordination.hpp"

#include <limits>
#include <vector>

namespace suffuse::stats {
namespace {

/// Void ratio when the share `lost` of the solid counts as voids.
double void_ratio_without(double void_ratio, double lost) {
    return lost < 1 ? (void_ratio + lost) / (1 - lost) : std::numeric_limits<double>::infinity();
}

PerClass<double> shares(const PerClass<double>& count) {
    const double total = count.total();
    if (total == 0) {
        return {};
    }
    return {count.large_large / total, count.large_small / total, count.small_small / total};
}

} // namespace

FinesState measure_fines(const dem::World& world) {
    const grains::Grains& grains = world.grains;
    const std::vector<int> contacts = dem::coordination(world);
    double solid = 0, fines = 0, active = 0;
    for (std::size_t g = 0; g < grains.size(); ++g) {
        const double volume = sphere_volume(grains.radius[g]);
        solid += volume;
        if (grains.fine[g] != 0) {
            fines += volume;
            active += contacts[g] >= active_contacts ? volume : 0;
        }
    }
    FinesState state;
    state.void_ratio = dem::void_ratio(world);
    state.fines_content = solid > 0 ? fines / solid : 0;
    state.active_fraction = fines > 0 ? active / fines : 0;
    state.intergranular_void_ratio = void_ratio_without(state.void_ratio, state.fines_content);
    state.equivalent_void_ratio =
        void_ratio_without(state.void_ratio, (1 - state.active_fraction) * state.fines_content);

    const std::vector<dem::ContactView> views = dem::inspect_contacts(world);
    double mean_force = 0;
    for (const dem::ContactView& c : views) {
        mean_force += norm(c.normal_force + c.shear_force) / static_cast<double>(views.size());
    }
    PerClass<double> all, strong;
    for (const dem::ContactView& c : views) {
        const ContactClass kind = class_of(grains, c.i, c.j);
        all[kind] += 1;
        strong[kind] += norm(c.normal_force + c.shear_force) > mean_force ? 1 : 0;
    }
    state.contact_share = shares(all);
    state.strong_contact_share = shares(strong);
    return state;
}

} // namespace suffuse::stats
