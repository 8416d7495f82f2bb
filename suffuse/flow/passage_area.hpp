#pragma once
// The void area of a throat along the way from one pore center to the other: narrowest in the facet, wider away from
// it, as the grains around the facet's corners close in on their poles. docs/theory/pore-flow.md, "Bounded drag".

#include "suffuse/base/arctangent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

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

[[gnu::always_inline]] inline double passage_area_at(const Passage& passage, double height) {
    double area = passage.facet;
#pragma GCC unroll 3
    for (std::size_t k = 0; k < 3; ++k) {
        const double r = std::min(std::abs(height), passage.radius[k]);
        area += 0.5 * passage.angle[k] * r * r;
    }
    return area;
}

/// Integrals along a part of the way, over which the area is steady + growing height2.
struct PassageIntegrals {
    double volume = 0, resistance = 0; ///< of the area and of its inverse

    [[gnu::always_inline]] void add(double from, double to, double steady, double growing) {
        const double length = to - from;
        const double root = std::sqrt(std::max(0.0, growing) * steady);
        const double inverse =
            root > 0 ? arctangent(root * length, steady + growing * to * from) / root : length / steady;
        volume += length > 0 ? length * (steady + growing * (to * to + to * from + from * from) / 3) : 0;
        resistance += length > 0 ? inverse : 0;
    }
};

/// Puts the smaller of grains k and l first.
[[gnu::always_inline]] inline void order(Passage& passage, std::size_t k, std::size_t l) {
    const double rk = passage.radius[k], rl = passage.radius[l], ak = passage.angle[k], al = passage.angle[l];
    passage.radius[k] = rl < rk ? rl : rk, passage.radius[l] = rl < rk ? rk : rl;
    passage.angle[k] = rl < rk ? al : ak, passage.angle[l] = rl < rk ? ak : al;
}

/// Means over the heights from `below` to `above` [m], in closed form; of the area halfway where they differ by less
/// than `flat`.
[[gnu::always_inline]] inline PassageArea mean_passage_area(Passage passage, double below, double above, double flat) {
    const double halfway = passage_area_at(passage, 0.5 * (below + above));
    order(passage, 0, 1), order(passage, 1, 2), order(passage, 0, 1);
    const auto& [facet, angle, radius] = passage;
    PassageIntegrals sum;
    const double low = std::min(below, above), high = std::max(below, above);
    // Between one radius and the next, on either side of the facet.
    double steady = facet, growing = 0.5 * (angle[0] + angle[1] + angle[2]);
    sum.add(std::max(low, -radius[0]), std::min(high, radius[0]), steady, growing);
#pragma GCC unroll 2
    for (std::size_t k = 0; k < 2; ++k) {
        steady += 0.5 * angle[k] * radius[k] * radius[k];
        growing -= 0.5 * angle[k];
        sum.add(std::max(low, -radius[k + 1]), std::min(high, -radius[k]), steady, growing);
        sum.add(std::max(low, radius[k]), std::min(high, radius[k + 1]), steady, growing);
    }
    steady += 0.5 * angle[2] * radius[2] * radius[2];
    const double beyond =
        std::max(0.0, std::min(high, -radius[2]) - low) + std::max(0.0, high - std::max(low, radius[2]));
    sum.volume += beyond * steady, sum.resistance += beyond / steady;
    const double way = high - low;
    const bool is_way = way > flat;
    return {is_way ? sum.volume / way : halfway, is_way ? way / sum.resistance : halfway};
}

} // namespace suffuse::flow
