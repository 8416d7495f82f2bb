#include "suffuse/erosion/extraction.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/order.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace suffuse::erosion {

void extract(
    dem::World& world, std::span<const Leaver> leavers, int pass, const std::string& reason,
    std::vector<LedgerRow>& ledger
) {
    const grains::Grains& grains = world.grains;
    std::vector<std::uint32_t> rows;
    for (const Leaver& leaver : leavers) {
        const std::uint32_t g = leaver.row;
        ledger.push_back({grains.id[g], pass, 2 * grains.radius[g], grains.mass[g], leaver.coordination, reason});
        rows.push_back(g);
    }
    dem::remove_grains(world, rows);
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
