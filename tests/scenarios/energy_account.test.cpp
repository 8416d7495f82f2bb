// Where the work done on a sheared packing goes: motion, springs, slip, rolling, damping. Every term is computed from
// what it means, none as a remainder.

#include "suffuse/contact/carry_over.hpp"
#include "suffuse/contact/forces.hpp"
#include "suffuse/motion/integrator.hpp"

#include <gtest/gtest.h>

#include "tests/support/energy.hpp"
#include "tests/support/worlds.hpp"
#include <cmath>
#include <string>

namespace suffuse::dem {
namespace {

struct Account {
    double work = 0, damping = 0, slip = 0, rolling = 0;
};

/// Memory of the contacts of `before`, in the rows of the contacts of `after`.
contact::Contacts aligned(const World& before, const World& after) {
    const contact::Contacts& table = after.contacts;
    std::vector<neighbors::Pair> pairs;
    for (std::size_t c = 0; c < table.size(); ++c) {
        pairs.push_back({table.first[c], table.second[c], table.image[c]});
    }
    contact::Contacts contacts = before.contacts;
    contact::carry_over(contacts, neighbors::PairList(pairs, after.grains.size()), {}, {});
    return contacts;
}

/// What slip and rolling beyond their limits dissipated in the step from `before` to `after`: the force that remains
/// times the part of the motion that the springs did not take up, which a law without limits gives.
void add_plastic_work(
    const World& before, const World& after, const Mat3& image_velocity, double dt, Account& account
) {
    contact::Contacts elastic = aligned(before, after);
    if (elastic.size() != after.contacts.size()) {
        return; // a contact left the table in this step; none does in a step that matters here
    }
    grains::Material unlimited = after.material;
    unlimited.friction = 1.57;
    unlimited.rolling_friction = -1;
    std::vector<grains::MovingRow> rows;
    grains::to_rows(before.grains, rows);
    contact::SumPlan plan;
    contact::plan_sums(elastic, before.grains.size(), plan);
    std::vector<grains::GrainSum> sums(plan.rows());
    const double largest_radius = *std::max_element(before.grains.radius.begin(), before.grains.radius.end());
    contact::StepSetting setting;
    contact::set_up_step(plan, after.cell.h, image_velocity, largest_radius, dt, setting);
    contact::compute_forces(rows, plan, setting, contact::resolve_law(unlimited), elastic, sums);
    for (std::size_t c = 0; c < elastic.size(); ++c) {
        if (!after.contacts.touches(c)) {
            continue;
        }
        const double r1 = after.grains.radius[elastic.first[c]], r2 = after.grains.radius[elastic.second[c]];
        const double ks = after.material.shear_ratio * contact::normal_stiffness(after.material, r1, r2, 0);
        const double kr = after.material.rolling_stiffness * ks * r1 * r2;
        const Vec3 force = after.contacts.shear_force[c], moment = after.contacts.bending[c];
        account.slip += dot(elastic.shear_force[c] - force, force) / ks;
        account.rolling += dot(elastic.bending[c] - moment, moment) / kr;
    }
}

/// What local damping took: its share of the power of each force component against the motion in the middle of the
/// step.
double damping_work(const World& before, const World& after, double damping, double dt) {
    double work = 0;
    const auto power = [](const Vec3& force, const Vec3& v) {
        return std::abs(force.x * v.x) + std::abs(force.y * v.y) + std::abs(force.z * v.z);
    };
    for (std::size_t g = 0; g < after.grains.size(); ++g) {
        const Vec3 mean = after.cell.velocity_gradient * before.grains.position[g];
        const Vec3 v = 0.5 * (before.grains.velocity[g] + after.grains.velocity[g]) - mean;
        const Vec3 w = 0.5 * (before.grains.spin[g] + after.grains.spin[g]);
        work += damping * dt * (power(after.grains.force[g], v) + power(after.grains.torque[g], w));
    }
    return work;
}

/// Relative gap of the account over a shearing at constant volume, in steps of `dt`.
double gap_of_account(double dt, double damping, Account& account) {
    World world = test::reference_packing("packing500");
    StepCaches caches;
    test::advance(world, caches, test::plan_of(dt, 0.2), static_cast<std::int64_t>(4e-5 / dt)); // at rest
    StepPlan plan = test::plan_of(dt, damping);
    plan.loading.velocity_gradient = diagonal({30, 30, -60});
    step(world, caches, plan); // adopts the gradient: a jolt that belongs to no account
    const double start = test::energy_of(world).total();
    const auto steps = static_cast<std::int64_t>(8e-5 / dt); // 0.5 % strain
    for (std::int64_t k = 0; k < steps; ++k) {
        const World before = world;
        const Mat3 image_velocity = world.cell.velocity_gradient * world.cell.h;
        const Mat3 stress = step(world, caches, plan).stress;
        Mat3 kinetic{}; // momentum that crosses planes with the grains does work too
        for (std::size_t g = 0; g < world.grains.size(); ++g) {
            const Vec3 v = before.grains.velocity[g] - before.cell.velocity_gradient * before.grains.position[g];
            kinetic += before.grains.mass[g] * outer(v, v);
        }
        const Mat3 pressed = cell::volume(world.cell) * stress + kinetic;
        for (int a = 0; a < 3; ++a) { // compression positive, the gradient extension positive
            account.work -= pressed(a, a) * (*plan.loading.velocity_gradient)(a, a) * dt;
        }
        account.damping += damping_work(before, world, damping, dt);
        add_plastic_work(before, world, image_velocity, dt, account);
    }
    const double stored = test::energy_of(world).total() - start;
    return (account.work - stored - account.damping - account.slip - account.rolling) / account.work;
}

TEST(EnergyAccount, OfAShearedPackingCloses) {
    for (const double damping : {0.0, 0.2}) {
        Account account, finer;
        const double gap = gap_of_account(4e-8, damping, account), half = gap_of_account(2e-8, damping, finer);
        RecordProperty(
            damping > 0 ? "damped" : "undamped", "gap " + std::to_string(gap) + ", at half the step " +
                                                     std::to_string(half) + ", slip " +
                                                     std::to_string(account.slip / account.work) + ", rolling " +
                                                     std::to_string(account.rolling / account.work) + ", damping " +
                                                     std::to_string(account.damping / account.work)
        );
        EXPECT_GT(account.slip, 0.02 * account.work); // the sample does slide and roll
        EXPECT_GT(account.rolling, 0.02 * account.work);
        // First order in the step, and contacts that open or leave the table within one: measured 2e-4 of the work.
        EXPECT_LE(std::abs(gap), 2e-3);
        EXPECT_LE(std::abs(half), 2e-3);
    }
}

} // namespace
} // namespace suffuse::dem
