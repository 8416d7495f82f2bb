#pragma once
// The largest stable time step of the explicit scheme, from the stiffest mode of the contact network: translations and
// rotations coupled, rolling and twisting springs included.

#include "suffuse/dem/spec.hpp"
#include "suffuse/dem/world.hpp"

namespace suffuse::dem {

/// Share of the stability limit that is taken: the power iteration is a few percent low, and contacts come and go.
inline constexpr double default_step_safety = 0.82;

inline constexpr int usual_iterations = 40; ///< of the power method

/// A grain as its springs feel it.
struct Inertia {
    double radius = 0;  ///< [m]
    double mass = 0;    ///< [kg]
    double turning = 0; ///< moment of inertia [kg m2]
};

/// Highest angular frequency of the network of touching contacts [rad/s], before the first step of those that overlap;
/// 0 without contacts. All of them stick, but for frictionless grains at rest in rotation: only their normal springs
/// act. Power iteration on M^-1 K: it comes from below, within a few percent after `iterations`.
/// @param least_overlap over the smaller radius, that contacts are taken to have at least, under laws that stiffen
double highest_frequency(const World& world, int iterations = usual_iterations, double least_overlap = 0);

/// Highest angular frequency of two free grains that touch [rad/s], in closed form: pressed together; slipping and
/// rolling, which grains of unequal size couple; twisting. @param material of the linear law (contact::linearized);
/// @param shear_ratio that of the material, or 0 without shear
double
pair_frequency(const grains::Material& material, double shear_ratio, const Inertia& first, const Inertia& second);

/// What the motion to come will be like, besides the state of the world.
struct MotionToCome {
    double damping = usual_damping; ///< local [-]
    double pressure = 0;            ///< that the sample is to bear soon, if more than it does [Pa]
};

/// Of the largest stable step, 2 over the frequency, what dampers leave [-]: a force that brakes is raised to 1 +
/// `damping` times itself, and viscous dampers see velocities half a step late. @param viscous share of the critical
/// one
double share_when_damped(double damping, double viscous);

/// The longest stable step of the contacts that touch, and of any that may come where each is a lone pair [s]: of two
/// equal grains, or of one and the largest. Under laws that stiffen, all count as they will be under the pressure to
/// come, or what the world holds now, and twice as far in.
double stability_limit(const World& world, const MotionToCome& to_come = {});

/// How much quicker a grain with several neighbors is than a lone pair, at most: seen, 2.1 times.
inline constexpr double quicker_than_pair = 2;

/// `safety` x the stability limit [s]. While fewer contacts touch than there are grains, many may come within a burst:
/// each pair then counts as `quicker_than_pair`. Look again when `network_has_grown`.
double stable_time_step(const World& world, const MotionToCome& to_come = {}, double safety = default_step_safety);

/// Longer steps blow a sample up, or heat it while it seems to settle. @param damping local [-]
/// @throws CaseError where a specified time step [s] is beyond the stability limit of the world as it
/// is, or of any two of its grains.
void check_time_step(const World& world, double wanted, double damping);

inline constexpr std::int64_t time_step_interval = 1000; ///< steps after which a computed time step is computed again

/// Whether so many more contacts touch than when the time step was computed that it may be too long now: with them a
/// vibration would grow within a burst until they slip.
inline bool network_has_grown(std::int64_t contacts, std::int64_t known_contacts) {
    constexpr double denser = 1.2;
    return static_cast<double>(contacts) > denser * static_cast<double>(known_contacts);
}

/// Whether a computed time step is to be computed again, after `steps`.
inline bool time_step_is_due(std::int64_t steps, std::int64_t contacts, std::int64_t known_contacts) {
    return steps % time_step_interval == 0 || network_has_grown(contacts, known_contacts);
}

/// A computed time step.
struct ComputedStep {
    double time_step = 0;            ///< [s]
    std::int64_t known_contacts = 0; ///< touching when it was computed
};

/// Steps of `work`, a ComputedStep or what has its members, are `time_step` [s] from now on.
template <class Work>
void take_time_step(Work& work, double time_step, std::int64_t contacts) {
    work.time_step = time_step;
    work.known_contacts = contacts;
}

/// Computes the time step of `work`, a ComputedStep or what has its members, again where that is due after `steps`.
/// @param contacts that touch now; @param compute gives the step [s]
template <class Work, class Compute>
void renew_time_step(Work& work, std::int64_t steps, std::int64_t contacts, const Compute& compute) {
    if (time_step_is_due(steps, contacts, work.known_contacts)) {
        take_time_step(work, compute(), contacts);
    }
}

} // namespace suffuse::dem
