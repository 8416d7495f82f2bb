#include "suffuse/flow/bounded_drag.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/raw_column.hpp"
#include "suffuse/flow/conductance.hpp"
#include "suffuse/flow/throat_drag.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

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

/// What the water of throat t wets.
WettedGrains wetted_grains(
    const pores::PoreNetwork& network, std::span<const double> radius, std::size_t t,
    const std::array<double, 3>& wetted
) {
    const auto [a, b, c] = pores::grains_of(network, t).row;
    return {{radius[a], radius[b], radius[c]}, wetted};
}

/// Volume of a throat's water [m3].
double water_of(double hydraulic_radius, const std::array<double, 3>& wetted) {
    return std::max(0.0, hydraulic_radius * (wetted[0] + wetted[1] + wetted[2]));
}

RawColumn<double> throat_drags(const pores::PoreNetwork& network, std::span<const double> radius, double least_layer) {
    const pores::Throats& throats = network.throats;
    RawColumn<double> drag(throats.size());
    parallel_for(drag.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const WettedGrains grains = wetted_grains(network, radius, t, throats.wetted[t]);
            const double water = water_of(throats.hydraulic_radius[t], throats.wetted[t]);
            drag[t] = throat_drag(grains, std::max(least_layer, water_layer(grains, water)));
        }
    });
    return drag;
}

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
      least_layer_(thinnest_layer * *std::min_element(radius.begin(), radius.end())),
      exchange_(network, throat_drags(network, radius, least_layer_), exchange_legs(network, position, radius)) {}

std::vector<double> BoundedDrag::conductances(double viscosity) const {
    const pores::Throats& throats = network_.throats;
    RawColumn<double> water(throats.size());
    parallel_for(water.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            water[t] = water_of(throats.hydraulic_radius[t], throats.wetted[t]);
        }
    });
    // Under a pressure gradient of 1 each volume of water is pushed by its size: velocities are mobilities [m2].
    std::vector<double> conductance = exchange_.velocities(water);
    parallel_for(conductance.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const double least = least_length * std::sqrt(norm(throats.area[t]));
            const double mobility = std::max(0.0, conductance[t]); // below 0 only within the solver's tolerance
            conductance[t] = pores::is_internal(throats, t)
                                 ? 0
                                 : throats.void_area[t] * mobility / (viscosity * std::max(throats.length[t], least));
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

/// On the three grains of throat t: what acts on their sections, and their shares in the drag of its water. `to_wall`:
/// of each grain.
std::array<Vec3, 3>
BoundedDrag::forces_at(std::size_t t, double drop, const Vec3& drag, std::span<const double> to_wall) const {
    const pores::ThroatGeometry throat = pores::measure_throat(network_, position_, radius_, t);
    const WettedGrains grains = wetted_grains(network_, radius_, t, throat.wetted);
    const double layer = std::max(least_layer_, water_layer(grains, water_of(throat.hydraulic_radius, throat.wetted)));
    const auto [a, b, c] = pores::grains_of(network_, t).row;
    const auto shares = drag_shares(grains, layer, {to_wall[a], to_wall[b], to_wall[c]});
    const auto& whole = throat.grain_share; // of sections and, by wetted surface, of the void area
    const double sum = network_.throats.covered[t], surface = throat.solid_surface;
    const double void_share = throat.void_area / norm(throat.area);
    std::array<Vec3, 3> force;
    for (std::size_t k = 0; k < 3; ++k) {
        const double section = whole[k] - void_share * (surface > 0 ? grains.area[k] / surface : 1.0 / 3);
        force[k] = (drop * section / sum) * throat.area + shares[k] * drag;
    }
    return force;
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
            for (std::size_t t = first + begin; t < first + end; ++t) {
                found[t - first] = forces_at(t, drop(t), exchange_.to_grains(motion, on_void, t), to_wall);
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
