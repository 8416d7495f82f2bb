#include "suffuse/flow/bounded_drag.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/raw_column.hpp"
#include "suffuse/flow/conductance.hpp"
#include "suffuse/flow/passage_area.hpp"
#include "suffuse/flow/throat_drag.hpp"
#include "suffuse/flow/throat_edges.hpp"

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

/// Water between surfaces nearer than this share of the layer's thickness rests. Fitted, as the exponents below.
constexpr double resting_gap = 0.8;

/// At least this share of what is wetted drags.
constexpr double least_open = 0.1;

/// The area of a throat that counts: harmonic2 facet^widening / mean^(1 + widening).
constexpr double widening = 0.2;

/// Areas are no less than this share of the facet.
constexpr double least_area = 1e-3, least_void = 1e-9;

constexpr double nearly = 1 - 1e-9;

/// The water of throat t by solid angles.
ThroatWater
counted_water(const std::array<double, 3>& radius, const std::array<double, 3>& wetted, double hydraulic_radius) {
    return {hydraulic_radius * (wetted[0] + wetted[1] + wetted[2]), {radius, wetted}};
}

/// Area through which the water of a throat goes, of the area vector `area` and the void area given [m2].
double passage_area(
    const pores::ThroatSpheres& spheres, const ThroatEdges& edges, const Vec3& p1, const Vec3& p2, const Vec3& area,
    double void_area
) {
    const auto& [x, r] = spheres;
    const double facet = norm(area);
    Passage passage{0, {}, r};
    double sections = 0, overlaps = 0;
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
        passage.angle[a] =
            a < 2 ? std::atan2(2 * facet, dot(x[b] - x[a], x[c] - x[a])) : pi - passage.angle[0] - passage.angle[1];
        sections += 0.5 * passage.angle[a] * r[a] * r[a];
        overlaps += edges.length(a) < r[a] + r[b] ? lens_of(r[a], r[b], edges.length(a)).half_section : 0;
    }
    // Where sections counted twice exceed the facet, the network keeps the size of the difference alone.
    const double counted = sections - facet > nearly * void_area ? -void_area : void_area;
    passage.facet = std::max(counted + overlaps, least_void * facet);
    const double below = dot(p1 - x[0], area) / facet, above = dot(p2 - x[0], area) / facet;
    const PassageArea found = mean_passage_area(passage, below, above, least_length * std::sqrt(facet));
    const double least = least_area * facet, mean = std::max(found.mean, least);
    const double harmonic = std::max(found.harmonic, least);
    return harmonic * harmonic / mean * std::pow(facet / mean, widening);
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
      least_layer_(thinnest_layer * *std::min_element(radius.begin(), radius.end())), water_(network.throats.size()),
      passage_(network.throats.size()), exchange_(network, measure_water(), exchange_legs(network, position, radius)) {}

RawColumn<double> BoundedDrag::measure_water() {
    const pores::Throats& throats = network_.throats;
    RawColumn<double> drag(throats.size());
    std::vector<double> covered_twice((drag.size() + block - 1) / block);
    parallel_for(drag.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const pores::ThroatSpheres spheres = pores::spheres_of(network_, position_, radius_, t);
            const auto [p1, p2] = pores::centers_around(network_, t);
            const ThroatEdges edges(spheres.center, p1, p2);
            const ThroatWater counted = counted_water(spheres.radius, throats.wetted[t], throats.hydraulic_radius[t]);
            const ThroatWater water = count_overlaps_once(edges, counted);
            const double layer = std::max(least_layer_, water_layer(water.grains, water.volume));
            std::array<double, 3> open = surface_beyond_wedges(edges, counted.grains, resting_gap * layer);
            for (std::size_t k = 0; k < 3; ++k) {
                open[k] = std::max(open[k], least_open * water.grains.area[k]);
            }
            water_[t] = water.volume;
            covered_twice[begin / block] += water.volume - std::max(0.0, counted.volume);
            passage_[t] = passage_area(spheres, edges, p1, p2, throats.area[t], throats.void_area[t]);
            drag[t] = throat_drag(water.grains, open, layer);
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

/// On the three grains of throat t: what acts on their sections, and their shares in the drag of its water. `to_wall`:
/// of each grain.
std::array<Vec3, 3>
BoundedDrag::forces_at(std::size_t t, double drop, const Vec3& drag, std::span<const double> to_wall) const {
    const pores::ThroatGeometry throat = pores::measure_throat(network_, position_, radius_, t);
    const auto [a, b, c] = pores::grains_of(network_, t).row;
    const ThroatWater water =
        counted_water({radius_[a], radius_[b], radius_[c]}, throat.wetted, throat.hydraulic_radius);
    const double layer = std::max(least_layer_, water_layer(water.grains, water.volume));
    const auto shares = drag_shares(water.grains, layer, {to_wall[a], to_wall[b], to_wall[c]});
    const auto& whole = throat.grain_share; // of sections and, by wetted surface, of the void area
    const double sum = network_.throats.covered[t], surface = throat.solid_surface;
    const double void_share = throat.void_area / norm(throat.area);
    std::array<Vec3, 3> force;
    for (std::size_t k = 0; k < 3; ++k) {
        const double section = whole[k] - void_share * (surface > 0 ? throat.wetted[k] / surface : 1.0 / 3);
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
