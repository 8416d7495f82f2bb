#include "suffuse/erosion/feeding.hpp"

#include "suffuse/base/random.hpp"
#include "suffuse/erosion/filled_space.hpp"
#include "suffuse/erosion/planes_across.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace suffuse::erosion {
namespace {

constexpr int most_tries = 200; ///< to find a free place at the face

/// One of the grains that the sample had.
std::size_t draw_like(const MigrationLedger& ledger, const dem::World& world, std::int64_t number) {
    const auto of_sample = static_cast<double>(std::ranges::count_if(ledger.entered, [](double t) { return t < 0; }));
    RandomStream chance(world.seed, "sizes of fines that enter", static_cast<std::uint64_t>(number));
    return static_cast<std::size_t>(chance.uniform() * of_sample); // they are the first rows
}

/// Just behind the face where the water enters [m].
std::optional<Vec3> find_place(
    const dem::World& world, const FilledSpace& space, const Vec3& direction, double radius, std::int64_t number,
    double time
) {
    const Mat3& h = world.cell.h;
    const int axis = pores::axis_along(h, direction);
    const Vec3 behind = radius / norm(direction) * direction;
    const auto moment = static_cast<std::uint64_t>(std::llround(1e9 * time)); // anew each time
    RandomStream chance(world.seed, "places of fines that enter", moment ^ (static_cast<std::uint64_t>(number) << 40U));
    for (int k = 0; k < most_tries; ++k) {
        Vec3 share;
        share[(axis + 1) % 3] = chance.uniform();
        share[(axis + 2) % 3] = chance.uniform();
        const Vec3 place = h * share + behind;
        if (space.is_free(place, radius, static_cast<std::uint32_t>(world.grains.size()))) {
            return place;
        }
    }
    return std::nullopt;
}

void add_row(const dem::World& world, std::uint32_t g, const MigrateSpec& spec, double time, MigrationLedger& ledger) {
    const grains::Grains& grains = world.grains;
    const double radius = grains.radius[g];
    ledger.id.push_back(grains.id[g]);
    ledger.diameter.push_back(2 * radius);
    ledger.mass.push_back(grains.mass[g]);
    for (std::vector<Vec3>* place : {&ledger.start, &ledger.end, &ledger.before}) {
        place->push_back(grains.position[g]);
    }
    ledger.to_exit.push_back(spec.exit ? *spec.exit - radius : period_along(world.cell.h, spec.direction));
    ledger.entered.push_back(time);
    ledger.departed.push_back(-1);
    ledger.departed_at.push_back(0);
    ledger.left.push_back(-1);
    ledger.passed.emplace_back();
    ledger.where.push_back(Whereabouts::Stayed);
    ledger.goes.push_back(0);
}

} // namespace

double feed_fines(
    dem::World& world, MigrationLedger& ledger, Feeding& feeding, const MigrateSpec& spec, double water, double time
) {
    feeding.waiting += spec.feed.value_or(0) * water;
    std::size_t like = draw_like(ledger, world, feeding.drawn);
    if (feeding.waiting < ledger.mass[like]) {
        return 0;
    }
    FilledSpace space(world.cell.h, *std::ranges::max_element(ledger.diameter), world.grains.size());
    for (std::uint32_t g = 0; g < world.grains.size(); ++g) {
        space.fill(world.grains.position[g], world.grains.radius[g], g);
    }
    std::uint32_t id = *std::ranges::max_element(world.grains.id);
    id = std::max(id, *std::ranges::max_element(ledger.id));
    double entered = 0;
    while (feeding.waiting >= ledger.mass[like]) {
        const double radius = 0.5 * ledger.diameter[like];
        const auto place = find_place(world, space, spec.direction, radius, feeding.drawn, time);
        if (!place) {
            break;
        }
        const std::uint32_t g = add_grain(world.grains, *place, radius, world.material.density);
        world.grains.id[g] = ++id;
        world.grains.fine[g] = 1;
        space.fill(*place, radius, g);
        add_row(world, g, spec, time, ledger);
        feeding.waiting -= world.grains.mass[g];
        entered += world.grains.mass[g];
        like = draw_like(ledger, world, ++feeding.drawn);
    }
    return entered;
}

} // namespace suffuse::erosion
