#pragma once
// The void area of a throat along the way from one pore center to the other: narrowest in the facet, wider away from
// it, as the grains around the facet's corners close in on their poles. docs/theory/pore-flow.md, "Bounded drag".

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace suffuse::flow {

/// At the height z over its facet a throat is open over `facet` + sum of angle min(z2, r2)/2.
struct Passage {
    double facet = 0;               ///< void area at height 0, above 0 [m2]
    std::array<double, 3> angle{};  ///< of the facet at each of its grains [rad]
    std::array<double, 3> radius{}; ///< [m]
};

struct PassageArea {
    double mean = 0, harmonic = 0; ///< [m2]
};

inline double passage_area_at(const Passage& passage, double height) {
    double area = passage.facet;
    for (std::size_t k = 0; k < 3; ++k) {
        const double r = std::min(std::abs(height), passage.radius[k]);
        area += 0.5 * passage.angle[k] * r * r;
    }
    return area;
}

/// Means over the heights from `below` to `above` [m], in closed form; of the area halfway where they differ by less
/// than `flat`.
inline PassageArea mean_passage_area(Passage passage, double below, double above, double flat) {
    if (!(std::abs(above - below) > flat)) {
        const double area = passage_area_at(passage, 0.5 * (below + above));
        return {area, area};
    }
    for (const auto [k, l] : {std::array<std::size_t, 2>{0, 1}, {1, 2}, {0, 1}}) { // by radius
        if (passage.radius[l] < passage.radius[k]) {
            std::swap(passage.radius[k], passage.radius[l]);
            std::swap(passage.angle[k], passage.angle[l]);
        }
    }
    double volume = 0, resistance = 0; // integrals of the area and of its inverse
    const double low = std::min(below, above), high = std::max(below, above);
    // Between one radius and the next, on either side of the facet, the area is steady + growing z2.
    double steady = passage.facet, growing = 0.5 * (passage.angle[0] + passage.angle[1] + passage.angle[2]);
    const auto add = [&](double from, double to) {
        from = std::max(from, low), to = std::min(to, high);
        if (from < to) {
            const double root = std::sqrt(std::max(0.0, growing) * steady), length = to - from;
            volume += length * (steady + growing * (to * to + to * from + from * from) / 3);
            resistance += root > 0 ? std::atan2(root * length, steady + growing * to * from) / root : length / steady;
        }
    };
    add(-passage.radius[0], passage.radius[0]);
    for (std::size_t k = 0; k < 3; ++k) {
        const double inner = passage.radius[k];
        const double outer = k < 2 ? passage.radius[k + 1] : std::numeric_limits<double>::infinity();
        steady += 0.5 * passage.angle[k] * inner * inner;
        growing = k < 2 ? growing - 0.5 * passage.angle[k] : 0;
        add(-outer, -inner);
        add(inner, outer);
    }
    const double way = high - low;
    return {volume / way, way / resistance};
}

} // namespace suffuse::flow
