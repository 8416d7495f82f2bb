#pragma once
// A grain or one of its images as the corner of a tetrahedron, and sets of them that are the same for all images.

#include "suffuse/cell/cell.hpp"

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>

namespace suffuse::pores {

struct Corner {
    std::uint32_t grain;
    cell::Image image; ///< in periods of the compact cell

    auto operator<=>(const Corner&) const = default;
};

/// Corners of a tetrahedron or of a facet, moved so that the grain of lowest row is at home: the same for all its
/// images.
template <std::size_t N>
struct Canonical {
    std::array<Corner, N> corners;
    cell::Image moved; ///< what was given = this, moved by these periods
};

template <std::size_t N>
Canonical<N> canonical(const std::array<Corner, N>& given) {
    Canonical<N> best{};
    bool any = false;
    const std::uint32_t lowest = std::min_element(given.begin(), given.end())->grain;
    for (const Corner& origin : given) { // several where a grain is joined to its own image
        if (origin.grain != lowest) {
            continue;
        }
        Canonical<N> c{given, origin.image};
        for (Corner& corner : c.corners) {
            corner.image = corner.image - origin.image;
        }
        std::sort(c.corners.begin(), c.corners.end());
        if (!any || c.corners < best.corners) {
            best = c;
        }
        any = true;
    }
    return best;
}

} // namespace suffuse::pores
