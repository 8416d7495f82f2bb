#include "suffuse/flow/bounded_drag.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/raw_column.hpp"
#include "suffuse/flow/conductance.hpp"
#include "suffuse/flow/water_tile.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

namespace suffuse::flow {
namespace {

constexpr std::size_t block = 2048;         // throats of one loop of a thread
constexpr std::size_t stretch = 32 * block; // throats whose forces are held at a time

/// Threads beyond that many would do little but read which grains are not theirs.
constexpr std::size_t most_adders = 16;

/// So many that follow each other are added up by one thread: none writes where another does.
constexpr std::size_t grains_together = 256;

/// Layers are no thinner than this part of the smallest grain.
constexpr double thinnest_layer = 1e-6;

/// A neighbor that many times larger is a wall.
constexpr double wall_ratio = 1.5;

} // namespace

std::vector<double>
distances_to_walls(const pores::PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius) {
    std::vector<double> distance(radius.size(), std::numeric_limits<double>::infinity());
    const pores::Pores& pores = network.pores;
    const auto corner = [&](std::size_t p, std::size_t k) {
        return position[pores.grain[p][k]] + shift(network.h, pores.grain_image[p][k]);
    };
    const auto lower = [](double& least, double value) { // in whatever order threads come
        const std::atomic_ref shared(least);
        for (double now = shared.load(std::memory_order_relaxed);
             value < now && !shared.compare_exchange_weak(now, value, std::memory_order_relaxed);) {
        }
    };
    parallel_for(pores.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
            for (std::size_t k = 0; k < 4; ++k) {
                for (std::size_t l = 0; l < 4; ++l) {
                    const std::uint32_t g = pores.grain[p][k], wall = pores.grain[p][l];
                    if (radius[wall] > wall_ratio * radius[g]) {
                        const double away = norm(corner(p, l) - corner(p, k)) - radius[wall];
                        lower(distance[g], std::max(away, radius[g]));
                    }
                }
            }
        }
    });
    return distance;
}

BoundedDrag::BoundedDrag(
    const pores::PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius
)
    : network_(network), position_(position), radius_(radius),
      least_layer_(thinnest_layer * *std::min_element(radius.begin(), radius.end())), water_(network.throats.size()),
      passage_(network.throats.size()), exchange_(network, measure_water(), exchange_legs(network, position, radius)) {}

RawColumn<double> BoundedDrag::measure_water() {
    RawColumn<double> drag(network_.throats.size());
    std::vector<double> covered_twice((drag.size() + block - 1) / block);
    parallel_for(drag.size(), block, [&](std::size_t begin, std::size_t end) {
        pores::ThroatTile tile{};
        pores::ThroatGeometries of{};
        WaterTile water{};
        for (std::size_t first = begin; first < end; first += pores::tile_rows) {
            const std::size_t last = std::min(first + pores::tile_rows, end);
            pores::load_throats(network_, position_, radius_, first, last, tile);
            pores::load_geometries(network_.throats, first, last, of);
            flow::measure_water(tile, of, least_layer_, water);
            for (std::size_t t = first; t < last; ++t) {
                const std::size_t k = t - first;
                water_[t] = water.volume[k];
                covered_twice[begin / block] += water.covered_twice[k];
                passage_[t] = water.passage[k];
                drag[t] = water.drag[k];
            }
        }
    });
    covered_twice_ = std::accumulate(covered_twice.begin(), covered_twice.end(), 0.0);
    return drag;
}

std::vector<double> BoundedDrag::conductances(double viscosity) const {
    const pores::Throats& throats = network_.throats;
    // Under a pressure gradient of 1 each volume of water is pushed by its size: velocities are mobilities [m2].
    std::vector<double> conductance = exchange_.velocities(water_);
    parallel_for(conductance.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const double least = least_length * std::sqrt(norm(throats.area[t]));
            const double mobility = std::max(0.0, conductance[t]); // below 0 only within the solver's tolerance
            conductance[t] = pores::is_internal(throats, t)
                                 ? 0
                                 : passage_[t] * mobility / (viscosity * std::max(throats.length[t], least));
        }
    });
    return conductance;
}

/// On the facet of a throat for what acts on its void area [Pa]. Where a grain reaches over the opposite edge, sections
/// and void area add up to more than the facet, and all of them are scaled.
double BoundedDrag::pressure_on_void(std::size_t t, double drop) const {
    const pores::Throats& throats = network_.throats;
    return drop * throats.void_area[t] / (norm(throats.area[t]) * throats.covered[t]);
}

/// On the three grains of each throat of [first, last): what acts on their sections, and their shares in the drag of
/// its water. `to_wall`: of each grain. Measured anew: kept, it would take more memory than anything else of a flow.
void BoundedDrag::forces_at(
    std::size_t first, std::size_t last, std::span<const double> to_wall, std::span<const double> drop,
    std::span<const Vec3> drag, std::span<std::array<Vec3, 3>> force
) const {
    pores::ThroatTile tile{};
    pores::ThroatGeometries of{};
    std::array<pores::TileRow, 3> distance{}, share{};
    pores::load_throats(network_, position_, radius_, first, last, tile);
    for (std::size_t k = 0; k < pores::tile_rows; ++k) {
        const auto grain = pores::grains_of(network_, std::min(first + k, last - 1)).row;
        for (std::size_t j = 0; j < 3; ++j) {
            distance[j][k] = to_wall[grain[j]];
        }
    }
    pores::measure_throats(tile, of);
    share_drag(tile, of, distance, least_layer_, share);
    for (std::size_t t = first; t < last; ++t) {
        const std::size_t k = t - first;
        const Vec3 area = of.area[k];
        const double pressure = drop[k] / (norm(area) * network_.throats.covered[t]);
        for (std::size_t j = 0; j < 3; ++j) {
            force[k][j] = (pressure * of.section[j][k]) * area + share[j][k] * drag[k];
        }
    }
}

std::vector<Vec3> BoundedDrag::grain_forces(std::span<const double> pressure, const Vec3& gradient) const {
    expects(pressure.size() == network_.pores.size(), "one pressure a pore");
    const pores::Throats& throats = network_.throats;
    const auto drop = [&](std::size_t t) {
        const auto [p, q] = throats.side[t];
        return pressure[p] - pressure[q] - dot(gradient, cell::shift(network_.h, throats.image[t]));
    };
    RawColumn<double> on_void(throats.size());
    parallel_for(on_void.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            on_void[t] = pressure_on_void(t, drop(t));
        }
    });
    const MomentumExchange::Motion motion = exchange_.motion(on_void);
    const std::vector<double> to_wall = distances_to_walls(network_, position_, radius_);

    // Found on all threads, a stretch of throats after the other. Each thread then adds up the forces on some of the
    // grains, in the order of the throats.
    const std::size_t adders = std::min(most_adders, static_cast<std::size_t>(thread_count()));
    std::vector<Vec3> force(radius_.size());
    RawColumn<std::array<Vec3, 3>> found(std::min(throats.size(), stretch));
    for (std::size_t first = 0; first < throats.size(); first += stretch) {
        const std::size_t count = std::min(stretch, throats.size() - first);
        parallel_for(count, block, [&](std::size_t begin, std::size_t end) {
            std::array<double, pores::tile_rows> drops{};
            std::array<Vec3, pores::tile_rows> drag;
            for (std::size_t row = begin; row < end; row += pores::tile_rows) {
                const std::size_t rows = std::min(pores::tile_rows, end - row), t = first + row;
                for (std::size_t k = 0; k < rows; ++k) {
                    drops[k] = drop(t + k);
                    drag[k] = exchange_.to_grains(motion, on_void, t + k);
                }
                forces_at(t, t + rows, to_wall, drops, drag, std::span(found).subspan(row, rows));
            }
        });
        parallel_for(adders, 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t t = first; t < first + count; ++t) {
                const auto grain = pores::grains_of(network_, t).row;
                for (std::size_t k = 0; k < 3; ++k) {
                    const std::uint32_t g = grain[k];
                    const std::size_t adder = g / grains_together % adders;
                    if (begin <= adder && adder < end) {
                        force[g] += found[t - first][k];
                    }
                }
            }
        });
    }
    return force;
}

} // namespace suffuse::flow
