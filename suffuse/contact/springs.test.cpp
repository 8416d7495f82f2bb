// What every law of the table keeps to, unasked: a new one is in these tests as soon as it is in the list.

#include "suffuse/contact/springs.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/random.hpp"
#include "suffuse/contact/one_contact.hpp"

#include <gtest/gtest.h>

#include "tests/support/laws.hpp"
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace suffuse::contact {
namespace {

struct Radii {
    double r1, r2;
};

constexpr std::array pairs{Radii{1e-4, 1e-4}, Radii{1e-4, 1.5e-4}, Radii{3e-3, 2e-4}};
constexpr std::array depths{1e-6, 1e-4, 0.02}; // overlaps over the smaller radius

class NormalSpring : public testing::TestWithParam<grains::Material> {
protected:
    grains::Material material = GetParam();
    const Spring& spring = spring_of(material);

    /// Calls `check` with the radii and overlap of pairs of all kinds.
    template <class Check>
    void for_each_pair(const Check& check) const {
        for (const auto& [r1, r2] : pairs) {
            for (const double depth : depths) {
                SCOPED_TRACE(testing::Message() << "radii " << r1 << " and " << r2 << ", depth " << depth);
                check(r1, r2, depth * std::min(r1, r2));
            }
        }
    }
};

INSTANTIATE_TEST_SUITE_P(EveryLaw, NormalSpring, testing::ValuesIn(test::every_law()), test::law_test_name);

TEST_P(NormalSpring, PushesTheMoreTheDeeper) {
    for_each_pair([&](double r1, double r2, double overlap) {
        EXPECT_EQ(spring.force(material, r1, r2, 0), 0);
        EXPECT_EQ(spring.energy(material, r1, r2, 0), 0);
        EXPECT_GT(spring.force(material, r1, r2, overlap), 0);
        EXPECT_GT(spring.force(material, r1, r2, 1.01 * overlap), spring.force(material, r1, r2, overlap));
    });
}

TEST_P(NormalSpring, HasTheTangentThatItsForceHasAndTheForceThatItsEnergyHas) {
    for_each_pair([&](double r1, double r2, double overlap) {
        const double h = 1e-4 * overlap; // central differences: second order, 1e-8
        const auto slope = [&](Spring::OfPair of) {
            return (of(material, r1, r2, overlap + h) - of(material, r1, r2, overlap - h)) / (2 * h);
        };
        EXPECT_NEAR(slope(spring.force) / spring.tangent(material, r1, r2, overlap), 1, 1e-7);
        EXPECT_NEAR(slope(spring.energy) / spring.force(material, r1, r2, overlap), 1, 1e-7);
    });
}

TEST_P(NormalSpring, IsThePowerOfTheOverlapThatItNames) {
    const double n = spring.exponent(material);
    EXPECT_EQ(spring.stiffens, n > 1);
    EXPECT_GE(n, 1); // softer as it is pressed, nothing that looks ahead would hold
    for_each_pair([&](double r1, double r2, double overlap) {
        const double force = spring.force(material, r1, r2, overlap);
        EXPECT_NEAR(spring.force(material, r1, r2, 2 * overlap) / force, std::pow(2, n), 1e-12);
        EXPECT_NEAR(spring.tangent(material, r1, r2, overlap) * overlap / force, n, 1e-12);
    });
}

TEST_P(NormalSpring, IsTheSameWhicheverGrainComesFirstAndInAnyUnitOfLength) {
    for_each_pair([&](double r1, double r2, double overlap) {
        const double force = spring.force(material, r1, r2, overlap);
        EXPECT_NEAR(spring.force(material, r2, r1, overlap) / force, 1, 1e-14);
        EXPECT_NEAR(spring.force(material, 2 * r1, 2 * r2, 2 * overlap) / (4 * force), 1, 1e-13); // as stress x r^2
    });
}

TEST_P(NormalSpring, HasTheOverlapThatBalancesAForceOrStopsAGrain) {
    for_each_pair([&](double r, double, double overlap) {
        const double stress = spring.force(material, r, r, overlap) / (r * r);
        EXPECT_NEAR(spring.overlap_under(material, stress) * r / overlap, 1, 1e-12);
        const double speed2 = 2 * spring.energy(material, r, r, overlap) / (material.density * sphere_volume(r));
        EXPECT_NEAR(spring.overlap_of_impact(material, speed2) * r / overlap, 1, 1e-12);
    });
}

TEST_P(NormalSpring, NeverPushesBeyondItsLargestStress) {
    const double most = spring.most_stress(material);
    for (const auto& [r1, r2] : pairs) {
        for (const double share : {0.01, 0.5, 1.0}) { // up to where the centers coincide
            const double larger = std::max(r1, r2);
            EXPECT_LE(spring.force(material, r1, r2, share * (r1 + r2)), most * larger * larger * (1 + 1e-12)) << share;
        }
    }
}

TEST_P(NormalSpring, InTheHotLoopIsForceOverOverlapAndGrowsWithItsTangent) {
    const LawConstants law = resolve_law(material);
    const LawConstantsOf<float> narrow = law.as<float>();
    for_each_pair([&](double r1, double r2, double overlap) {
        const double expected = spring.force(material, r1, r2, overlap) / overlap, per_reach = 1 / (r1 + r2);
        visit_spring(law.spring, [&](auto lanes) {
            EXPECT_NEAR(lanes.secant(law.spring_constants, r1, r2, per_reach, overlap) / expected, 1, 1e-14);
            const float single = lanes.secant(
                narrow.spring_constants, static_cast<float>(r1), static_cast<float>(r2), static_cast<float>(per_reach),
                static_cast<float>(overlap)
            );
            EXPECT_NEAR(static_cast<double>(single) / expected, 1, 1e-5);
            const double deeper = 1.7 * overlap;
            EXPECT_NEAR(
                lanes.growth(law.spring_constants, deeper, overlap),
                spring.tangent(material, r1, r2, deeper) / spring.tangent(material, r1, r2, overlap), 1e-13
            );
            if (spring.stiffens) {
                EXPECT_EQ(lanes.secant(law.spring_constants, r1, r2, per_reach, -overlap), 0);
            }
        });
    });
}

TEST_P(NormalSpring, LinearizedIsAsStiffAtThatOverlap) {
    const double r = 1e-4, depth = 1e-3;
    const grains::Material linear = linearized(material, depth);
    EXPECT_EQ(linear.law, grains::ContactLaw::LinearRolling);
    const double tangent = spring.tangent(material, r, r, depth * r), shear = spring.shear_ratio(material);
    EXPECT_NEAR(linear.modulus * r / tangent, 1, 1e-12); // kn = E r of equal grains
    EXPECT_NEAR(linear.shear_ratio, shear, 1e-15);
    EXPECT_GT(shear, 0);
}

TEST_P(NormalSpring, IsLessStiffOverPressureTheHigherItIs) {
    const double level = spring.stiffness_to_pressure(material, 1e5);
    EXPECT_GT(level, 1);
    EXPECT_NEAR(
        spring.stiffness_to_pressure(material, 2e5) / level, std::pow(2, -1 / spring.exponent(material)), 1e-12
    );
}

TEST_P(NormalSpring, RefusesToAdhereUnlessItMay) {
    material.adhesion_normal = 1e5;
    if (spring.may_adhere) {
        EXPECT_EQ(resolve_law(material).adhesion_normal, 1e5);
    } else {
        EXPECT_THROW(resolve_law(material), CaseError);
    }
}

TEST(Springs, HaveNamesAndKeysOfTheirOwnAndAreFoundByThem) {
    std::set<std::string_view> members, names;
    grains::Material material;
    grains::list_members(material, [&](const grains::Member& member, const auto&) { members.insert(member.name); });
    for (const Spring& spring : springs) {
        EXPECT_TRUE(names.insert(spring.words.name).second) << spring.words.name;
        EXPECT_EQ(&spring_of(spring.law), &spring);
        EXPECT_TRUE(members.contains(spring.words.shear_key)) << spring.words.name;
        EXPECT_TRUE(has_own(spring, spring.words.shear_key));
        for (const std::string_view key : spring.words.more_keys) {
            EXPECT_TRUE(members.contains(key)) << key;
            EXPECT_TRUE(has_own(spring, key));
        }
    }
}

/// A contact along x whose second grain can be moved.
struct Bench {
    static constexpr double r1 = 1e-4, r2 = 1.5e-4, overlap = 1e-8, dt = 1e-9;
    LawConstants law;
    double gap = -overlap, slid = 0;
    ContactMemory<double> memory{};

    explicit Bench(grains::Material material) {
        material.rolling_stiffness = 0;
        material.friction = 1.5; // barely slips
        law = resolve_law(material);
        move(-overlap, 0);
    }

    /// One step to another gap and slip [m]. @return force on the second grain
    Triple<double> move(double new_gap, double new_slid) {
        const double reach = r1 + r2, factor = reach / (reach + new_gap); // of the law, on the velocity
        const GrainPair<double> pair{
            {reach + new_gap, 0, 0}, {(new_gap - gap) / dt, (new_slid - slid) / (factor * dt), 0}, {}, {}, r1, r2};
        gap = new_gap, slid = new_slid;
        return act_between<false, false>(law, dt, pair, memory).force;
    }
};

struct Work {
    double sum = 0, size = 0; ///< done on the contact, and of its steps' magnitudes [J]
};

/// Straight from corner to corner of (gap, slip), so many rounds.
Work go_round(Bench& bench, const std::vector<std::pair<double, double>>& corners, int rounds) {
    constexpr int steps = 300;
    Work work;
    Triple<double> before = bench.move(bench.gap, bench.slid);
    for (int k = 0; k < rounds * static_cast<int>(corners.size()); ++k) {
        const auto [gap, slid] = corners[static_cast<std::size_t>(k) % corners.size()];
        const double gap_from = bench.gap, slid_from = bench.slid;
        for (int q = 1; q <= steps; ++q) {
            const double share = static_cast<double>(q) / steps, gap_before = bench.gap, slid_before = bench.slid;
            const Triple<double> now =
                bench.move(gap_from + share * (gap - gap_from), slid_from + share * (slid - slid_from));
            const double done = -0.5 * (now.x + before.x) * (bench.gap - gap_before) -
                                0.5 * (now.y + before.y) * (bench.slid - slid_before);
            work.sum += done, work.size += std::abs(done);
            before = now;
        }
    }
    return work;
}

TEST_P(NormalSpring, GivesBackAllThatPressingItTook) {
    Bench bench(material);
    bench.move(-3 * Bench::overlap, 0);
    const Work work = go_round(bench, {{0, 0}, {-3 * Bench::overlap, 0}}, 3); // the same gaps on both ways
    EXPECT_NEAR(work.sum, 0, 1e-9 * work.size); // rounding of overlaps, a 10,000th of the radius
}

// Without what parting takes, a spring that is stretched while soft and let back while stiff gives more than it took.
TEST_P(NormalSpring, GivesNoEnergyOnAnyClosedPathOfOverlapAndSlip) {
    RandomStream random(3, "paths");
    for (int path = 0; path < 200; ++path) {
        Bench bench(material);
        std::vector<std::pair<double, double>> corners;
        corners.reserve(5);
        for (int k = 0; k < 4; ++k) {
            corners.emplace_back(-random.uniform(0.1, 2) * Bench::overlap, random.uniform(-1, 1) * 1e-9);
        }
        corners.emplace_back(-Bench::overlap, 0);
        const Work work = go_round(bench, corners, 3);
        EXPECT_GT(work.sum, -1e-3 * work.size) << path; // first order in the step
    }
}

TEST_P(NormalSpring, PushesTheSecondGrainAsTheFirstIsPushedWhenTheySwap) {
    const LawConstants law = resolve_law(material);
    const GrainPair<double> pair{{2.4e-4, 0.5e-4, 0}, {0.1, -0.2, 0.3}, {20, 0, 10}, {0, 30, -10}, 1e-4, 1.5e-4};
    const GrainPair<double> swapped{-1.0 * pair.branch, -1.0 * pair.velocity, pair.spin_2,
                                    pair.spin_1,        pair.radius_2,        pair.radius_1};
    ContactMemory<double> memory{}, other{};
    const ContactOutcome<double> a = act_between<false, true>(law, 1e-8, pair, memory);
    const ContactOutcome<double> b = act_between<false, true>(law, 1e-8, swapped, other);
    ASSERT_GT(a.overlap, 0);
    const Triple<double> sum = a.force + b.force;
    EXPECT_LE(std::sqrt(dot(sum, sum)), 1e-12 * std::sqrt(dot(a.force, a.force)));
    const Triple<double> turn = a.torque_1 - b.torque_2;
    EXPECT_LE(std::sqrt(dot(turn, turn)), 1e-12 * std::sqrt(dot(a.torque_1, a.torque_1)));
}

} // namespace
} // namespace suffuse::contact
