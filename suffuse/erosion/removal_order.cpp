#include "suffuse/erosion/removal_order.hpp"

#include "suffuse/base/random.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/stats/stress_by_fraction.hpp"

#include <algorithm>
#include <tuple>

namespace suffuse::erosion {
namespace {

/// A number for each grain, of which the smallest goes first.
std::vector<double> ranks(const dem::World& world, RemovalOrder order) {
    const std::size_t grains = world.grains.size();
    std::vector<double> rank(grains, 0.0);
    if (order == RemovalOrder::Smallest) {
        std::copy(world.grains.radius.begin(), world.grains.radius.end(), rank.begin());
    } else if (order == RemovalOrder::LeastStressed) {
        const std::vector<Mat3> stress = stats::grain_stresses(world);
        std::transform(stress.begin(), stress.end(), rank.begin(), dem::mean_stress);
    } else if (order == RemovalOrder::FewestContacts) {
        const std::vector<int> contacts = dem::coordination(world);
        std::copy(contacts.begin(), contacts.end(), rank.begin());
    }
    return rank;
}

} // namespace

std::vector<std::uint32_t> put_in_order(const dem::World& world, std::vector<std::uint32_t> rows, RemovalOrder order) {
    const std::vector<double> rank = ranks(world, order);
    std::vector<std::tuple<double, double, std::uint32_t, std::uint32_t>> keys;
    for (const std::uint32_t g : rows) {
        const std::uint32_t id = world.grains.id[g];
        keys.emplace_back(rank[g], RandomStream(world.seed, "removal", id).uniform(), id, g);
    }
    std::sort(keys.begin(), keys.end());
    std::transform(keys.begin(), keys.end(), rows.begin(), [](const auto& key) { return std::get<3>(key); });
    return rows;
}

std::vector<std::uint32_t> take_mass(const dem::World& world, std::vector<std::uint32_t> rows, double mass) {
    double taken = 0;
    const auto first_left = std::find_if(rows.begin(), rows.end(), [&](std::uint32_t g) {
        const double m = world.grains.mass[g];
        const bool is_nearer_without = taken + 0.5 * m > mass;
        taken += m;
        return is_nearer_without;
    });
    rows.erase(first_left, rows.end());
    return rows;
}

} // namespace suffuse::erosion
