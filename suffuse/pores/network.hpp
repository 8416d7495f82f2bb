#pragma once
// The pore network of a periodic packing as plain tables: one pore a tetrahedron of the weighted Delaunay
// triangulation, one throat a facet. Geometry only, no fluid. Positions are those given to build_network, not wrapped;
// images count in periods of the given cell. A pore's tetrahedron is the image whose centroid lies in the cell.
// [Chareyre 2012]

#include "suffuse/base/vec3.hpp"
#include "suffuse/cell/cell.hpp"
#include "suffuse/pores/throat.hpp"
#include "suffuse/pores/triangulation.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace suffuse::pores {

/// One row a pore.
struct Pores {
    std::vector<std::array<std::uint32_t, 4>> grain; ///< corner k is position[grain[k]] + shift(h, grain_image[k])
    std::vector<std::array<cell::Image, 4>> grain_image;
    std::vector<std::array<std::uint32_t, 4>> throat; ///< through the facet opposite to corner k
    std::vector<Vec3> center;                         ///< power center of the four grains [m]
    std::vector<double> volume;                       ///< of the tetrahedron [m3]
    std::vector<double> void_volume;                  ///< without the grains [m3]
    /// Pores whose centers coincide, as in lattices, hold one body of water with one pressure; elsewhere a pore is a
    /// body.
    std::vector<std::uint32_t> body;
    std::vector<cell::Image> body_image; ///< the pore's center is the body's center moved by these periods

    [[nodiscard]] std::size_t size() const { return grain.size(); }
};

/// One row a throat; its facet is that of the two pores side[0] and side[1], the latter moved by `image`.
struct Throats {
    std::vector<std::array<std::uint32_t, 2>> side;
    std::vector<cell::Image> image;
    std::vector<std::uint8_t> facet; ///< corner of the pore on side 0 that the facet lies opposite to
    std::vector<Vec3> area;          ///< of the facet, pointing from side 0 to side 1 [m2]
    std::vector<double> void_area;   ///< [m2]
    std::vector<double> covered; ///< sections of grains and void area over the facet: 1, or more where a grain reaches
                                 ///< over an edge of it [-]
    std::vector<std::array<double, 3>> wetted; ///< by the throat's water, of each grain; empty after a flow [m2]
    std::vector<double> hydraulic_radius;      ///< [m]
    std::vector<double> inscribed_radius; ///< of the largest free sphere centered in the facet: the constriction [m]
    std::vector<double> length;           ///< between the pore centers; exactly 0 inside a body of several pores [m]
    std::vector<Vec3> center;             ///< of that sphere; both columns are empty until measure_constrictions [m]

    [[nodiscard]] std::size_t size() const { return side.size(); }
};

struct PoreNetwork {
    Mat3 h; ///< columns are the cell vectors [m]
    Pores pores;
    Throats throats;
    std::size_t bodies = 0;            ///< bodies of water: the unknowns of a flow problem
    std::vector<std::uint32_t> hidden; ///< grains buried in others: no pore touches them, no fluid pushes them
    double jitter = 0;                 ///< see Triangulation [m]
};

/// What is left between the grains, counted by bodies of water. Where two grains overlap their common part is taken off
/// twice, so that a body whose grains overlap much has a negative void: its throats mean nothing.
struct VoidAccount {
    double all = 0;                            ///< sum over bodies [m3]
    double negative = 0;                       ///< of those below 0, as a positive number [m3]
    std::array<std::uint32_t, 4> deepest = {}; ///< grains of the pore whose void is the most negative
};

VoidAccount account_voids(const PoreNetwork& network);

/// @throws GeometryError for two grains in one place.
void expect_grains_apart(const Mat3& h, std::span<const Vec3> position, std::span<const double> radius);

/// Corners of the facet opposite to corner k, turning left seen from the far side when the tetrahedron is positive.
inline constexpr std::array<std::array<std::size_t, 3>, 4> facet_corner = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// The three grains of a throat, in the place that it has next to its side 0.
struct ThroatGrains {
    std::array<std::uint32_t, 3> row;
    std::array<cell::Image, 3> image;
};

inline ThroatGrains grains_of(const PoreNetwork& network, std::size_t t) {
    const std::uint32_t p = network.throats.side[t][0];
    const auto [a, b, c] = facet_corner[network.throats.facet[t]];
    const auto& grain = network.pores.grain[p];
    const auto& image = network.pores.grain_image[p];
    return {{grain[a], grain[b], grain[c]}, {image[a], image[b], image[c]}};
}

/// Their centers and radii, from the positions and radii that the network was built of [m].
struct ThroatSpheres {
    std::array<Vec3, 3> center;
    std::array<double, 3> radius;
};

ThroatSpheres
spheres_of(const PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius, std::size_t t);

/// Centers of the two pores next to throat t [m].
std::array<Vec3, 2> centers_around(const PoreNetwork& network, std::size_t t);

/// Measures throat t (again) from the same: what not every reader needs is measured where it is needed.
ThroatGeometry measure_throat(
    const PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius, std::size_t t
);

/// A throat between two pores of one body: an artificial cut through one void, no constriction.
inline bool is_internal(const Throats& throats, std::size_t t) {
    return throats.length[t] == 0;
}

/// Which side of the throat opposite to its corner k pore p is. Next to its own image it is on both, by different
/// corners.
inline std::size_t side_of(const PoreNetwork& network, std::uint32_t p, std::size_t k) {
    const std::uint32_t t = network.pores.throat[p][k];
    return network.throats.side[t][0] == p && network.throats.facet[t] == k ? 0 : 1;
}

/// A pore in the place that it has next to another: moved by `image` periods from its own.
struct PlacedPore {
    std::uint32_t pore = 0;
    cell::Image image;
};

/// What lies across the facet of pore p opposite to its corner k.
inline PlacedPore pore_beyond(const PoreNetwork& network, std::uint32_t p, std::size_t k) {
    const Throats& throats = network.throats;
    const std::uint32_t t = network.pores.throat[p][k];
    return side_of(network, p, k) == 0 ? PlacedPore{throats.side[t][1], throats.image[t]}
                                       : PlacedPore{throats.side[t][0], -throats.image[t]};
}

/// Corner of that pore which the same facet lies opposite to.
inline std::size_t corner_beyond(const PoreNetwork& network, std::uint32_t p, std::size_t k) {
    const std::uint32_t t = network.pores.throat[p][k];
    if (side_of(network, p, k) == 1) {
        return network.throats.facet[t];
    }
    const std::uint32_t q = network.throats.side[t][1];
    const auto& throats_of_q = network.pores.throat[q];
    std::size_t j = 0;
    while (throats_of_q[j] != t || (q == p && j == k)) {
        ++j;
    }
    return j;
}

/// Pore centers closer than this share of the facet's size (square root of its area) coincide.
inline constexpr double coincidence = 1e-9;

/// Builds the tables of a triangulation of the same cell, positions and radii, without constrictions, which a flow does
/// not need. @throws GeometryError if it is not one.
PoreNetwork build_network(
    Triangulation&& triangulation, const Mat3& h, std::span<const Vec3> position, std::span<const double> radius
);

/// Triangulates, builds and measures the constrictions. @throws GeometryError for input that is not a packing.
PoreNetwork build_network(const Mat3& h, std::span<const Vec3> position, std::span<const double> radius);

} // namespace suffuse::pores
