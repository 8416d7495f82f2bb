#include "suffuse/dem/order.hpp"

#include "suffuse/contact/carry_over.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace suffuse::dem {
namespace {

/// Spreads the lower 21 bits of `k` so that two zero bits follow each.
std::uint64_t spread(std::uint64_t k) {
    k &= 0x1fffff;
    k = (k | k << 32) & 0x1f00000000ffffULL;
    k = (k | k << 16) & 0x1f0000ff0000ffULL;
    k = (k | k << 8) & 0x100f00f00f00f00fULL;
    k = (k | k << 4) & 0x10c30c30c30c30c3ULL;
    k = (k | k << 2) & 0x1249249249249249ULL;
    return k;
}

/// Place of a point along the Morton curve through the cell.
std::uint64_t morton(const Mat3& inverse_h, const Vec3& position) {
    const Vec3 s = inverse_h * position;
    std::uint64_t key = 0;
    for (int a = 0; a < 3; ++a) {
        const double fraction = s[a] - std::floor(s[a]);
        key |= spread(static_cast<std::uint64_t>(fraction * 0x1fffff)) << a;
    }
    return key;
}

/// Keeps the rows of `kept`, in that order.
void keep(World& world, const std::vector<std::uint32_t>& kept) {
    std::vector<std::uint32_t> new_row(world.grains.size(), contact::removed_row);
    for (std::uint32_t k = 0; k < kept.size(); ++k) {
        new_row[kept[k]] = k;
    }
    grains::select_rows(world.grains, kept);
    world.contacts = contact::renumbered(contact::touching_rows(world.contacts), new_row);
}

template <class Key>
void sort_by(World& world, const std::vector<Key>& key) {
    std::vector<std::uint32_t> order(world.grains.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return key[a] != key[b] ? key[a] < key[b] : world.grains.id[a] < world.grains.id[b];
    });
    keep(world, order);
}

} // namespace

void sort_along_curve(World& world) {
    const Mat3 inverse_h = inverse(world.cell.h);
    std::vector<std::uint64_t> key;
    for (const Vec3& x : world.grains.position) {
        key.push_back(morton(inverse_h, x));
    }
    sort_by(world, key);
}

void sort_by_id(World& world) {
    sort_by(world, std::vector<std::uint32_t>(world.grains.id));
}

void remove_grains(World& world, std::span<const std::uint32_t> rows) {
    std::vector<std::uint8_t> gone(world.grains.size(), 0);
    for (const std::uint32_t g : rows) {
        gone[g] = 1;
    }
    std::vector<std::uint32_t> kept;
    for (std::uint32_t g = 0; g < gone.size(); ++g) {
        if (gone[g] == 0) {
            kept.push_back(g);
        }
    }
    keep(world, kept);
}

void relocate_grains(World& world, std::span<const std::uint32_t> rows, std::span<const Vec3> position) {
    grains::Grains& grains = world.grains;
    std::vector<std::uint32_t> new_row(grains.size());
    std::iota(new_row.begin(), new_row.end(), 0U);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const std::uint32_t g = rows[k];
        grains.position[g] = position[k];
        grains.velocity[g] = grains.spin[g] = grains.force[g] = grains.torque[g] = {};
        new_row[g] = contact::removed_row; // loses its contacts only
    }
    world.contacts = contact::renumbered(contact::touching_rows(world.contacts), new_row);
}

} // namespace suffuse::dem
