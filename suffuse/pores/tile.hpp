#pragma once
// Tiles: 64 throats or pores side by side, in rows that a loop without branches turns into vector instructions. A tile
// short of throats or pores repeats the last one.

#include "suffuse/pores/network.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace suffuse::pores {

inline constexpr std::size_t tile_rows = 64;

using TileRow = std::array<double, tile_rows>;

struct TileRow3 {
    TileRow x, y, z;

    [[gnu::always_inline]] Vec3 operator[](std::size_t k) const { return {x[k], y[k], z[k]}; }

    [[gnu::always_inline]] void set(std::size_t k, const Vec3& v) { x[k] = v.x, y[k] = v.y, z[k] = v.z; }
};

/// Spheres around throats, and the pore centers on their two sides [m].
struct alignas(64) ThroatTile {
    std::array<TileRow3, 3> center;
    std::array<TileRow, 3> radius;
    TileRow3 pore_1, pore_2;

    [[nodiscard, gnu::always_inline]] std::array<Vec3, 3> centers(std::size_t k) const {
        return {center[0][k], center[1][k], center[2][k]};
    }

    [[nodiscard, gnu::always_inline]] std::array<double, 3> radii(std::size_t k) const {
        return {radius[0][k], radius[1][k], radius[2][k]};
    }
};

/// Loads the throats [first, last), at most `tile_rows`.
void load_throats(
    const PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius, std::size_t first,
    std::size_t last, ThroatTile& tile
);

/// ThroatGeometry of each throat.
struct alignas(64) ThroatGeometries {
    TileRow3 area;
    TileRow void_area, hydraulic_radius;
    std::array<TileRow, 3> section, wetted;
};

/// Loads what the network keeps of the throats [first, last): all but sections.
void load_geometries(const Throats& throats, std::size_t first, std::size_t last, ThroatGeometries& geometry);

void measure_throats(const ThroatTile& tile, ThroatGeometries& geometry);

/// Spheres around pores [m].
struct alignas(64) PoreTile {
    std::array<TileRow3, 4> center;
    std::array<TileRow, 4> radius;
};

/// Loads the pores [first, last), at most `tile_rows`.
void load_pores(
    const Mat3& h, const Pores& pores, std::span<const Vec3> position, std::span<const double> radius,
    std::size_t first, std::size_t last, PoreTile& tile
);

/// What of each pore's tetrahedron the spheres around its corners cover, by solid angles [m3].
void measure_solids(const PoreTile& tile, TileRow& solid);

} // namespace suffuse::pores
