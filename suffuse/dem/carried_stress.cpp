#include "suffuse/dem/carried_stress.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/inspect.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::dem {
namespace {

/// Of all contacts, over the smaller radius [-].
double mean_overlap(const World& world) {
    double sum = 0;
    std::int64_t count = 0;
    for (std::size_t c = 0; c < world.contacts.size(); ++c) {
        if (world.contacts.touches(c)) {
            const std::vector<double>& radius = world.grains.radius;
            sum +=
                world.contacts.overlap[c] / std::min(radius[world.contacts.first[c]], radius[world.contacts.second[c]]);
            ++count;
        }
    }
    return count > 0 ? sum / static_cast<double>(count) : 0;
}

} // namespace

double require_pressure(const World& world, const Mat3& stress, std::string_view who_needs_it) {
    constexpr double most_overlap = 0.2; // a void ratio of some 0.2: soft grains under high stresses stay below it
    const double pressure = mean_stress(stress);
    if (!(pressure > 0)) {
        throw StateError(fmt::format(
            "{} that carries a stress, but the mean stress of this one is {:.4g} kPa: compact or settle it under a "
            "pressure first",
            who_needs_it, pressure / 1e3
        ));
    }
    if (const double overlap = mean_overlap(world); overlap > most_overlap) {
        throw StateError(fmt::format(
            "{} of grains that touch, and those of this one overlap by {:.0f} % of the smaller radius in the mean, at "
            "a void ratio of {:.2g}: check that radii are not diameters and that the cell is theirs; a cloud that is "
            "compacted has no such overlaps",
            who_needs_it, 100 * overlap, void_ratio(world)
        ));
    }
    return pressure;
}

} // namespace suffuse::dem
