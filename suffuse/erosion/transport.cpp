#include "suffuse/erosion/transport.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/erosion/lodging.hpp"
#include "suffuse/erosion/water_ways.hpp"
#include "suffuse/pores/widest_path.hpp"

#include <fmt/format.h>

#include <cmath>
#include <unordered_map>

namespace suffuse::erosion {
namespace {

constexpr double same_place = 1e-3; ///< of the radius: one that lodged here before, and does so again, has stayed
constexpr double most_cells = 1000; ///< to travel through; the images of a place are counted in 16 bits

/// Along the flow [m].
double specified_distance(const Mat3& h, const ErodeSpec& spec) {
    const double length =
        std::abs(dot(h.column(pores::axis_along(h, spec.direction)), spec.direction)) / norm(spec.direction);
    const double distance = spec.transport_distance.value_or(length);
    if (distance > most_cells * length) {
        throw StateError(fmt::format(
            "grains are to travel {:.4g} m through a cell of {:.4g} m: specify a distance of at most {:g} cells",
            distance, length, most_cells
        ));
    }
    return distance;
}

/// How far along the flow grains lie from where the erosion found them, by id; one that never moved is left out.
std::unordered_map<std::uint32_t, double> progress_so_far(const ErosionResult& so_far) {
    std::unordered_map<std::uint32_t, double> progress;
    for (const PassResult& pass : so_far.passes) {
        for (std::size_t k = 0; k < pass.transport.size(); ++k) {
            progress[pass.transport.id[k]] = pass.transport.progress[k];
        }
    }
    return progress;
}

void add_row(const grains::Grains& grains, const Journey& journey, Fate fate, double progress, Transport& transport) {
    transport.id.push_back(grains.id[journey.row]);
    transport.diameter.push_back(2 * grains.radius[journey.row]);
    transport.mass.push_back(grains.mass[journey.row]);
    transport.travel.push_back(journey.travel);
    transport.progress.push_back(progress);
    transport.path.push_back(journey.path);
    transport.throats.push_back(journey.throats);
    transport.constriction.push_back(journey.constriction.value_or(0));
    transport.fate.push_back(fate);
}

} // namespace

Fate fate_of(bool leaves, const std::optional<Vec3>& place, const Vec3& position, double radius) {
    if (leaves) {
        return Fate::Left;
    }
    return place && norm(*place - position) > same_place * radius ? Fate::Lodged : Fate::Stayed;
}

std::vector<std::uint32_t> transport_fines(
    dem::World& world, std::span<const std::uint32_t> detached, const ErodeSpec& spec, const flow::Fluid& fluid,
    const ErosionResult& so_far, PassResult& pass
) {
    const Vec3 along = spec.direction / norm(spec.direction);
    pass.transport.distance = specified_distance(world.cell.h, spec);
    std::unordered_map<std::uint32_t, double> progress = progress_so_far(so_far);
    std::vector<Traveller> travellers;
    for (const std::uint32_t g : detached) {
        travellers.push_back({g, pass.transport.distance - progress[world.grains.id[g]]});
    }
    const std::vector<Journey> journeys = follow_the_water(world, travellers, spec.direction, fluid);
    const std::vector<std::optional<Vec3>> places = find_places(world, journeys);
    std::vector<std::uint32_t> left, lodged;
    std::vector<Vec3> lodged_at;
    for (std::size_t j = 0; j < journeys.size(); ++j) {
        const std::uint32_t g = journeys[j].row;
        const double before = progress[world.grains.id[g]];
        const Fate fate =
            fate_of(!journeys[j].constriction, places[j], world.grains.position[g], world.grains.radius[g]);
        double moved = 0;
        if (fate == Fate::Left) {
            moved = journeys[j].travel;
            left.push_back(g);
        } else if (fate == Fate::Lodged) {
            moved = dot(*places[j] - world.grains.position[g], along);
            lodged.push_back(g), lodged_at.push_back(*places[j]);
        }
        add_row(world.grains, journeys[j], fate, before + moved, pass.transport);
    }
    dem::relocate_grains(world, lodged, lodged_at);
    return left;
}

} // namespace suffuse::erosion
