#include "suffuse/contact/forces.hpp"

#include "suffuse/base/parallel.hpp"
#include "suffuse/base/random.hpp"
#include "suffuse/contact/carry_over.hpp"
#include "suffuse/contact/one_contact.hpp"
#include "suffuse/contact/springs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace suffuse::contact {
namespace {

constexpr double dt = 4e-8; // [s]

struct Sample {
    grains::Grains grains;
    grains::Material material;
    Contacts contacts;
    Mat3 h = diagonal({4e-3, 5e-3, 6e-3}), image_velocity = diagonal({1e-2, -2e-2, 3e-2});
};

/// `count` pairs in every state: touching and apart, old and new, within the cell and across its faces.
Sample random_pairs(std::size_t count, bool adhesive, bool twisting, const Spring& spring = springs[0]) {
    RandomStream random(7, "pairs", count);
    const auto vector = [&](double size) {
        return size * Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    };
    Sample s;
    s.material.adhesion_normal = s.material.adhesion_shear = adhesive ? 1e5 : 0;
    s.material.twisting_stiffness = twisting ? 2 : 0;
    s.material.twisting_friction = 0.1;
    s.material.law = spring.law;
    s.material.viscous_damping = spring.stiffens ? 0.5 : 0;
    for (std::size_t c = 0; c < count; ++c) {
        const double r1 = random.uniform(0.5e-4, 2e-4), r2 = random.uniform(0.5e-4, 2e-4);
        const Vec3 v{random.normal(), random.normal(), random.normal()}, n = v / norm(v), x = vector(1e-3);
        const double overlap = random.uniform(-0.5e-7, 1e-7);
        const cell::Image image{c % 3 == 0 ? 1 : 0, c % 5 == 0 ? -1 : 0, 0};
        const auto i = add_grain(s.grains, x, r1, 2600);
        const auto j = add_grain(s.grains, x + (r1 + r2 - overlap) * n - cell::shift(s.h, image), r2, 2600);
        for (const auto g : {i, j}) {
            s.grains.velocity[g] = vector(0.1);
            s.grains.spin[g] = vector(300);
        }
        const bool old = c % 4 != 0;
        s.contacts.first.push_back(i);
        s.contacts.second.push_back(j);
        s.contacts.image.push_back(image);
        s.contacts.shear_force.push_back(old ? vector(1e-3) : Vec3{});
        s.contacts.bending.push_back(old ? vector(1e-8) : Vec3{});
        s.contacts.normal.push_back(old ? n : Vec3{});
        s.contacts.overlap.push_back(0);
        if (twisting) {
            s.contacts.twisting.push_back(old ? vector(1e-8) : Vec3{});
        }
        if (adhesive) {
            s.contacts.bonded.push_back(old && c % 7 != 0 ? 1 : 0);
        }
    }
    return s;
}

Triple<double> triple(const Vec3& a) {
    return {a.x, a.y, a.z};
}

Vec3 vec(const Triple<double>& a) {
    return {a.x, a.y, a.z};
}

GrainPair<double> pair_of(const Sample& s, std::size_t c) {
    const auto i = s.contacts.first[c], j = s.contacts.second[c];
    const auto& g = s.grains;
    Vec3 branch = g.position[j] - g.position[i], velocity = g.velocity[j] - g.velocity[i];
    if (s.contacts.image[c] != cell::Image{}) {
        branch += cell::shift(s.h, s.contacts.image[c]);
        velocity += cell::shift(s.image_velocity, s.contacts.image[c]);
    }
    return {triple(branch), triple(velocity), triple(g.spin[i]), triple(g.spin[j]), g.radius[i], g.radius[j]};
}

/// What one contact does to its two grains: `force` on the second, minus it on the first.
struct ContactForce {
    Vec3 force, torque_1, torque_2;
};

/// The law applied to one contact after the other: the slow, obvious loop.
template <bool Adhesive, bool Twisting>
std::vector<ContactForce> one_by_one(const Sample& s, Contacts& contacts) {
    const LawConstants law = resolve_law(s.material);
    std::vector<ContactForce> forces;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        ContactMemory<double> memory{
            triple(contacts.shear_force[c]), triple(contacts.bending[c]), {}, triple(contacts.normal[c]), 0};
        if constexpr (Adhesive) {
            memory.bonded = contacts.bonded[c];
        }
        if constexpr (Twisting) {
            memory.twisting = triple(contacts.twisting[c]);
        }
        const auto out = act_between<Adhesive, Twisting>(law, dt, pair_of(s, c), memory);
        contacts.shear_force.set(c, vec(memory.shear_force));
        contacts.bending.set(c, vec(memory.bending));
        contacts.normal.set(c, vec(memory.normal));
        contacts.overlap[c] = out.overlap;
        if constexpr (Adhesive) {
            contacts.bonded[c] = static_cast<std::uint8_t>(memory.bonded);
        }
        if constexpr (Twisting) {
            contacts.twisting.set(c, vec(memory.twisting));
        }
        forces.push_back({vec(out.force), vec(out.torque_1), vec(out.torque_2)});
    }
    return forces;
}

std::vector<ContactForce> one_by_one(const Sample& s, bool adhesive, bool twisting, Contacts& contacts) {
    if (adhesive) {
        return twisting ? one_by_one<true, true>(s, contacts) : one_by_one<true, false>(s, contacts);
    }
    return twisting ? one_by_one<false, true>(s, contacts) : one_by_one<false, false>(s, contacts);
}

struct Result {
    SumPlan plan;
    StepSetting setting;
    std::vector<grains::GrainSum> sums;
    Mat3 force_branch;
};

Result press(Sample& s, bool normals_only = false) {
    Result result;
    result.setting.normals_only = normals_only;
    std::vector<grains::MovingRow> rows;
    grains::to_rows(s.grains, rows);
    plan_sums(s.contacts, s.grains.size(), result.plan);
    result.sums.resize(result.plan.rows());
    set_up_step(result.plan, s.h, s.image_velocity, 2e-4, dt, result.setting);
    result.force_branch =
        compute_forces(rows, result.plan, result.setting, resolve_law(s.material), s.contacts, result.sums)
            .force_branch;
    return result;
}

class ContactLoop : public testing::TestWithParam<std::tuple<bool, bool, Spring>> {};

TEST_P(ContactLoop, GivesTheBitsOfTheLawAppliedToOneContactAfterTheOther) {
    const auto& [adheres, twisting, spring] = GetParam();
    const bool adhesive = adheres && spring.may_adhere;
    for (const std::size_t count : {1U, 7U, 63U, 64U, 65U, 1200U}) { // whole tiles, short ones, several domains
        Sample s = random_pairs(count, adhesive, twisting, spring);
        Contacts expected = s.contacts;
        const std::vector<ContactForce> slow = one_by_one(s, adhesive, twisting, expected);
        const Result fast = press(s);
        Mat3 slow_sum{};
        std::size_t touching = 0;
        for (std::size_t c = 0; c < count; ++c) {
            ASSERT_EQ(xyz(fast.sums[s.contacts.first[c]].force), -slow[c].force) << c; // each grain has one contact
            ASSERT_EQ(xyz(fast.sums[s.contacts.first[c]].torque), slow[c].torque_1) << c;
            ASSERT_EQ(xyz(fast.sums[fast.plan.second_sum[c]].force), slow[c].force) << c;
            ASSERT_EQ(xyz(fast.sums[fast.plan.second_sum[c]].torque), slow[c].torque_2) << c;
            ASSERT_EQ(s.contacts.shear_force[c], expected.shear_force[c]);
            ASSERT_EQ(s.contacts.bending[c], expected.bending[c]);
            ASSERT_EQ(s.contacts.normal[c], expected.normal[c]);
            ASSERT_EQ(s.contacts.overlap[c], expected.overlap[c]);
            touching += s.contacts.touches(c) ? 1 : 0;
            slow_sum += outer(slow[c].force, vec(pair_of(s, c).branch));
        }
        EXPECT_EQ(s.contacts.bonded, expected.bonded);
        EXPECT_EQ(s.contacts.twisting.x, expected.twisting.x);
        EXPECT_TRUE(count < 60 || (touching > count / 4 && touching < count));
        // Every term to half a quantum, which is at most 2^-61 of the modulus times the volume.
        const double rounding =
            static_cast<double>(count) * 0x1p-62 * resolve_law(s.material).most_stress * determinant(s.h);
        for (int a = 0; a < 3; ++a) {
            for (int b = 0; b < 3; ++b) {
                EXPECT_NEAR(fast.force_branch(a, b), slow_sum(a, b), rounding);
            }
        }
    }
}

std::string name_of(const testing::TestParamInfo<std::tuple<bool, bool, Spring>>& test) {
    const auto& [adhesive, twisting, spring] = test.param;
    return std::string(adhesive ? "Adhesive" : "Plain") + (twisting ? "Twisting" : "") +
           std::to_string(static_cast<int>(spring.law));
}

INSTANTIATE_TEST_SUITE_P(
    EveryLaw, ContactLoop, testing::Combine(testing::Bool(), testing::Bool(), testing::ValuesIn(springs)), name_of
);

TEST(ContactLoop, OfContactsThatOnlyPushGivesTheBitsOfTheWholeLaw) {
    Sample whole = random_pairs(1200, false, false);
    whole.material.friction = 0;
    for (std::size_t g = 0; g < whole.grains.size(); ++g) {
        whole.grains.spin[g] = {};
    }
    for (std::size_t c = 0; c < whole.contacts.size(); ++c) {
        whole.contacts.shear_force.set(c, {});
        whole.contacts.bending.set(c, {});
    }
    Sample pushing = whole;
    const Result slow = press(whole), fast = press(pushing, true);
    EXPECT_EQ(fast.force_branch, slow.force_branch);
    EXPECT_EQ(pushing.contacts.normal.x, whole.contacts.normal.x);
    EXPECT_EQ(pushing.contacts.normal.y, whole.contacts.normal.y);
    EXPECT_EQ(pushing.contacts.normal.z, whole.contacts.normal.z);
    EXPECT_EQ(pushing.contacts.overlap, whole.contacts.overlap);
    EXPECT_EQ(pushing.contacts.shear_force.x, whole.contacts.shear_force.x);
    for (std::size_t k = 0; k < fast.sums.size(); ++k) {
        ASSERT_EQ(xyz(fast.sums[k].force), xyz(slow.sums[k].force)) << k;
        ASSERT_EQ(xyz(fast.sums[k].torque), xyz(slow.sums[k].torque)) << k;
    }
}

TEST(ContactLoop, GivesTheSameBitsForAnyNumberOfThreads) {
    const Sample start = random_pairs(3000, true, true);
    std::vector<Mat3> sums;
    std::vector<std::vector<double>> shears;
    for (const int threads : {1, 2, 4}) {
        set_thread_count(threads);
        Sample s = start;
        sums.push_back(press(s).force_branch);
        shears.push_back(s.contacts.shear_force.x);
    }
    set_thread_count(1);
    EXPECT_EQ(sums[0], sums[1]);
    EXPECT_EQ(sums[0], sums[2]);
    EXPECT_EQ(shears[0], shears[1]);
    EXPECT_EQ(shears[0], shears[2]);
}

TEST_P(ContactLoop, OfEveryLawInSinglePrecisionDiffersByItsRounding) {
    const auto& [adheres, twisting, spring] = GetParam();
    Sample exact = random_pairs(500, adheres && spring.may_adhere, twisting, spring), s = exact;
    const Result wanted = press(exact);
    std::vector<grains::MovingRow> rows;
    grains::to_rows(s.grains, rows);
    SingleMemory memory;
    take_single(s.contacts, memory);
    std::vector<grains::GrainSum> sums(wanted.plan.rows());
    compute_forces(rows, wanted.plan, wanted.setting, resolve_law(s.material), s.contacts, memory, sums);
    for (std::size_t c = 0; c < s.contacts.size(); ++c) {
        const Vec3 force = xyz(sums[s.contacts.first[c]].force), right = xyz(wanted.sums[s.contacts.first[c]].force);
        ASSERT_LE(norm(force - right), 3e-6 * norm(right) + 1e-9) << c;
    }
}

TEST(ContactLoop, InSinglePrecisionDiffersByItsRounding) {
    Sample exact = random_pairs(500, true, true), s = exact;
    const Result wanted = press(exact);
    std::vector<grains::MovingRow> rows;
    grains::to_rows(s.grains, rows);
    SingleMemory memory;
    take_single(s.contacts, memory);
    EXPECT_TRUE(s.contacts.overlap.empty());
    std::vector<grains::GrainSum> sums(wanted.plan.rows());
    const Pressed pressed =
        compute_forces(rows, wanted.plan, wanted.setting, resolve_law(s.material), s.contacts, memory, sums);
    give_back_single(memory, s.contacts);
    EXPECT_TRUE(memory.overlap.empty());
    EXPECT_NEAR(trace(pressed.force_branch) / trace(wanted.force_branch), 1, 1e-6);
    for (std::size_t c = 0; c < s.contacts.size(); ++c) {
        ASSERT_EQ(s.contacts.touches(c), exact.contacts.touches(c)) << c;
        const Vec3 force = xyz(sums[s.contacts.first[c]].force), right = xyz(wanted.sums[s.contacts.first[c]].force);
        ASSERT_LE(norm(force - right), 3e-6 * norm(right) + 1e-9) << c; // the shear may cancel the normal force
        ASSERT_EQ(s.contacts.bonded[c], exact.contacts.bonded[c]) << c;
    }
}

/// Of several domains that reach each other: the grains of a pair lie anywhere in the table.
Sample scattered_pairs(std::size_t count) {
    Sample s = random_pairs(count, false, false);
    std::vector<std::uint32_t> order(s.grains.size()), new_row(order.size());
    for (std::uint32_t k = 0; k < order.size(); ++k) {
        order[k] = static_cast<std::uint32_t>(1009U * k % order.size()); // a prime that does not divide it
        new_row[order[k]] = k;
    }
    select_rows(s.grains, order);
    s.contacts = renumbered(s.contacts, new_row);
    return s;
}

TEST(DomainSequel, RunsOnceForEachDomainWhenItsSumsAreCompleteOnAnyNumberOfThreads) {
    for (const int threads : {1, 2, 4}) {
        Sample s = scattered_pairs(3000);
        SumPlan plan;
        plan_sums(s.contacts, s.grains.size(), plan);
        ASSERT_GT(plan.reach.size(), 2 * plan.domains());
        std::vector<grains::MovingRow> rows;
        grains::to_rows(s.grains, rows);
        StepSetting setting;
        set_up_step(plan, s.h, s.image_velocity, 2e-4, dt, setting);
        std::vector<grains::GrainSum> sums(plan.rows());
        std::vector<std::vector<grains::GrainSum>> seen(plan.domains());
        const auto look = [&](std::size_t d) {
            std::vector<grains::GrainSum> now;
            for (std::size_t k = d * domain_grains; k < plan.awake_end[d]; ++k) {
                now.push_back(sums[plan.roster[k]]);
            }
            now.insert(
                now.end(), sums.begin() + static_cast<std::ptrdiff_t>(plan.grains + plan.remote_start[d]),
                sums.begin() + static_cast<std::ptrdiff_t>(plan.grains + plan.remote_start[d + 1])
            );
            return now;
        };
        DomainSequel sequel;
        sequel.run = [&](std::size_t d) {
            const std::vector<grains::GrainSum> now = look(d);
            seen[d].insert(seen[d].end(), now.begin(), now.end());
        };
        set_thread_count(threads);
        compute_forces(rows, plan, setting, resolve_law(s.material), s.contacts, sums, &sequel);
        set_thread_count(1);
        for (std::size_t d = 0; d < plan.domains(); ++d) {
            const std::vector<grains::GrainSum> complete = look(d);
            ASSERT_EQ(seen[d].size(), complete.size()) << d;
            for (std::size_t k = 0; k < complete.size(); ++k) {
                ASSERT_EQ(xyz(seen[d][k].force), xyz(complete[k].force));
                ASSERT_EQ(xyz(seen[d][k].torque), xyz(complete[k].torque));
            }
        }
    }
}

} // namespace
} // namespace suffuse::contact
