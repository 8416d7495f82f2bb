#pragma once
// Grains whose centers lie in one place, or in images of it: nothing tells which way they push each other, and no pore
// lies between them.

#include "suffuse/cell/cell.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace suffuse::cell {

/// Centers nearer than this share of the smaller radius are one: no force of grains comes near such an overlap.
inline constexpr double one_place = 1e-6;

/// The rows of two grains in one place, in rising order; nothing where all lie apart.
/// @pre every position has a period
inline std::optional<std::pair<std::size_t, std::size_t>>
find_coincident(const Mat3& h, std::span<const Vec3> position, std::span<const double> radius) {
    struct Along {
        double s; ///< along the first cell vector, in periods from 0 to 1
        std::size_t row;
    };

    if (radius.size() < 2) {
        return std::nullopt;
    }
    const Mat3 inverse_h = inverse(h);
    std::vector<Along> order(radius.size());
    double largest = 0;
    for (std::size_t g = 0; g < radius.size(); ++g) {
        const double s = (inverse_h * position[g]).x;
        order[g] = {s - std::floor(s), g};
        largest = std::max(largest, radius[g]);
    }
    std::sort(order.begin(), order.end(), [](const Along& a, const Along& b) {
        return a.s != b.s ? a.s < b.s : a.row < b.row;
    });
    const auto are_one = [&](std::size_t g, std::size_t k) {
        const Vec3 s = inverse_h * (position[k] - position[g]);
        const Vec3 apart = h * Vec3{s.x - std::round(s.x), s.y - std::round(s.y), s.z - std::round(s.z)};
        return norm(apart) <= one_place * std::min(radius[g], radius[k]);
    };
    const double reach = std::min(0.5, one_place * largest / widths(h).x);
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t j = i + 1; j < i + order.size(); ++j) { // on over the end of the period to its beginning
            const Along& next = order[j % order.size()];
            if (next.s + (j < order.size() ? 0.0 : 1.0) - order[i].s > reach) {
                break;
            }
            if (are_one(order[i].row, next.row)) {
                return std::minmax(order[i].row, next.row);
            }
        }
    }
    return std::nullopt;
}

} // namespace suffuse::cell
