#pragma once
// The neighbor search: pairs of grains nearer than a margin, in a periodic cell of any shape and for any size ratio.
// Grains are binned by size class (a factor of two each), every class in a grid of its own cell size; each pair is
// found once, from its smaller grain, so that the cost per grain does not grow with the size ratio [Ogarko & Luding
// 2012, the idea].

#include "suffuse/base/vec3.hpp"
#include "suffuse/cell/cell.hpp"

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

namespace suffuse::neighbors {

struct Pair {
    std::uint32_t first = 0, second = 0; ///< rows of the grain table, first <= second
    cell::Image image; ///< period of `second` seen from `first`; for a grain and its own image, image > 0

    auto operator<=>(const Pair&) const = default;
};

/// All pairs with gap |x2 + h image - x1| - r1 - r2 <= `margin` [m], sorted. Positions need not lie inside the cell.
/// A pair may occur with several images when the cell is narrow.
/// @throws GeometryError when a position or the cell is not finite, or the cell has no volume.
std::vector<Pair> find_pairs(const Mat3& h, std::vector<Vec3> position, std::span<const double> radius, double margin);

/// Those of them that have a grain with a 1 in `sought`, all where that is empty.
std::vector<Pair> find_pairs_of(
    std::span<const std::uint8_t> sought, const Mat3& h, std::vector<Vec3> position, std::span<const double> radius,
    double margin
);

/// All pairs by testing every pair with every image within reach: the slow oracle of the tests.
std::vector<Pair>
find_pairs_exhaustively(const Mat3& h, std::span<const Vec3> position, std::span<const double> radius, double margin);

} // namespace suffuse::neighbors
