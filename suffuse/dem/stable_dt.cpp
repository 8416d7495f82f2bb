#include "suffuse/dem/stable_dt.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/contact/springs.hpp"
#include "suffuse/contact/stress.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/spring_network.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace suffuse::dem {
namespace {

/// Of a mode: their quotient is the square of its frequency.
struct ModeSums {
    double energy = 0, inertia = 0;

    ModeSums operator+(const ModeSums& b) const { return {energy + b.energy, inertia + b.inertia}; }
};

/// How far contacts are in before a time step is looked at again, over the smaller radius; of springs that stiffen
/// with it.
struct OverlapToCome {
    double mean = 0; ///< of those that touch, under the stresses that the sample is to bear
    double most = 0; ///< of those that may come
};

constexpr double overlap_growth = 2; // until the step is looked at again

/// Of the fastest grain where a fixed equal one stops it.
double overlap_of_impact(const World& world) {
    double speed2 = 0; // against the mean motion
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        speed2 =
            std::max(speed2, norm2(world.grains.velocity[g] - world.cell.velocity_gradient * world.grains.position[g]));
    }
    return contact::spring_of(world.material).overlap_of_impact(world.material, speed2);
}

OverlapToCome overlap_to_come(const World& world, double pressure) {
    constexpr double least = 1e-4, of_chains = 4; // over the mean: overlaps of the strongest contacts
    const grains::Grains& grains = world.grains;
    const contact::Contacts& contacts = world.contacts;
    double seen = 0;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        const double smaller = std::min(grains.radius[contacts.first[c]], grains.radius[contacts.second[c]]);
        seen = std::max(seen, contacts.overlap[c] / smaller);
    }
    const Vec3& held = world.servo.held_stress;
    const double mean = contact::mean_overlap_at(world.material, std::max({pressure, held.x, held.y, held.z}));
    return {mean, std::max({least, overlap_of_impact(world), overlap_growth * seen, of_chains * mean})};
}

SpringNetwork network_of(const World& world, double least_overlap) {
    const double shear_ratio = contact::spring_of(world.material).shear_ratio(world.material);
    return {world, contacts_only_push(world) ? 0 : shear_ratio, least_overlap};
}

/// Of the network of the world's contacts [rad/s].
double highest_frequency(const World& world, const SpringNetwork& network, int iterations) {
    const grains::Grains& grains = world.grains;
    Motions x{std::vector<Vec3>(grains.size()), std::vector<Vec3>(grains.size())};
    Motions force{std::vector<Vec3>(network.rows()), std::vector<Vec3>(network.rows())};
    for (std::size_t g = 0; g < grains.size(); ++g) { // any start that is not orthogonal to the stiffest mode
        const double phase = 1.7 * static_cast<double>(g);
        x.shift[g] = {std::sin(phase), std::cos(1.3 * phase), std::sin(2.1 * phase)};
        x.turn[g] = (1 / grains.radius[g]) * Vec3{std::cos(phase), std::sin(1.9 * phase), std::cos(2.3 * phase)};
    }
    constexpr std::size_t block = 1024;
    double square = 0;
    for (int k = 0; k < iterations; ++k) {
        network.apply(x, force);

        const auto [energy, inertia] =
            parallel_sum(grains.size(), block, ModeSums{}, [&](std::size_t begin, std::size_t end) {
                ModeSums sum;
                for (std::size_t g = begin; g < end; ++g) {
                    sum.energy += dot(x.shift[g], force.shift[g]) + dot(x.turn[g], force.turn[g]);
                    sum.inertia += grains.mass[g] * norm2(x.shift[g]) + grains.inertia[g] * norm2(x.turn[g]);
                }
                return sum;
            });
        if (!(energy > 0)) {
            return 0;
        }
        square = energy / inertia;
        const double scale = 1 / (square * std::sqrt(inertia));
        parallel_for(grains.size(), block, [&](std::size_t begin, std::size_t end) {
            for (std::size_t g = begin; g < end; ++g) {
                x.shift[g] = scale / grains.mass[g] * force.shift[g];
                x.turn[g] = scale / grains.inertia[g] * force.turn[g];
            }
        });
    }
    return std::sqrt(square);
}

/// Of the stiffest modes [rad/s].
struct Frequencies {
    double network = 0;       ///< of the contacts that touch
    double pair = 0;          ///< of two grains that may touch: equal ones, or one and the largest
    std::size_t contacts = 0; ///< that touch
};

Frequencies highest_frequencies(const World& world, double pressure) {
    const grains::Grains& grains = world.grains;
    const contact::Spring& spring = contact::spring_of(world.material);
    const OverlapToCome overlap = spring.stiffens ? overlap_to_come(world, pressure) : OverlapToCome{};
    const grains::Material material = contact::linearized(world.material, overlap.most);
    const double shear_ratio = contacts_only_push(world) ? 0 : material.shear_ratio;
    const auto grain = [&](std::size_t g) { return Inertia{grains.radius[g], grains.mass[g], grains.inertia[g]}; };
    const auto largest =
        static_cast<std::size_t>(std::max_element(grains.radius.begin(), grains.radius.end()) - grains.radius.begin());
    const double stiffer = std::pow(overlap_growth, 0.5 * (spring.exponent(world.material) - 1)); // as a frequency
    const SpringNetwork network = network_of(world, overlap.mean);
    Frequencies highest{stiffer * highest_frequency(world, network, usual_iterations), 0, network.contacts()};
    for (std::size_t g = 0; g < grains.size(); ++g) {
        for (const std::size_t other : {g, largest}) {
            highest.pair = std::max(highest.pair, pair_frequency(material, shear_ratio, grain(g), grain(other)));
        }
    }
    return highest;
}

/// The longest stable step of a vibration of that frequency [s].
double limit_of(double frequency, const World& world, const MotionToCome& to_come) {
    return share_when_damped(to_come.damping, world.material.viscous_damping) * 2 / frequency;
}

} // namespace

double highest_frequency(const World& world, int iterations, double least_overlap) {
    return highest_frequency(world, network_of(world, least_overlap), iterations);
}

double
pair_frequency(const grains::Material& material, double shear_ratio, const Inertia& first, const Inertia& second) {
    const double r1 = first.radius, r2 = second.radius;
    const double kn = contact::normal_stiffness(material, r1, r2, 0), ks = shear_ratio * kn, arm = ks * r1 * r2;
    const double lightness = 1 / first.mass + 1 / second.mass, agility = 1 / first.turning + 1 / second.turning;
    // Shear and rolling spring each act along one direction of (shift, turn, turn), scaled by the roots of the inertia:
    // of the two modes that they span, the higher.
    const double slip = ks * (lightness + r1 * r1 / first.turning + r2 * r2 / second.turning);
    const double roll = material.rolling_stiffness * arm * agility;
    const double lever = r1 / first.turning - r2 / second.turning;
    const double coupling = ks * material.rolling_stiffness * arm * lever * lever;
    const double half = 0.5 * (slip - roll);
    const double rolling = 0.5 * (slip + roll) + std::sqrt(half * half + coupling);
    return std::sqrt(std::max({kn * lightness, rolling, material.twisting_stiffness * arm * agility}));
}

double share_when_damped(double damping, double viscous) {
    const double raised = 1 + damping, z2 = viscous * viscous * raised; // of stiffness, and of the damper
    return (std::sqrt(1 + z2) - std::sqrt(z2)) / std::sqrt(raised);
}

double stability_limit(const World& world, const MotionToCome& to_come) {
    const auto [network, pair, contacts] = highest_frequencies(world, to_come.pressure);
    return limit_of(std::max(network, pair), world, to_come);
}

double stable_time_step(const World& world, const MotionToCome& to_come, double safety) {
    const auto [network, pair, contacts] = highest_frequencies(world, to_come.pressure);
    const double quicker = contacts < world.grains.size() ? quicker_than_pair : 1;
    return safety * limit_of(std::max(network, quicker * pair), world, to_come);
}

void check_time_step(const World& world, double wanted, double damping) {
    const double limit = stability_limit(world, {damping});
    if (!(wanted <= limit)) {
        throw CaseError(fmt::format(
            "time_step: found {:.4g} ns, expected at most {:.4g} ns, beyond which this sample is unstable; leave it "
            "out to have it computed",
            1e9 * wanted, 1e9 * limit
        ));
    }
}

} // namespace suffuse::dem
