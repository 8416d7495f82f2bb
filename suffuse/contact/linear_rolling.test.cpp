// What every contact law owes: the conformance suite, run on the law of the paper by itself.

#include "suffuse/base/random.hpp"
#include "suffuse/base/vec3.hpp"
#include "suffuse/contact/one_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace suffuse::contact {
namespace {

using Force = Triple<double>;

constexpr double dt = 1e-8; // [s]
constexpr int samples = 500;

Vec3 vec(const Force& a) {
    return {a.x, a.y, a.z};
}

Force triple(const Vec3& a) {
    return {a.x, a.y, a.z};
}

double length(const Force& a) {
    return norm(vec(a));
}

Vec3 random_vector(RandomStream& random, double size) {
    return size * Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

Vec3 random_direction(RandomStream& random) {
    const Vec3 v{random.normal(), random.normal(), random.normal()};
    return v / norm(v);
}

struct State {
    GrainPair<double> pair;
    ContactMemory<double> memory;
};

/// A contact in the midst of its life: overlap, motion and memory at random, the last normal a little off.
State random_contact(RandomStream& random, double overlap_ratio) {
    State s{};
    s.pair.radius_1 = random.uniform(0.5e-4, 2e-4);
    s.pair.radius_2 = random.uniform(0.5e-4, 2e-4);
    const Vec3 n = random_direction(random);
    const double overlap = overlap_ratio * std::min(s.pair.radius_1, s.pair.radius_2);
    s.pair.branch = triple((s.pair.radius_1 + s.pair.radius_2 - overlap) * n);
    s.pair.velocity = triple(random_vector(random, 0.1));
    s.pair.spin_1 = triple(random_vector(random, 500));
    s.pair.spin_2 = triple(random_vector(random, 500));
    const Vec3 old = n + random_vector(random, 1e-5);
    s.memory.normal = triple(old / norm(old));
    s.memory.shear_force = triple(random_vector(random, 2e-3));
    s.memory.bending = triple(random_vector(random, 5e-8));
    s.memory.twisting = triple(random_vector(random, 5e-8));
    s.memory.bonded = 1;
    return s;
}

LawConstants full_law() {
    grains::Material material;
    material.twisting_stiffness = 3;
    material.twisting_friction = 0.1;
    material.adhesion_normal = 2e5;
    material.adhesion_shear = 3e5;
    return resolve_law(material);
}

LawConstants plain_law() {
    return resolve_law({});
}

/// A proper rotation, from a random quaternion.
Mat3 random_rotation(RandomStream& random) {
    std::array<double, 4> q{random.normal(), random.normal(), random.normal(), random.normal()};
    const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    const double w = q[0] / size, x = q[1] / size, y = q[2] / size, z = q[3] / size;
    return {
        {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
          {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
          {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}}};
}

template <bool Adhesive, bool Twisting>
ContactOutcome<double> act(const LawConstants& law, const GrainPair<double>& pair, ContactMemory<double>& memory) {
    return act_between<Adhesive, Twisting>(law, dt, pair, memory);
}

void expect_near(const Force& a, const Vec3& b, double tolerance, const char* what) {
    EXPECT_LE(norm(vec(a) - b), tolerance) << what;
}

TEST(LinearRolling, WithoutOverlapThereIsNoForceAndNoMemory) {
    RandomStream random(1, "gap");
    for (int k = 0; k < samples; ++k) {
        State s = random_contact(random, random.uniform(-0.1, -1e-12));
        s.memory = {}; // did not touch
        const auto out = act<true, true>(full_law(), s.pair, s.memory);
        EXPECT_EQ(length(out.force) + length(out.torque_1) + length(out.torque_2) + out.overlap, 0);
        EXPECT_EQ(
            length(s.memory.shear_force) + length(s.memory.bending) + length(s.memory.twisting) +
                length(s.memory.normal) + s.memory.bonded,
            0
        );
    }
}

TEST(LinearRolling, MemoryIsZeroAfterSeparation) {
    RandomStream random(2, "separation");
    for (int k = 0; k < samples; ++k) {
        State s = random_contact(random, random.uniform(-0.1, -1e-12)); // touched one step ago, with force and moments
        s.memory.bonded = 0;
        const auto out = act<true, true>(full_law(), s.pair, s.memory);
        EXPECT_EQ(length(out.force) + length(out.torque_1) + length(out.torque_2), 0);
        EXPECT_EQ(
            length(s.memory.shear_force) + length(s.memory.bending) + length(s.memory.twisting) +
                length(s.memory.normal),
            0
        );
    }
}

TEST(LinearRolling, MemoryTurnsWithTheContactAndKeepsItsLengthWhereGrainsSpinFast) {
    grains::Material material;
    material.friction = radians(89);
    material.rolling_friction = material.twisting_friction = -1;
    material.twisting_stiffness = 3;
    const LawConstants law = resolve_law(material);
    for (const double angle : {1e-4, 1e-2, 0.3}) { // about the normal, in a step
        State s{};
        s.pair = {{2e-4 - 1e-6, 0, 0}, {}, {angle / dt, 0, 0}, {angle / dt, 0, 0}, 1e-4, 1e-4};
        s.memory = {{0, 2e-3, 0}, {0, 0, 5e-8}, {}, {1, 0, 0}, 1};
        act<true, true>(law, s.pair, s.memory);
        const double longer = std::pow(angle, 4) / 8 + 1e-14; // to first order it would be angle2/2
        EXPECT_NEAR(length(s.memory.shear_force) / 2e-3, 1, longer);
        EXPECT_NEAR(length(s.memory.bending) / 5e-8, 1, longer);
        EXPECT_NEAR(
            std::atan2(s.memory.shear_force.z, s.memory.shear_force.y), angle, 0.2 * std::pow(angle, 3) + 1e-14
        );
    }
}

TEST(LinearRolling, SwappingTheGrainsReversesTheForce) {
    RandomStream random(3, "swap");
    for (int k = 0; k < samples; ++k) {
        State s = random_contact(random, random.uniform(-1e-4, 1e-3));
        State t;
        const auto minus = [](const Force& a) { return Force{-a.x, -a.y, -a.z}; };
        t.pair = {minus(s.pair.branch), minus(s.pair.velocity), s.pair.spin_2,
                  s.pair.spin_1,        s.pair.radius_2,        s.pair.radius_1};
        t.memory = {
            minus(s.memory.shear_force), minus(s.memory.bending), minus(s.memory.twisting), minus(s.memory.normal), 1};
        const auto there = act<true, true>(full_law(), s.pair, s.memory);
        const auto back = act<true, true>(full_law(), t.pair, t.memory);
        // Rounding: radii enter in another order.
        const double force = 1e-14 * (length(there.force) + 1e-3), torque = force * 2e-4;
        expect_near(back.force, -vec(there.force), force, "force");
        expect_near(back.torque_1, vec(there.torque_2), torque, "torque");
        expect_near(back.torque_2, vec(there.torque_1), torque, "torque");
        expect_near(t.memory.shear_force, -vec(s.memory.shear_force), force, "memory");
        EXPECT_EQ(t.memory.bonded, s.memory.bonded);
    }
}

TEST(LinearRolling, RotatingTheFrameRotatesForceTorqueAndMemory) {
    RandomStream random(4, "rotation");
    for (int k = 0; k < samples; ++k) {
        State s = random_contact(random, random.uniform(1e-6, 1e-3));
        const Mat3 q = random_rotation(random);
        const auto turned_by_q = [&](const Force& a) { return triple(q * vec(a)); };
        State t;
        t.pair = {
            turned_by_q(s.pair.branch),
            turned_by_q(s.pair.velocity),
            turned_by_q(s.pair.spin_1),
            turned_by_q(s.pair.spin_2),
            s.pair.radius_1,
            s.pair.radius_2};
        t.memory = {
            turned_by_q(s.memory.shear_force), turned_by_q(s.memory.bending), turned_by_q(s.memory.twisting),
            turned_by_q(s.memory.normal), 1};
        const auto plain = act<true, true>(full_law(), s.pair, s.memory);
        const auto rotated = act<true, true>(full_law(), t.pair, t.memory);
        // The overlap is a difference of lengths: rounding of the branch over the overlap, here 1e-16/1e-6.
        const double force = 1e-9 * length(plain.force), torque = force * 2e-4;
        expect_near(rotated.force, q * vec(plain.force), force, "force");
        expect_near(rotated.torque_1, q * vec(plain.torque_1), torque, "torque");
        expect_near(rotated.torque_2, q * vec(plain.torque_2), torque, "torque");
        expect_near(t.memory.bending, q * vec(s.memory.bending), torque, "bending");
    }
}

TEST(LinearRolling, FrictionStaysInTheConeAndMomentsBelowTheirLimits) {
    RandomStream random(5, "cone");
    const LawConstants law = resolve_law([] {
        grains::Material material;
        material.twisting_stiffness = 3;
        material.twisting_friction = 0.1;
        return material;
    }());
    int slides = 0, sticks = 0;
    for (int k = 0; k < samples; ++k) {
        State s = random_contact(random, random.uniform(1e-6, 1e-3));
        const auto out = act<false, true>(law, s.pair, s.memory);
        const double r1 = s.pair.radius_1, r2 = s.pair.radius_2;
        const double normal = law.spring_constants[0] * r1 * r2 / (r1 + r2) * out.overlap,
                     arm = std::min(r1, r2) * normal;
        const double limit = law.tan_friction * normal, shear = length(s.memory.shear_force);
        EXPECT_LE(shear, limit * (1 + 1e-14)); // one rounding of a scale and of a length
        EXPECT_LE(length(s.memory.bending), law.rolling_limit * arm * (1 + 1e-14));
        EXPECT_LE(length(s.memory.twisting), law.twisting_limit * arm * (1 + 1e-14));
        (shear > limit * (1 - 1e-12) ? slides : sticks) += 1;
    }
    EXPECT_GT(slides, samples / 10); // both branches were visited
    EXPECT_GT(sticks, samples / 10);
}

TEST(LinearRolling, MomentsOfTheSmallestGrainsAreCutAtTheirLimitToo) {
    // Of grains of a micrometer under a hundred pascals they are 1e-17 N m, in weak contacts far less.
    const Force force{2e-12, 0, 0}, moment{0, 2e-21, 0};
    const Scales<double> scales = find_scales({1e-12, 1e-12, 1e-21, 0, 1}, force, moment);
    EXPECT_NEAR(scales.shear_force, 0.5, 1e-12);
    EXPECT_NEAR(scales.bending, 0.5, 1e-12);
}

TEST(LinearRolling, ShearStrengthOfABondIsAdhesionPlusFrictionAndItBreaksThere) {
    const LawConstants law = full_law();
    State s{};
    s.pair.radius_1 = s.pair.radius_2 = 1e-4;
    s.pair.branch = {2e-4 - 1e-8, 0, 0};
    s.memory.normal = {1, 0, 0};
    s.memory.bonded = 1;
    const double normal = law.spring_constants[0] * 1e-4 / 2 * 1e-8;
    const double strength = law.adhesion_shear * 1e-8 + normal * law.tan_friction;
    for (const double share : {0.999, 1.001}) {
        ContactMemory<double> memory = s.memory;
        memory.shear_force = {0, share * strength, 0};
        const auto out = act<true, false>(law, s.pair, memory);
        EXPECT_EQ(memory.bonded, share < 1 ? 1 : 0);
        EXPECT_NEAR(
            length(memory.shear_force), share < 1 ? share * strength : normal * law.tan_friction, 1e-9 * strength
        );
        EXPECT_NEAR(out.force.x, normal, 1e-9 * normal); // compression outlives the bond
    }
}

TEST(LinearRolling, NormalForceIsTheDerivativeOfItsEnergy) {
    const LawConstants law = plain_law();
    const double r1 = 0.7e-4, r2 = 1.9e-4, kn = 2 * 356e6 * r1 * r2 / (r1 + r2);
    const auto force_at = [&](double overlap) {
        GrainPair<double> pair{{r1 + r2 - overlap, 0, 0}, {}, {}, {}, r1, r2};
        ContactMemory<double> memory{};
        return act<false, false>(law, pair, memory).force.x;
    };
    for (const double overlap : {1e-8, 1e-7, 1e-6}) {
        const double step = 0.01 * overlap;
        const auto energy = [&](double u) { return 0.5 * kn * u * u; };
        const double slope = (energy(overlap + step) - energy(overlap - step)) / (2 * step); // exact for a parabola
        EXPECT_NEAR(force_at(overlap) / slope, 1, 1e-7); // rounding of the branch over the smallest overlap
        EXPECT_GT(force_at(overlap), 0);                 // pushes the second grain away
    }
}

TEST(LinearRolling, TorquesAndForceConserveAngularMomentum) {
    RandomStream random(6, "angular momentum");
    for (int k = 0; k < samples; ++k) {
        State s = random_contact(random, random.uniform(1e-6, 1e-3));
        const auto out = act<true, true>(full_law(), s.pair, s.memory);
        // About the first center: the force acts on the second grain at the end of the branch.
        const Vec3 total = vec(out.torque_1) + vec(out.torque_2) + cross(vec(s.pair.branch), vec(out.force));
        EXPECT_LE(norm(total), 1e-13 * length(out.force) * length(s.pair.branch));
    }
}

TEST(LinearRolling, RigidRotationOfALoadedPairCreatesNoNewForce) {
    for (const Vec3& axis : {Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0.6, 0, 0.8}}) {
        State s{};
        s.pair.radius_1 = 1e-4, s.pair.radius_2 = 0.7e-4;
        s.pair.branch = {1.7e-4 - 1e-8, 0, 0};
        const Vec3 rate = 1e3 * axis;
        s.pair.spin_1 = s.pair.spin_2 = triple(rate);
        s.pair.velocity = triple(cross(rate, vec(s.pair.branch)));
        s.memory.normal = {1, 0, 0}; // the contact was there, without shear
        act<false, true>(full_law(), s.pair, s.memory);
        // Slip of one step would be dt x rate x size = 1.7e-9 m if the motion were not recognized as rigid: 1e-5 N.
        EXPECT_LE(length(s.memory.shear_force), 1e-19);
        EXPECT_LE(length(s.memory.bending) + length(s.memory.twisting), 1e-24);
    }
}

/// Memory of a loaded pair after `share` of a full turn about `axis`, at `steps` steps a turn. It starts with the
/// normal along x and force and moment along y. @param turning of the law
ContactMemory<double> turned_pair(double turning, const Vec3& axis, int steps, double share) {
    grains::Material material;
    material.friction = 1.5; // no slip
    material.rolling_friction = -1;
    LawConstants law = resolve_law(material);
    law.turning = turning;
    const double angle = 2 * pi / steps;
    State s{};
    s.pair.radius_1 = s.pair.radius_2 = 1e-4;
    s.memory.normal = {1, 0, 0};
    s.memory.shear_force = {0, 1e-4, 0};
    s.memory.bending = {0, 1e-8, 0};
    const Vec3 rate = angle / dt * axis;
    s.pair.spin_1 = s.pair.spin_2 = triple(rate);
    for (int k = 1; k <= share * steps; ++k) {
        const double turn = angle * k;
        const Vec3 n = axis.z != 0 ? Vec3{std::cos(turn), std::sin(turn), 0} : Vec3{1, 0, 0};
        s.pair.branch = triple((2e-4 - 1e-7) * n);
        s.pair.velocity = triple(cross(rate, vec(s.pair.branch)));
        act<false, false>(law, s.pair, s.memory);
    }
    return s.memory;
}

TEST(LinearRolling, ForceAndMomentTurnWithThePair) {
    // A quarter of a turn with the normal (about z) takes y to -x, one about the normal (x) takes y to z.
    const double late = 0.5 * pi * std::pow(2 * pi / 4000, 2) / 12; // angles add up to their third order
    for (const auto& [axis, end] :
         {std::pair{Vec3{0, 0, 1}, Vec3{-1, 0, 0}}, std::pair{Vec3{1, 0, 0}, Vec3{0, 0, 1}}}) {
        const ContactMemory<double> memory = turned_pair(LawConstants{}.turning, axis, 4000, 0.25);
        expect_near(memory.shear_force, 1e-4 * end, 4 * late * 1e-4, "shear force");
        expect_near(memory.bending, 1e-8 * end, 4 * late * 1e-8, "bending moment");
        const double longer = 1000 * std::pow(2 * pi / 4000, 4) / 8;
        EXPECT_NEAR(length(memory.shear_force) / 1e-4, 1 + longer, 0.02 * longer);
        EXPECT_NEAR(length(memory.bending) / 1e-8, 1 + longer, 0.02 * longer);
    }
}

TEST(LinearRolling, FullTurnToFirstOrderGrowsTheForceAsTheReferencesDoes) {
    // Each step of angle a lengthens a tangential force by 1 + a2/2: 2 pi2/N over a turn of N steps.
    for (const Vec3& axis : {Vec3{0, 0, 1}, Vec3{1, 0, 0}}) { // with the normal, and about it
        for (const int steps : {2000, 4000}) {
            const ContactMemory<double> memory = turned_pair(0, axis, steps, 1);
            const double expected = 2 * pi * pi / steps;
            EXPECT_NEAR((length(memory.shear_force) / 1e-4 - 1) / expected, 1, 0.02);
            EXPECT_NEAR((length(memory.bending) / 1e-8 - 1) / expected, 1, 0.02);
        }
    }
}

} // namespace
} // namespace suffuse::contact
