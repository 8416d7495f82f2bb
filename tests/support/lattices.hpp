#pragma once
// Regular packings of equal spheres, and their elastic constants: sums of kn n n n n and ks (n n n t ...) over the
// bonds of the lattice.

#include "tests/support/worlds.hpp"
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

namespace suffuse::test {

inline constexpr double lattice_radius = 1e-4; // [m]

struct Lattice {
    std::string name;
    double edge;            ///< of the cubic cell, in diameters
    std::vector<Vec3> site; ///< in edges
    int coordination;
};

/// Named in test reports.
inline void PrintTo(const Lattice& lattice, std::ostream* out) {
    *out << lattice.name;
}

inline const Lattice simple_cubic{"SC", 1, {{0, 0, 0}}, 6};
inline const Lattice body_centered{"BCC", 2 / std::sqrt(3.0), {{0, 0, 0}, {0.5, 0.5, 0.5}}, 8};
inline const Lattice face_centered{"FCC", std::sqrt(2.0), {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}}, 12};

struct ElasticConstants {
    double c11, c12, c44; ///< [Pa]
};

/// By the normal and shear stiffness of a contact [N/m].
inline ElasticConstants elastic_constants(const Lattice& lattice, double kn, double ks) {
    const double d = 2 * lattice_radius;
    if (lattice.name == "SC") {
        return {kn / d, 0, ks / (2 * d)};
    }
    if (lattice.name == "BCC") {
        return {
            (kn + 2 * ks) / (std::sqrt(3.0) * d), (kn - ks) / (std::sqrt(3.0) * d),
            (kn + 0.5 * ks) / (std::sqrt(3.0) * d)};
    }
    const double root2 = std::sqrt(2.0);
    return {root2 * (kn + ks) / d, (kn - ks) / (root2 * d), (kn + ks) / (root2 * d)};
}

/// Of the linear law.
inline ElasticConstants elastic_constants(const Lattice& lattice, const grains::Material& material) {
    const double kn = material.modulus * lattice_radius;
    return elastic_constants(lattice, kn, material.shear_ratio * kn);
}

/// `repeat` unit cells along each axis, the contacts overlapping by a hair so that all begin.
inline dem::World lattice_world(const Lattice& lattice, int repeat, const grains::Material& material) {
    constexpr double closer = 1 - 1e-10;
    const double edge = lattice.edge * 2 * lattice_radius * closer;
    dem::World world = empty_world(repeat * edge, material);
    for (int i = 0; i < repeat; ++i) {
        for (int j = 0; j < repeat; ++j) {
            for (int k = 0; k < repeat; ++k) {
                for (const Vec3& s : lattice.site) {
                    const Vec3 corner{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
                    add(world, edge * (corner + s), lattice_radius);
                }
            }
        }
    }
    return world;
}

} // namespace suffuse::test
