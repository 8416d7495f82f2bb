#include "suffuse/pores/network.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/cell/coincident.hpp"
#include "suffuse/pores/constrictions.hpp"
#include "suffuse/pores/offset_union.hpp"
#include "suffuse/pores/power_center.hpp"
#include "suffuse/pores/tile.hpp"
#include "suffuse/pores/triangulation_check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

namespace suffuse::pores {
namespace {

constexpr std::size_t block = 1024;

/// A facet is numbered from the side that comes first.
bool is_first_side(const Triangulation& triangulation, std::uint32_t p, std::size_t k) {
    const std::uint32_t q = triangulation.neighbor[p][k];
    return p < q || (p == q && !(triangulation.neighbor_image[p][k] < cell::Image{}));
}

/// Throats before those of each block of tetrahedra.
std::vector<std::uint32_t> count_throats(const Triangulation& triangulation) {
    std::vector<std::uint32_t> before((triangulation.size() + block - 1) / block + 1, 0);
    parallel_for(triangulation.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
            for (std::size_t k = 0; k < 4; ++k) {
                before[begin / block + 1] += is_first_side(triangulation, static_cast<std::uint32_t>(p), k) ? 1 : 0;
            }
        }
    });
    std::partial_sum(before.begin(), before.end(), before.begin());
    return before;
}

/// Numbers the facets and opens the rows of the throat table.
void number_throats(const Triangulation& triangulation, Pores& pores, Throats& throats) {
    const std::vector<std::uint32_t> before = count_throats(triangulation);
    resize_columns(before.back(), throats.side, throats.image, throats.facet);
    pores.throat.resize(triangulation.size());
    const auto number = [&](std::uint32_t p, std::size_t k, std::uint32_t t) {
        const std::size_t j = facet_from_other_side(triangulation, p, k);
        expects(j < 4, "each facet of the triangulation has two sides");
        const std::uint32_t q = triangulation.neighbor[p][k];
        pores.throat[p][k] = t;
        pores.throat[q][j] = t;
        throats.side[t] = {p, q};
        throats.image[t] = triangulation.neighbor_image[p][k];
        throats.facet[t] = static_cast<std::uint8_t>(k);
    };
    parallel_for(triangulation.size(), block, [&](std::size_t begin, std::size_t end) {
        std::uint32_t t = before[begin / block];
        for (auto p = static_cast<std::uint32_t>(begin); p < end; ++p) {
            for (std::size_t k = 0; k < 4; ++k) {
                if (is_first_side(triangulation, p, k)) {
                    number(p, k, t++);
                }
            }
        }
    });
}

/// Flat tetrahedra have no center of their own: it lies between those of their neighbors, so that they take one of
/// these.
void center_flat_pores(PoreNetwork& network, std::vector<std::uint8_t>& is_flat) {
    Pores& pores = network.pores;
    std::vector<std::uint32_t> waiting;
    for (std::uint32_t p = 0; p < pores.size(); ++p) {
        if (is_flat[p] != 0) {
            waiting.push_back(p);
        }
    }
    while (!waiting.empty()) {
        std::vector<std::uint32_t> still, found;
        for (const std::uint32_t p : waiting) {
            std::size_t k = 0;
            while (k < 4 && is_flat[pore_beyond(network, p, k).pore] != 0) {
                ++k;
            }
            if (k == 4) {
                still.push_back(p);
                continue;
            }
            const PlacedPore beyond = pore_beyond(network, p, k);
            pores.center[p] = pores.center[beyond.pore] + shift(network.h, beyond.image);
            found.push_back(p);
        }
        if (found.empty()) {
            throw GeometryError("pores: all grain centers are in one plane; a packing has three dimensions");
        }
        for (const std::uint32_t p : found) {
            is_flat[p] = 0;
        }
        waiting = std::move(still);
    }
}

void measure_pores(PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius) {
    Pores& pores = network.pores;
    const std::size_t n = pores.size();
    resize_columns(n, pores.center, pores.volume, pores.void_volume);
    std::vector<std::uint8_t> is_flat(n, 0);
    parallel_for(n, block, [&](std::size_t begin, std::size_t end) {
        PoreTile tile{};
        TileRow solid{};
        for (std::size_t first = begin; first < end; first += tile_rows) {
            const std::size_t last = std::min(first + tile_rows, end);
            load_pores(network.h, pores, position, radius, first, last, tile);
            measure_solids(tile, solid);
            for (std::size_t p = first; p < last; ++p) {
                std::array<Vec3, 4> x;
                std::array<double, 4> weight{};
                for (std::size_t j = 0; j < 4; ++j) {
                    x[j] = tile.center[j][p - first];
                    weight[j] = tile.radius[j][p - first] * tile.radius[j][p - first];
                }
                const PowerCenter center = power_center(x, weight);
                pores.center[p] = center.point;
                is_flat[p] = center.is_flat ? 1 : 0;
                pores.volume[p] = tetrahedron_volume(x[0], x[1], x[2], x[3]);
                pores.void_volume[p] = pores.volume[p] - solid[p - first];
            }
        }
    });
    center_flat_pores(network, is_flat);
}

void measure_throats(PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius) {
    Throats& throats = network.throats;
    const std::size_t n = throats.size();
    resize_columns(
        n, throats.area, throats.void_area, throats.covered, throats.wetted, throats.hydraulic_radius, throats.length
    );
    parallel_for(n, block, [&](std::size_t begin, std::size_t end) {
        ThroatTile tile{};
        ThroatGeometries of{};
        for (std::size_t first = begin; first < end; first += tile_rows) {
            const std::size_t last = std::min(first + tile_rows, end);
            load_throats(network, position, radius, first, last, tile);
            measure_throats(tile, of);
            for (std::size_t t = first; t < last; ++t) {
                const std::size_t k = t - first;
                throats.area[t] = of.area[k];
                throats.void_area[t] = of.void_area[k];
                const double solid = of.section[0][k] + of.section[1][k] + of.section[2][k];
                throats.covered[t] = (solid + of.void_area[k]) / norm(of.area[k]);
                throats.wetted[t] = {of.wetted[0][k], of.wetted[1][k], of.wetted[2][k]};
                throats.hydraulic_radius[t] = of.hydraulic_radius[k];
                throats.length[t] = norm(tile.pore_2[k] - tile.pore_1[k]);
            }
        }
    });
}

/// Throats between coincident pore centers, in order. Elsewhere than in lattices there are few.
std::vector<std::uint32_t> find_coincident(const Throats& throats) {
    std::vector<std::vector<std::uint32_t>> of_block((throats.size() + block - 1) / block);
    parallel_for(throats.size(), block, [&](std::size_t begin, std::size_t end) {
        for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t) {
            if (!(throats.length[t] > coincidence * std::sqrt(norm(throats.area[t])))) {
                of_block[begin / block].push_back(t);
            }
        }
    });
    std::vector<std::uint32_t> found;
    for (const std::vector<std::uint32_t>& some : of_block) {
        found.insert(found.end(), some.begin(), some.end());
    }
    return found;
}

/// Joins pores of coincident centers to bodies and gives throats inside a body the length 0.
void join_to_bodies(const std::vector<std::uint32_t>& coincident, PoreNetwork& network) {
    Pores& pores = network.pores;
    Throats& throats = network.throats;
    OffsetUnion bodies(pores.size());
    for (const std::uint32_t t : coincident) {
        bodies.join(throats.side[t][0], throats.side[t][1], throats.image[t]);
    }
    constexpr std::uint32_t none = ~std::uint32_t{0};
    std::vector<std::uint32_t> number(pores.size(), none);
    for (std::uint32_t p = 0; p < pores.size(); ++p) {
        const auto root = bodies.find(p);
        if (number[root.node] == none) {
            number[root.node] = static_cast<std::uint32_t>(network.bodies++);
        }
        pores.body[p] = number[root.node];
        pores.body_image[p] = root.offset;
    }
    parallel_for(throats.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const auto [p, q] = throats.side[t];
            const bool same =
                pores.body[p] == pores.body[q] && pores.body_image[p] == pores.body_image[q] + throats.image[t];
            if (same) {
                throats.length[t] = 0;
            }
        }
    });
}

void find_bodies(PoreNetwork& network) {
    Pores& pores = network.pores;
    resize_columns(pores.size(), pores.body, pores.body_image);
    const std::vector<std::uint32_t> coincident = find_coincident(network.throats);
    if (!coincident.empty()) {
        return join_to_bodies(coincident, network);
    }
    network.bodies = pores.size();
    parallel_for(pores.size(), block, [&](std::size_t begin, std::size_t end) {
        const auto from = pores.body.begin();
        std::iota(
            from + static_cast<std::ptrdiff_t>(begin), from + static_cast<std::ptrdiff_t>(end),
            static_cast<std::uint32_t>(begin)
        );
    });
}

} // namespace

PoreNetwork build_network(
    Triangulation&& triangulation, const Mat3& h, std::span<const Vec3> position, std::span<const double> radius
) {
    PoreNetwork network;
    network.h = h;
    network.jitter = triangulation.jitter;
    number_throats(triangulation, network.pores, network.throats);
    network.hidden = std::move(triangulation.hidden);
    network.pores.grain = std::move(triangulation.grain);
    network.pores.grain_image = std::move(triangulation.grain_image);
    triangulation = {}; // its neighbors are in the table of throats now
    measure_pores(network, position, radius);
    measure_throats(network, position, radius);
    find_bodies(network);
    return network;
}

PoreNetwork build_network(const Mat3& h, std::span<const Vec3> position, std::span<const double> radius) {
    Triangulation triangulation = triangulate(h, position, radius);
    expect_grains_apart(h, position, radius);
    PoreNetwork network = build_network(std::move(triangulation), h, position, radius);
    measure_constrictions(network, position, radius);
    return network;
}

ThroatSpheres
spheres_of(const PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius, std::size_t t) {
    const auto [row, image] = grains_of(network, t);
    ThroatSpheres spheres;
    for (std::size_t k = 0; k < 3; ++k) {
        spheres.center[k] = position[row[k]] + shift(network.h, image[k]);
        spheres.radius[k] = radius[row[k]];
    }
    return spheres;
}

std::array<Vec3, 2> centers_around(const PoreNetwork& network, std::size_t t) {
    const auto [p, q] = network.throats.side[t];
    return {network.pores.center[p], network.pores.center[q] + shift(network.h, network.throats.image[t])};
}

ThroatGeometry measure_throat(
    const PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius, std::size_t t
) {
    const auto [center, r] = spheres_of(network, position, radius, t);
    const auto [p1, p2] = centers_around(network, t);
    return measure_throat(center, r, p1, p2);
}

VoidAccount account_voids(const PoreNetwork& network) {
    const Pores& pores = network.pores;
    std::vector<double> of_body(network.bodies, 0.0);
    std::size_t deepest = 0;
    for (std::size_t p = 0; p < pores.size(); ++p) {
        of_body[pores.body[p]] += pores.void_volume[p];
        deepest = pores.void_volume[p] < pores.void_volume[deepest] ? p : deepest;
    }
    VoidAccount account;
    account.deepest = pores.grain[deepest];
    for (const double part : of_body) {
        account.all += part;
        account.negative += std::max(0.0, -part);
    }
    return account;
}

void expect_grains_apart(const Mat3& h, std::span<const Vec3> position, std::span<const double> radius) {
    if (const auto rows = cell::find_coincident(h, position, radius)) {
        const Vec3& x = position[rows->second];
        throw GeometryError(fmt::format(
            "pores: the grains in rows {} and {} are at the same place, ({}, {}, {}) m or an image of it; remove one "
            "of them",
            rows->first, rows->second, x.x, x.y, x.z
        ));
    }
}

} // namespace suffuse::pores
