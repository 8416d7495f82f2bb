#pragma once
// Grains whose centers lie in one place, or in images of it: nothing determines which way they push each other, and no
// pore lies between them.

#include "suffuse/base/members.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/raw_column.hpp"
#include "suffuse/cell/cell.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace suffuse::cell {

/// Centers nearer than this share of the smaller radius are one: no force of grains comes near such an overlap.
inline constexpr double one_place = 1e-6;

/// The rows of two grains in one place, in rising order; nothing where all lie apart.
/// @pre every position has a period
inline std::optional<std::pair<std::size_t, std::size_t>>
find_coincident(const Mat3& h, std::span<const Vec3> position, std::span<const double> radius) {
    struct Along {
        double s; ///< along the first cell vector, in periods from 0 to 1
        std::uint32_t row;
    };

    const std::size_t count = radius.size();
    if (count < 2) {
        return std::nullopt;
    }
    constexpr std::size_t block = 4096, together = 64; // grains of a loop of a thread, and of a slab
    const Mat3 inverse_h = inverse(h);
    const auto along = [&](std::size_t g) {
        const double s = (inverse_h * position[g]).x;
        return s - std::floor(s);
    };
    const std::size_t slabs = count / together + 1;
    const Members slab = members_of(count, slabs, [&](std::size_t g) {
        return std::min(slabs - 1, static_cast<std::size_t>(along(g) * static_cast<double>(slabs)));
    });
    RawColumn<Along> order(count);
    parallel_for(slabs, block / together, [&](std::size_t begin, std::size_t end) {
        const std::size_t first = slab.first[begin], last = slab.first[end];
        for (std::size_t k = first; k < last; ++k) {
            order[k] = {along(slab.row[k]), slab.row[k]};
        }
        std::sort(order.data() + first, order.data() + last, [](const Along& a, const Along& b) {
            return a.s != b.s ? a.s < b.s : a.row < b.row;
        });
    });
    const auto are_one = [&](std::size_t g, std::size_t k) {
        const Vec3 s = inverse_h * (position[k] - position[g]);
        const Vec3 apart = h * Vec3{s.x - std::round(s.x), s.y - std::round(s.y), s.z - std::round(s.z)};
        return norm(apart) <= one_place * std::min(radius[g], radius[k]);
    };
    const double reach = std::min(0.5, one_place * std::ranges::max(radius) / widths(h).x);
    using Pair = std::optional<std::pair<std::size_t, std::size_t>>;
    const auto first_of = [&](std::size_t begin, std::size_t end) -> Pair {
        for (std::size_t i = begin; i < end; ++i) {
            for (std::size_t j = i + 1; j < i + count; ++j) { // on over the end of the period to its beginning
                const Along& next = order[j % count];
                if (next.s + (j < count ? 0.0 : 1.0) - order[i].s > reach) {
                    break;
                }
                if (are_one(order[i].row, next.row)) {
                    return std::minmax<std::size_t>(order[i].row, next.row);
                }
            }
        }
        return std::nullopt;
    };
    return parallel_sum(count, block, Pair(), first_of, [](const Pair& one, const Pair& other) {
        return one ? one : other;
    });
}

} // namespace suffuse::cell
