#include "suffuse/dem/bounds.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/inspect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::dem {
namespace {

/// The largest that is prescribed [1/s].
double largest_rate_of(const cell::Loading& loading) {
    double largest = 0;
    if (loading.velocity_gradient) {
        for (const auto& row : loading.velocity_gradient->m) {
            for (const double rate : row) {
                largest = std::max(largest, std::abs(rate));
            }
        }
        return largest;
    }
    for (const cell::AxisControl& axis : loading.axis) {
        if (axis.control == cell::Control::StrainRate) {
            largest = std::max(largest, std::abs(axis.value));
        }
    }
    return largest;
}

} // namespace

void check_strain_of_step(const cell::Loading& loading, double dt) {
    const double rate = largest_rate_of(loading);
    if (rate * dt > most_strain_of_step) {
        throw StateError(fmt::format(
            "a rate of {:.3g} 1/s strains the cell by {:.3g} in one step of {:.2e} s, and grains would pass through "
            "each "
            "other: take {:.2g} 1/s at most, or a shorter time step",
            rate, rate * dt, dt, most_strain_of_step / dt
        ));
    }
}

void check_room(const World& world) {
    const double room = void_ratio(world) + 1;
    if (room < least_room) {
        throw StateError(fmt::format(
            "the cell has shrunk to {:.2f} of the volume of its grains, which overlap beyond any meaning: strain it "
            "less, "
            "lower the stress, or take stiffer grains",
            room
        ));
    }
    if (room > most_room) {
        throw StateError(fmt::format(
            "the cell has grown to {:.1e} times the volume of its grains, which touch nowhere any more: strain it less",
            room
        ));
    }
}

} // namespace suffuse::dem
