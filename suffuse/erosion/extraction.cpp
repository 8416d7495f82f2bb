#include "suffuse/erosion/extraction.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/order.hpp"

#include <cmath>
#include <iterator>
#include <unordered_set>

namespace suffuse::erosion {

std::vector<LedgerRow> extract(
    dem::World& world, std::span<const std::uint32_t> leaving, std::span<const int> contacts, Reason reason,
    const ErosionResult& so_far, PassResult& pass
) {
    const grains::Grains& grains = world.grains;
    const double before = total_mass(grains);
    std::vector<LedgerRow> ledger = so_far.ledger;
    for (const std::uint32_t g : leaving) {
        ledger.push_back({grains.id[g], pass.pass, 2 * grains.radius[g], grains.mass[g], contacts[g], reason});
        ++pass.coordination_histogram[contacts[g]];
    }
    dem::remove_grains(world, leaving);
    check_ledger(world, ledger, so_far.initial_mass);
    const double left = total_mass(grains);
    pass.removed = std::ssize(leaving);
    pass.eroded_mass_percent = 100 * (1 - left / before);
    pass.eroded_mass_percent_of_initial = 100 * (before - left) / so_far.initial_mass;
    return ledger;
}

double total_mass(const grains::Grains& grains) {
    double mass = 0;
    for (const double m : grains.mass) {
        mass += m;
    }
    return mass;
}

double fines_content(const grains::Grains& grains) {
    double mass = 0;
    for (std::size_t g = 0; g < grains.size(); ++g) {
        mass += grains.fine[g] != 0 ? grains.mass[g] : 0;
    }
    return mass / total_mass(grains);
}

void check_ledger(const dem::World& world, const std::vector<LedgerRow>& ledger, double initial_mass) {
    std::unordered_set<std::uint32_t> seen(world.grains.id.begin(), world.grains.id.end());
    double mass = total_mass(world.grains);
    for (const LedgerRow& row : ledger) {
        expects(seen.insert(row.grain).second, "a grain is in the ledger twice, or there and in the skeleton");
        mass += row.mass;
    }
    // Sums of up to a million masses in different orders differ by their rounding only.
    expects(
        std::abs(mass - initial_mass) <= 1e-10 * initial_mass, "skeleton and ledger do not add up to the initial mass"
    );
}

} // namespace suffuse::erosion
