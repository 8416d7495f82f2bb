#include "suffuse/dem/energy.hpp"

#include "suffuse/base/parallel.hpp"
#include "suffuse/contact/one_contact.hpp"
#include "suffuse/contact/springs.hpp"
#include "suffuse/contact/stress.hpp"
#include "suffuse/contact/sum_touching.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::dem {
namespace {

using contact::Triple;

constexpr std::size_t grains_a_block = 1024;

Triple<double> triple(const Vec3& v) {
    return {v.x, v.y, v.z};
}

/// What a spring gives away that is stretched to `trial` and holds no more than `limit` [J].
double taken_beyond(const Triple<double>& trial, double limit, double stiffness) {
    const double length = std::sqrt(dot(trial, trial));
    return length > limit && stiffness > 0 ? limit * (length - limit) / stiffness : 0;
}

/// Of a linear spring [J]. @param force2 square of what it carries
double held_in(double force2, double stiffness) {
    return stiffness > 0 ? 0.5 * force2 / stiffness : 0;
}

/// What the law takes from each contact in the step to come [J], in which the cell deforms as before.
struct NextStep {
    const World& world;
    contact::LawConstants law;
    Mat3 image_velocity, h;
    double dt;

    NextStep(const World& w, double step)
        : world(w), law(contact::resolve_law(w.material)), image_velocity(w.cell.velocity_gradient * w.cell.h),
          h(w.cell.h + step * image_velocity), dt(step) {}

    void take_from(std::size_t c, Dissipation& taken) const {
        const grains::Grains& grains = world.grains;
        const contact::Contacts& contacts = world.contacts;
        const std::uint32_t i = contacts.first[c], j = contacts.second[c];
        const Vec3 branch = grains.position[j] + cell::shift(h, contacts.image[c]) - grains.position[i];
        const Vec3 velocity = grains.velocity[j] + cell::shift(image_velocity, contacts.image[c]) - grains.velocity[i];
        const contact::GrainPair<double> pair{triple(branch),         triple(velocity), triple(grains.spin[i]),
                                              triple(grains.spin[j]), grains.radius[i], grains.radius[j]};
        const bool twists = contacts.twisting.size() > 0, bonds = !contacts.bonded.empty();
        contact::ContactMemory<double> memory{
            triple(contacts.shear_force[c]), triple(contacts.bending[c]),
            twists ? triple(contacts.twisting[c]) : Triple<double>{}, triple(contacts.normal[c]),
            bonds ? static_cast<double>(contacts.bonded[c]) : 0.0};
        const contact::ContactGeometry<double> geometry =
            contact::find_geometry(law, pair.branch, pair.radius_1, pair.radius_2);
        const double opening = dot(geometry.normal, pair.velocity);
        taken.slip += taken_by_new_area(pair, geometry, opening, memory);
        contact::let_go(law, geometry, opening, dt, memory);
        const contact::Limits<double> limits = contact::predict_forces<true, true>(law, dt, pair, geometry, memory);
        if (limits.touching == 0) {
            return; // what its springs hold as it opens is negligible
        }
        const double shear = law.shear_ratio * geometry.normal_stiffness, arms = shear * pair.radius_1 * pair.radius_2;
        taken.slip += taken_beyond(memory.shear_force, limits.slip, shear);
        taken.rolling += taken_beyond(memory.bending, limits.bending, law.rolling_stiffness * arms) +
                         taken_beyond(memory.twisting, limits.twisting, law.twisting_stiffness * arms);
        taken.damping -= dt * opening *
                         contact::viscous_force(law, pair.radius_1, pair.radius_2, geometry.normal_stiffness, opening);
    }

    /// What springs of shear lose as the contact area changes under them: slip at its edge [Mindlin and Deresiewicz
    /// 1953] [J]. Parting grains let go of a share of the force with the stiffness, grains that approach keep it on
    /// stiffer springs.
    [[nodiscard]] double taken_by_new_area(
        const contact::GrainPair<double>& pair, const contact::ContactGeometry<double>& geometry, double opening,
        const contact::ContactMemory<double>& memory
    ) const {
        const double overlap = geometry.overlap, before = overlap + dt * opening;
        if (!contact::spring_of(law.spring).stiffens || !(overlap > 0) || !(before > 0)) {
            return 0;
        }
        const double stiffness_before = geometry.normal_stiffness * contact::stiffness_growth(law, before, overlap);
        const double shear = law.shear_ratio * stiffness_before, arms = shear * pair.radius_1 * pair.radius_2;
        const double held = held_in(dot(memory.shear_force, memory.shear_force), shear) +
                            held_in(dot(memory.bending, memory.bending), law.rolling_stiffness * arms) +
                            held_in(dot(memory.twisting, memory.twisting), law.twisting_stiffness * arms);
        return held * (1 - contact::stiffness_growth(law, std::min(before, overlap), std::max(before, overlap)));
    }
};

/// Power of local damping on one component of a grain's motion, whose velocity half-way through the step the damping
/// itself has a part in: less where the force drives, more where it brakes [W]. @param velocity after the step
double damping_power(double force, double velocity, double mobility, double dt, double damping) {
    const double half_gain = 0.5 * dt * mobility * force;
    const double driven = force * (velocity - (1 - damping) * half_gain);
    if (driven > 0) {
        return damping * driven;
    }
    const double braked = force * (velocity - (1 + damping) * half_gain);
    return braked < 0 ? -damping * braked : 0;
}

double damping_power(const Vec3& force, const Vec3& velocity, double mobility, double dt, double damping) {
    double power = 0;
    for (int a = 0; a < 3; ++a) {
        power += damping_power(force[a], velocity[a], mobility, dt, damping);
    }
    return power;
}

double measure_damping(const World& world, double dt, double damping) {
    const grains::Grains& grains = world.grains;
    return parallel_sum(grains.size(), grains_a_block, 0.0, [&](std::size_t begin, std::size_t end) {
        double power = 0;
        for (std::size_t g = begin; g < end; ++g) {
            if (grains.motion[g] == grains::Motion::Held) {
                continue;
            }
            const Vec3 fluctuation = grains.velocity[g] - world.cell.velocity_gradient * grains.position[g];
            power += damping_power(grains.force[g], fluctuation, 1 / grains.mass[g], dt, damping) +
                     damping_power(grains.torque[g], grains.spin[g], 1 / grains.inertia[g], dt, damping);
        }
        return power;
    });
}

/// Done on a cell that deforms from `before` to `after` under the mean stress of both, compression positive [J].
double work_between(const Mat3& before, const Mat3& after, const Mat3& stress) {
    const Mat3 middle = 0.5 * (before + after), strain_increment = (after - before) * inverse(middle);
    double work = 0;
    for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) {
            work -= stress(a, b) * strain_increment(a, b);
        }
    }
    return determinant(middle) * work;
}

} // namespace

double spring_energy(const World& world) {
    const grains::Grains& grains = world.grains;
    const contact::Contacts& contacts = world.contacts;
    const grains::Material& material = world.material;
    const contact::Spring& spring = contact::spring_of(material);
    const double shear_ratio = spring.shear_ratio(material);
    return contact::sum_touching(contacts, grains.size(), 0.0, [&](double& sum, std::size_t c) {
        const double r1 = grains.radius[contacts.first[c]], r2 = grains.radius[contacts.second[c]];
        const double overlap = contacts.overlap[c];
        const double shear = shear_ratio * spring.tangent(material, r1, r2, overlap);
        const double bending = material.rolling_stiffness * shear * r1 * r2;
        const double twisting = material.twisting_stiffness * shear * r1 * r2;
        const bool pushes = contact::normal_force(grains, contacts, material, c) != 0; // or its bond pulls
        sum += (pushes ? spring.energy(material, r1, r2, overlap) : 0) +
               held_in(norm2(contacts.shear_force[c]), shear) + held_in(norm2(contacts.bending[c]), bending);
        if (contacts.twisting.size() > 0) {
            sum += held_in(norm2(contacts.twisting[c]), twisting);
        }
    });
}

Dissipation measure_dissipation(const World& world, double dt, double damping) {
    const NextStep next(world, dt);
    Dissipation rate =
        contact::sum_touching(world.contacts, world.grains.size(), Dissipation{}, [&](Dissipation& sum, std::size_t c) {
            next.take_from(c, sum);
        });
    rate.slip /= dt; // J of one step until here
    rate.rolling /= dt;
    rate.damping /= dt;
    rate.damping += measure_damping(world, dt, damping);
    return rate;
}

EnergyBalance begin_balance(const World& world, const BalanceState& seen) {
    EnergyBalance balance;
    balance.springs_before = spring_energy(world);
    balance.motion_before = seen.equilibrium.kinetic_energy;
    balance.h = world.cell.h;
    balance.stress = seen.stress;
    balance.time = world.clock.time;
    return balance;
}

void follow(EnergyBalance& balance, const World& world, const BalanceState& seen, double dt, double damping) {
    const Dissipation rate = measure_dissipation(world, dt, damping);
    const double half_time = 0.5 * (world.clock.time - balance.time);
    EnergyParts& parts = balance.parts;
    parts.work += work_between(balance.h, world.cell.h, 0.5 * (balance.stress + seen.stress));
    parts.slip += half_time * (balance.rate.slip + rate.slip);
    parts.rolling += half_time * (balance.rate.rolling + rate.rolling);
    parts.damping += half_time * (balance.rate.damping + rate.damping);
    parts.springs = spring_energy(world) - balance.springs_before;
    parts.motion = seen.equilibrium.kinetic_energy - balance.motion_before;
    balance.rate = rate;
    balance.h = world.cell.h;
    balance.stress = seen.stress;
    balance.time = world.clock.time;
}

} // namespace suffuse::dem
