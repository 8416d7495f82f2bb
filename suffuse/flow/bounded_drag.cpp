#include "suffuse/flow/bounded_drag.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
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

WettedGrains wetted_grains(const pores::Throats& throats, std::span<const double> radius, std::size_t t) {
    const auto& g = throats.grain[t];
    return {{radius[g[0]], radius[g[1]], radius[g[2]]}, throats.wetted[t]};
}

/// Volume of a throat's water [m3].
double water_of(const pores::Throats& throats, std::size_t t) {
    return std::max(0.0, throats.hydraulic_radius[t] * throats.solid_surface[t]);
}

std::vector<double> water_layers(const pores::PoreNetwork& network, std::span<const double> radius) {
    const double least = thinnest_layer * *std::min_element(radius.begin(), radius.end());
    std::vector<double> layer(network.throats.size());
    parallel_for(layer.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const WettedGrains grains = wetted_grains(network.throats, radius, t);
            layer[t] = std::max(least, water_layer(grains, water_of(network.throats, t)));
        }
    });
    return layer;
}

std::vector<double>
throat_drags(const pores::PoreNetwork& network, std::span<const double> radius, std::span<const double> layer) {
    std::vector<double> drag(layer.size());
    parallel_for(layer.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            drag[t] = throat_drag(wetted_grains(network.throats, radius, t), layer[t]);
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
    : network_(network), position_(position), radius_(radius), layer_(water_layers(network, radius)),
      exchange_(network, throat_drags(network, radius, layer_), exchange_legs(network, position, radius)) {}

std::vector<double> BoundedDrag::conductances(double viscosity) const {
    const pores::Throats& throats = network_.throats;
    std::vector<double> water(throats.size());
    parallel_for(water.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            water[t] = water_of(throats, t);
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
    const auto& share = throats.grain_share[t];
    return drop * throats.void_area[t] / (norm(throats.area[t]) * (share[0] + share[1] + share[2]));
}

/// On the three grains of throat t: what acts on their sections, and their shares in the drag of its water.
std::array<Vec3, 3>
BoundedDrag::forces_at(std::size_t t, double drop, const Vec3& drag, const std::array<double, 3>& to_wall) const {
    const pores::Throats& throats = network_.throats;
    const WettedGrains grains = wetted_grains(throats, radius_, t);
    const auto shares = drag_shares(grains, layer_[t], to_wall);
    const auto& whole = throats.grain_share[t]; // of sections and, by wetted surface, of the void area
    const double sum = whole[0] + whole[1] + whole[2], surface = throats.solid_surface[t];
    const double void_share = throats.void_area[t] / norm(throats.area[t]);
    std::array<Vec3, 3> force;
    for (std::size_t k = 0; k < 3; ++k) {
        const double section = whole[k] - void_share * (surface > 0 ? grains.area[k] / surface : 1.0 / 3);
        force[k] = (drop * section / sum) * throats.area[t] + shares[k] * drag;
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
    std::vector<double> on_void(throats.size());
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
    std::vector<std::array<Vec3, 3>> found(std::min(throats.size(), stretch));
    for (std::size_t first = 0; first < throats.size(); first += stretch) {
        const std::size_t count = std::min(stretch, throats.size() - first);
        parallel_for(count, block, [&](std::size_t begin, std::size_t end) {
            for (std::size_t t = first + begin; t < first + end; ++t) {
                const auto& [a, b, c] = throats.grain[t];
                const Vec3 drag = exchange_.to_grains(motion, on_void, t);
                found[t - first] = forces_at(t, drop(t), drag, {to_wall[a], to_wall[b], to_wall[c]});
            }
        });
        parallel_for(adders, 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t t = first; t < first + count; ++t) {
                for (std::size_t k = 0; k < 3; ++k) {
                    const std::uint32_t g = throats.grain[t][k];
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
