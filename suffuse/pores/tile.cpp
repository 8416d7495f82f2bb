#include "suffuse/pores/tile.hpp"

#include "suffuse/base/clones.hpp"
#include "suffuse/pores/throat_measure.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::pores {

void load_throats(
    const PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius, std::size_t first,
    std::size_t last, ThroatTile& tile
) {
    for (std::size_t k = 0; k < tile_rows; ++k) {
        const std::size_t t = std::min(first + k, last - 1);
        const ThroatSpheres spheres = spheres_of(network, position, radius, t);
        for (std::size_t j = 0; j < 3; ++j) {
            tile.center[j].set(k, spheres.center[j]);
            tile.radius[j][k] = spheres.radius[j];
        }
        const auto [p1, p2] = centers_around(network, t);
        tile.pore_1.set(k, p1);
        tile.pore_2.set(k, p2);
    }
}

void load_geometries(const Throats& throats, std::size_t first, std::size_t last, ThroatGeometries& geometry) {
    for (std::size_t k = 0; k < tile_rows; ++k) {
        const std::size_t t = std::min(first + k, last - 1);
        geometry.area.set(k, throats.area[t]);
        geometry.void_area[k] = throats.void_area[t];
        geometry.hydraulic_radius[k] = throats.hydraulic_radius[t];
        for (std::size_t j = 0; j < 3; ++j) {
            geometry.wetted[j][k] = throats.wetted[t][j];
        }
    }
}

SUFFUSE_CLONES void measure_throats(const ThroatTile& tile, ThroatGeometries& geometry) {
#pragma GCC ivdep
    for (std::size_t k = 0; k < tile_rows; ++k) {
        const ThroatGeometry throat =
            geometry_of_throat(tile.centers(k), tile.radii(k), tile.pore_1[k], tile.pore_2[k]);
        geometry.area.set(k, throat.area);
        geometry.void_area[k] = throat.void_area;
        geometry.hydraulic_radius[k] = throat.hydraulic_radius;
        for (std::size_t j = 0; j < 3; ++j) {
            geometry.section[j][k] = throat.section[j];
            geometry.wetted[j][k] = throat.wetted[j];
        }
    }
}

void load_pores(
    const Mat3& h, const Pores& pores, std::span<const Vec3> position, std::span<const double> radius,
    std::size_t first, std::size_t last, PoreTile& tile
) {
    for (std::size_t k = 0; k < tile_rows; ++k) {
        const std::size_t p = std::min(first + k, last - 1);
        for (std::size_t j = 0; j < 4; ++j) {
            const std::uint32_t g = pores.grain[p][j];
            tile.center[j].set(k, position[g] + shift(h, pores.grain_image[p][j]));
            tile.radius[j][k] = radius[g];
        }
    }
}

SUFFUSE_CLONES void measure_solids(const PoreTile& tile, TileRow& solid) {
#pragma GCC ivdep
    for (std::size_t k = 0; k < tile_rows; ++k) {
        double sum = 0;
#pragma GCC unroll 4
        for (std::size_t j = 0; j < 4; ++j) {
            const Vec3 corner = tile.center[j][k];
            const double r = tile.radius[j][k];
            const auto& c = facet_corner[j];
            const double angle = std::abs(solid_angle_of(
                tile.center[c[0]][k] - corner, tile.center[c[1]][k] - corner, tile.center[c[2]][k] - corner
            ));
            sum += r * r * r * angle / 3;
        }
        solid[k] = sum;
    }
}

} // namespace suffuse::pores
