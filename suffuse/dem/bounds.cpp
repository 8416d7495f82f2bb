#include "suffuse/dem/bounds.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/contact/springs.hpp"
#include "suffuse/dem/first_contacts.hpp"
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

/// A grain, and how fast its fastest point is against the mean motion [m/s].
struct FastGrain {
    std::size_t grain = 0;
    double speed = 0;
};

/// That of a grain against the mean motion, or of its surface as it spins.
double speed_of(const World& world, std::size_t g) {
    const grains::Grains& grains = world.grains;
    const Vec3 own = grains.velocity[g] - world.cell.velocity_gradient * grains.position[g];
    return std::max(norm(own), grains.radius[g] * norm(grains.spin[g]));
}

/// Not a number counts as the fastest.
FastGrain fastest_grain(const World& world) {
    const auto faster = [](const FastGrain& a, const FastGrain& b) {
        return a.speed >= b.speed || std::isnan(a.speed) ? a : b;
    };
    return parallel_sum(
        world.grains.size(), 4096, FastGrain{},
        [&](std::size_t begin, std::size_t end) {
            FastGrain fastest;
            for (std::size_t g = begin; g < end; ++g) {
                fastest = faster(fastest, {g, speed_of(world, g)});
            }
            return fastest;
        },
        faster
    );
}

/// Of the lighter grain of a contact whose spring lets go [m/s], the largest.
double speed_in_springs(const World& world, const contact::Contacts& contacts) {
    const grains::Grains& grains = world.grains;
    const contact::Spring& spring = contact::spring_of(world.material);
    double square = 0;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        const std::uint32_t i = contacts.first[c], j = contacts.second[c];
        const double energy = spring.energy(world.material, grains.radius[i], grains.radius[j], contacts.overlap[c]);
        square = std::max(square, 2 * energy / std::min(grains.mass[i], grains.mass[j]));
    }
    return std::sqrt(square);
}

/// That a grain may gain in so much time from forces that act on it from outside the skeleton [m/s], the largest.
double speed_under_load(const World& world, const StepPlan& plan, double time) {
    double acceleration = 0;
    for (std::size_t g = 0; plan.load != nullptr && g < plan.load->force.size(); ++g) {
        acceleration = std::max(acceleration, norm(plan.load->force[g]) / world.grains.mass[g]);
    }
    return acceleration * time;
}

/// Between the ends of the cell, as it deforms [m/s].
double speed_of_ends(const World& world, const cell::Loading& loading) {
    const Mat3 ends = world.cell.velocity_gradient * world.cell.h;
    const double most = std::max({norm(ends.column(0)), norm(ends.column(1)), norm(ends.column(2))});
    const double width =
        std::max({norm(world.cell.h.column(0)), norm(world.cell.h.column(1)), norm(world.cell.h.column(2))});
    return std::max(most, largest_rate_of(loading) * width);
}

/// Of the axes, now and by the stages before [Pa].
double largest_to_hold(const World& world, const cell::Loading& loading) {
    const Vec3& held = world.servo.held_stress;
    double largest = std::max({0.0, held.x, held.y, held.z});
    for (const cell::AxisControl& axis : loading.axis) {
        largest = std::max(largest, axis.control == cell::Control::StrainRate ? 0 : axis.value);
    }
    return largest;
}

} // namespace

void check_strain_of_step(const cell::Loading& loading, double dt) {
    const double rate = largest_rate_of(loading);
    if (rate * dt > most_strain_of_step) {
        throw StateError(fmt::format(
            "a rate of {:.3g} 1/s strains the cell by {:.3g} in one step of {:.2e} s, and grains would pass through "
            "each other: take {:.2g} 1/s at most, or a shorter time step",
            rate, rate * dt, dt, most_strain_of_step / dt
        ));
    }
}

void check_room(const World& world) {
    const double room = void_ratio(world) + 1;
    if (room < least_room) {
        throw StateError(fmt::format(
            "the cell has shrunk to {:.2f} of the volume of its grains, whose overlaps are no longer meaningful: "
            "strain it less, lower the stress, or take stiffer grains",
            room
        ));
    }
    if (room > most_room) {
        throw StateError(fmt::format(
            "the cell has grown to {:.1e} times the volume of its grains, which no longer touch: strain it less", room
        ));
    }
}

MotionBefore look_before(const World& world, bool is_new) {
    MotionBefore before;
    const FastGrain fastest = fastest_grain(world);
    if (std::isnan(fastest.speed)) { // check_motion does not let a step leave it so
        throw StateError(fmt::format(
            "the position, velocity or spin of grain {} is not a number before the first step: it was set to that",
            world.grains.id[fastest.grain]
        ));
    }
    const double in_springs = speed_in_springs(world, is_new ? find_first_contacts(world) : world.contacts);
    before.speed = std::max(fastest.speed, in_springs);
    if (!is_new) {
        before.stress = world.servo.stress;
    }
    return before;
}

void check_motion(
    const World& world, const StepPlan& plan, std::int64_t steps, const Mat3& stress, const MotionBefore& before
) {
    const double given = before.speed + speed_under_load(world, plan, static_cast<double>(steps) * plan.dt) +
                         speed_of_ends(world, plan.loading);
    const FastGrain fastest = fastest_grain(world);
    if (!(fastest.speed <= most_speed * given)) {
        const std::size_t g = fastest.grain;
        throw StateError(fmt::format(
            "at step {} grain {} moves at {:.2g} m/s and spins at {:.2g} rad/s, where grains, springs and loading "
            "allow {:.2g} m/s: the motion has become unstable; take a smaller time step than {:.3g} s",
            world.clock.step, world.grains.id[g], norm(world.grains.velocity[g]), norm(world.grains.spin[g]), given,
            plan.dt
        ));
    }
    const double held = largest_to_hold(world, plan.loading), driven = world.material.density * given * given;
    for (int a = 0; a < 3 && before.stress && held > 0; ++a) {
        const double found = stress(a, a);
        const bool holds = plan.loading.axis[static_cast<std::size_t>(a)].control != cell::Control::StrainRate;
        const bool rises = found > (*before.stress)[a];
        if (holds && rises && found > most_stress * (held + driven)) {
            throw StateError(fmt::format(
                "at step {} the sample carries {:.3g} kPa along {}, where {:.3g} kPa are held, and grain {} moves at "
                "{:.2g} m/s: the motion has become unstable; take a smaller time step than {:.3g} s",
                world.clock.step, found / 1e3, "xyz"[a], held / 1e3, world.grains.id[fastest.grain], fastest.speed,
                plan.dt
            ));
        }
    }
}

} // namespace suffuse::dem
