#include "suffuse/erosion/transport.hpp"

#include "suffuse/dem/order.hpp"
#include "suffuse/erosion/lodging.hpp"
#include "suffuse/erosion/water_ways.hpp"
#include "suffuse/pores/widest_path.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::erosion {
namespace {

/// The cell's length along the flow [m].
double length_along(const Mat3& h, const Vec3& direction) {
    return std::abs(dot(h.column(pores::axis_along(h, direction)), direction)) / norm(direction);
}

Transport describe(
    const grains::Grains& grains, std::span<const Journey> journeys, std::span<const std::optional<Vec3>> places,
    double distance
) {
    Transport transport;
    transport.distance = distance;
    for (std::size_t j = 0; j < journeys.size(); ++j) {
        const Journey& journey = journeys[j];
        transport.id.push_back(grains.id[journey.row]);
        transport.diameter.push_back(2 * grains.radius[journey.row]);
        transport.mass.push_back(grains.mass[journey.row]);
        transport.travel.push_back(journey.travel);
        transport.path.push_back(journey.path);
        transport.throats.push_back(journey.throats);
        transport.constriction.push_back(journey.constriction.value_or(0));
        transport.fate.push_back(!journey.constriction ? Fate::Left : places[j] ? Fate::Lodged : Fate::Stayed);
    }
    return transport;
}

} // namespace

std::vector<std::uint32_t> carry_off(
    dem::World& world, std::span<const std::uint32_t> detached, const ErodeSpec& spec, const flow::Fluid& fluid,
    PassResult& pass
) {
    const double distance = spec.transport_distance.value_or(length_along(world.cell.h, spec.direction));
    const std::vector<Journey> journeys = follow_the_water(world, detached, pass.pass, distance, spec.direction, fluid);
    const std::vector<std::optional<Vec3>> places = find_places(world, journeys);
    pass.transport = describe(world.grains, journeys, places, distance);
    std::vector<std::uint32_t> left, lodged;
    std::vector<Vec3> lodged_at;
    for (std::size_t j = 0; j < journeys.size(); ++j) {
        if (pass.transport.fate[j] == Fate::Left) {
            left.push_back(journeys[j].row);
        } else if (places[j]) {
            lodged.push_back(journeys[j].row);
            lodged_at.push_back(*places[j]);
        }
    }
    dem::relocate_grains(world, lodged, lodged_at);
    return left;
}

std::optional<double> filter_coefficient(const Transport& transport) {
    double held = 0, travelled = 0;
    for (std::size_t k = 0; k < transport.size(); ++k) {
        held += transport.fate[k] == Fate::Left ? 0 : transport.mass[k];
        travelled += transport.mass[k] * std::clamp(transport.travel[k], 0.0, transport.distance);
    }
    return travelled > 0 ? std::optional(held / travelled) : std::nullopt;
}

} // namespace suffuse::erosion
