#include "suffuse/erosion/water_ways.hpp"

#include "suffuse/pores/constrictions.hpp"
#include "suffuse/pores/throat.hpp"
#include "suffuse/pores/voids.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::erosion {
namespace {

constexpr std::size_t most_places = 8; ///< of a grain that is held: a longer queue stays where it was
constexpr double still = 1e-9;         ///< of the mean flux: what is below it is rounding, not a way

template <class T>
std::vector<T> without(const std::vector<T>& column, std::span<const std::uint32_t> rows) {
    std::vector<std::uint8_t> is_left_out(column.size(), 0);
    for (const std::uint32_t g : rows) {
        is_left_out[g] = 1;
    }
    std::vector<T> rest;
    for (std::size_t g = 0; g < column.size(); ++g) {
        if (is_left_out[g] == 0) {
            rest.push_back(column[g]);
        }
    }
    return rest;
}

double mean_size(std::span<const double> flux) {
    double sum = 0;
    for (const double q : flux) {
        sum += std::abs(q);
    }
    return flux.empty() ? 0 : sum / static_cast<double>(flux.size());
}

flow::Seepage solve(
    const cell::Cell& cell, std::span<const Vec3> position, std::span<const double> radius, const Vec3& direction,
    const flow::Fluid& fluid
) {
    flow::Seepage seepage = flow::solve_seepage(cell, position, radius, {1, direction, false}, fluid);
    pores::measure_constrictions(seepage.network, position, radius);
    return seepage;
}

} // namespace

WaterWays::WaterWays(
    const dem::World& world, std::span<const std::uint32_t> leaving, const Vec3& direction, const flow::Fluid& fluid
)
    : position_(without(world.grains.position, leaving)), radius_(without(world.grains.radius, leaving)),
      direction_(squarable(direction) / norm(squarable(direction))),
      seepage_(solve(world.cell, position_, radius_, direction, fluid)), locator_(seepage_.network, position_),
      width_(widths_of_throats()), first_(seepage_.network.bodies + 1, 0) {
    const pores::PoreNetwork& network = seepage_.network;
    const std::vector<double>& flux = seepage_.field.flux;
    const auto side_of = [&](std::size_t t) { return flux[t] > 0 ? std::uint8_t{0} : std::uint8_t{1}; };
    const double least = still * mean_size(flux);
    const auto leads_out = [&](std::size_t t) { return std::abs(flux[t]) > least; };
    const auto body_of = [&](std::size_t t) { return network.pores.body[network.throats.side[t][side_of(t)]]; };
    for (std::size_t t = 0; t < flux.size(); ++t) {
        first_[body_of(t) + 1] += leads_out(t) ? 1 : 0;
    }
    for (std::size_t b = 0; b < network.bodies; ++b) {
        first_[b + 1] += first_[b];
    }
    outlet_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t t = 0; t < flux.size(); ++t) {
        if (leads_out(t)) {
            const std::uint32_t body = body_of(t), k = next[body]++;
            outlet_[k] = {t, side_of(t), (k > first_[body] ? outlet_[k - 1].flux_up_to_it : 0) + std::abs(flux[t])};
        }
    }
}

/// Of the narrowest place on the way from one pore's void sphere to the other's along the points as far from all three
/// grains: where the facet lies between the two that is the circle that touches the three, whose center may be outside
/// the triangle, where the water of a neighbor is. Where both lie on one side the facet only cuts their void, and the
/// smaller of the two is. Without such places it is the room in the facet itself.
std::vector<double> WaterWays::widths_of_throats() const {
    const pores::Throats& throats = seepage_.network.throats;
    const std::vector<pores::VoidSphere> space = pores::void_spheres(seepage_.network, position_, radius_);
    std::vector<double> width(throats.size());
    for (std::size_t t = 0; t < throats.size(); ++t) {
        const pores::VoidSphere &near = space[throats.side[t][0]], &other = space[throats.side[t][1]];
        const Vec3 beyond = other.center + shift(seepage_.network.h, throats.image[t]);
        const double from_near = dot(throats.area[t], near.center - throats.center[t]);
        const double from_other = dot(throats.area[t], beyond - throats.center[t]);
        const double smaller = std::min(near.radius, other.radius), circle = circle_of(t);
        const bool cuts_a_void = from_near * from_other > 0;
        width[t] = 2 * (smaller > 0 && cuts_a_void  ? smaller
                        : smaller > 0 && circle > 0 ? std::min(circle, smaller)
                                                    : throats.inscribed_radius[t]);
    }
    return width;
}

double WaterWays::circle_of(std::size_t t) const {
    const auto [x, r] = pores::spheres_of(seepage_.network, position_, radius_, t);
    return pores::inscribed_circle(x[1] - x[0], x[2] - x[0], r).radius;
}

std::span<const WaterWays::Outlet> WaterWays::outlets(std::uint32_t body) const {
    return std::span(outlet_).subspan(first_[body], first_[body + 1] - first_[body]);
}

/// The periods by which the throat, which has its place with side 0, is moved where it leads out of `place`.
cell::Image WaterWays::image_of_throat(const Outlet& outlet, const Place& place) const {
    const pores::Throats& throats = seepage_.network.throats;
    const std::uint32_t pore = throats.side[outlet.throat][outlet.side];
    const cell::Image here = place.image - seepage_.network.pores.body_image[pore];
    return outlet.side == 0 ? here : here - throats.image[outlet.throat];
}

WaterWays::Place WaterWays::behind(const Outlet& outlet, const cell::Image& throat) const {
    const pores::Throats& throats = seepage_.network.throats;
    const std::uint32_t pore = throats.side[outlet.throat][1 - outlet.side];
    const cell::Image there = outlet.side == 0 ? throat + throats.image[outlet.throat] : throat;
    return {seepage_.network.pores.body[pore], there + seepage_.network.pores.body_image[pore]};
}

Vec3 WaterWays::place_before(const Outlet& outlet, const cell::Image& throat, double radius) const {
    const pores::Throats& throats = seepage_.network.throats;
    const auto [row, image] = pores::grains_of(seepage_.network, outlet.throat);
    std::array<Vec3, 3> center;
    std::array<double, 3> radii{};
    for (std::size_t k = 0; k < 3; ++k) {
        center[k] = position_[row[k]] + shift(seepage_.network.h, image[k] + throat);
        radii[k] = radius_[row[k]];
    }
    const Vec3 downstream = outlet.side == 0 ? throats.area[outlet.throat] : -throats.area[outlet.throat];
    return touching_place(center, radii, radius, -downstream);
}

Journey WaterWays::follow(const Vec3& start, double diameter, double distance, RandomStream chance) const {
    const pores::PoreNetwork& network = seepage_.network;
    const pores::PoreLocator::Place found = locator_.find(start);
    Place place{network.pores.body[found.pore], found.image + network.pores.body_image[found.pore]};
    Journey journey;
    std::vector<Vec3> passed; // centers of the last throats
    Vec3 at = start;
    while (journey.travel < distance) {
        const std::span<const Outlet> ways = outlets(place.body);
        if (ways.empty()) {
            journey.constriction = 0; // still water
            return journey;
        }
        const double drawn = chance.uniform() * ways.back().flux_up_to_it;
        const auto out =
            std::find_if(ways.begin(), ways.end() - 1, [&](const Outlet& way) { return drawn < way.flux_up_to_it; });
        const cell::Image image = image_of_throat(*out, place);
        const Vec3 center = network.throats.center[out->throat] + shift(network.h, image);
        journey.path += norm(center - at);
        journey.travel = dot(center - start, direction_);
        if (width_[out->throat] <= diameter && journey.travel < distance) {
            journey.constriction = std::max(width_[out->throat], 0.0);
            if (!passed.empty()) {
                journey.places.push_back(place_before(*out, image, diameter / 2));
                journey.places.insert(journey.places.end(), passed.rbegin(), passed.rend());
            }
            return journey;
        }
        if (passed.size() == most_places - 1) {
            passed.erase(passed.begin());
        }
        passed.push_back(center);
        ++journey.throats;
        at = center;
        place = behind(*out, image);
    }
    return journey;
}

std::vector<Journey> follow_the_water(
    const dem::World& world, std::span<const Traveller> travellers, const Vec3& direction, const flow::Fluid& fluid
) {
    if (travellers.empty()) {
        return {};
    }
    std::vector<std::uint32_t> rows;
    for (const Traveller& traveller : travellers) {
        rows.push_back(traveller.row);
    }
    const WaterWays ways(world, rows, direction, fluid);
    std::vector<Journey> journeys;
    for (const auto& [g, distance] : travellers) {
        const std::uint64_t when = static_cast<std::uint64_t>(world.clock.step) << 32U;
        const RandomStream chance(world.seed, "transport", when | world.grains.id[g]);
        journeys.push_back(ways.follow(world.grains.position[g], 2 * world.grains.radius[g], distance, chance));
        journeys.back().row = g;
    }
    return journeys;
}

Vec3 touching_place(
    const std::array<Vec3, 3>& center, const std::array<double, 3>& radius, double own, const Vec3& upstream
) {
    // Distances to the three centers are known: differences of their squares are linear in the plane of the centers.
    const Vec3 b = center[1] - center[0], c = center[2] - center[0];
    const std::array<double, 3> reach = {radius[0] + own, radius[1] + own, radius[2] + own};
    const Vec3 across = b / norm(b);
    const Vec3 normal = cross(b, c) / norm(cross(b, c));
    const Vec3 along = cross(normal, across);
    const double x = (reach[0] * reach[0] - reach[1] * reach[1] + norm2(b)) / (2 * norm(b));
    const double y =
        (reach[0] * reach[0] - reach[2] * reach[2] + norm2(c) - 2 * x * dot(c, across)) / (2 * dot(c, along));
    const double height = std::sqrt(std::max(0.0, reach[0] * reach[0] - x * x - y * y));
    return center[0] + x * across + y * along + (dot(normal, upstream) > 0 ? height : -height) * normal;
}

} // namespace suffuse::erosion
