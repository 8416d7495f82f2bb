#include "suffuse/erosion/water_ways.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::erosion {
namespace {

constexpr std::size_t most_places = 8; ///< of a grain that is held: a longer queue stays where it was

std::vector<std::uint8_t> mark(std::size_t grains, std::span<const std::uint32_t> rows) {
    std::vector<std::uint8_t> is_marked(grains, 0);
    for (const std::uint32_t g : rows) {
        is_marked[g] = 1;
    }
    return is_marked;
}

template <class T>
std::vector<T> without(const std::vector<T>& column, std::span<const std::uint32_t> rows) {
    const std::vector<std::uint8_t> is_left_out = mark(column.size(), rows);
    std::vector<T> rest;
    for (std::size_t g = 0; g < column.size(); ++g) {
        if (is_left_out[g] == 0) {
            rest.push_back(column[g]);
        }
    }
    return rest;
}

} // namespace

WaterWays::WaterWays(
    const dem::World& world, std::span<const std::uint32_t> leaving, const Vec3& direction, const flow::Fluid& fluid
)
    : position_(without(world.grains.position, leaving)), radius_(without(world.grains.radius, leaving)),
      direction_(direction / norm(direction)),
      seepage_(flow::solve_seepage(world.cell, position_, radius_, {1, direction, false}, fluid)),
      locator_(seepage_.network, position_), first_(seepage_.network.bodies + 1, 0) {
    const pores::PoreNetwork& network = seepage_.network;
    const std::vector<double>& flux = seepage_.field.flux;
    const auto side_of = [&](std::size_t t) { return flux[t] > 0 ? std::uint8_t{0} : std::uint8_t{1}; };
    const auto leads_out = [&](std::size_t t) { return flux[t] != 0 && !pores::is_internal(network.throats, t); };
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
    std::array<Vec3, 3> center;
    std::array<double, 3> size{};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t g = throats.grain[outlet.throat][k];
        center[k] = position_[g] + shift(seepage_.network.h, throats.grain_image[outlet.throat][k] + throat);
        size[k] = radius_[g];
    }
    const Vec3 downstream = outlet.side == 0 ? throats.area[outlet.throat] : -throats.area[outlet.throat];
    return touching_place(center, size, radius, -downstream);
}

Journey WaterWays::follow(const Vec3& start, double diameter, double distance, RandomStream chance) const {
    const pores::PoreNetwork& network = seepage_.network;
    const pores::PoreLocator::Place found = locator_.find(start);
    Place place{network.pores.body[found.pore], found.image + network.pores.body_image[found.pore]};
    Journey journey;
    std::vector<Vec3> passed; // centers of the throats
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
        const double width = 2 * network.throats.inscribed_radius[out->throat];
        journey.path += norm(center - at);
        journey.travel = dot(center - start, direction_);
        if (width <= diameter) {
            journey.constriction = std::max(width, 0.0);
            if (!passed.empty()) {
                journey.places.push_back(place_before(*out, image, diameter / 2));
                const std::size_t back = std::min(passed.size(), most_places - 1);
                journey.places.insert(
                    journey.places.end(), passed.rbegin(), passed.rbegin() + static_cast<std::ptrdiff_t>(back)
                );
            }
            return journey;
        }
        passed.push_back(center);
        ++journey.throats;
        at = center;
        place = behind(*out, image);
    }
    return journey;
}

std::vector<Journey> follow_the_water(
    const dem::World& world, std::span<const std::uint32_t> rows, int pass, double distance, const Vec3& direction,
    const flow::Fluid& fluid
) {
    if (rows.empty()) {
        return {};
    }
    const WaterWays ways(world, rows, direction, fluid);
    std::vector<Journey> journeys;
    for (const std::uint32_t g : rows) {
        const std::uint64_t which = (static_cast<std::uint64_t>(pass) << 32U) | world.grains.id[g];
        journeys.push_back(ways.follow(
            world.grains.position[g], 2 * world.grains.radius[g], distance, RandomStream(world.seed, "transport", which)
        ));
        journeys.back().row = g;
    }
    return journeys;
}

Vec3 touching_place(
    const std::array<Vec3, 3>& center, const std::array<double, 3>& radius, double size, const Vec3& upstream
) {
    // Distances to the three centers are known: differences of their squares are linear in the plane of the centers.
    const Vec3 b = center[1] - center[0], c = center[2] - center[0];
    const std::array<double, 3> reach = {radius[0] + size, radius[1] + size, radius[2] + size};
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
