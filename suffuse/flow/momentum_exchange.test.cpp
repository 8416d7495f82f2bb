#include "suffuse/flow/momentum_exchange.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"

#include <gtest/gtest.h>

#include "tests/support/packings.hpp"
#include <algorithm>
#include <random>

namespace suffuse::flow {
namespace {

using test::Packing;

struct Sample {
    Packing packing = test::random_packing(identity(), 120, 0.03, 0.15, 5);
    pores::PoreNetwork network = pores::build_network(packing.h, packing.position, packing.radius);
    ExchangeLegs leg = exchange_legs(network, packing.position, packing.radius);
    RawColumn<double> drag = RawColumn<double>(network.throats.size());

    Sample() {
        std::mt19937_64 random(1);
        std::lognormal_distribution<double> spread(-1, 2);
        std::generate(drag.begin(), drag.end(), [&] { return spread(random); });
    }

    [[nodiscard]] std::size_t throats() const { return drag.size(); }

    [[nodiscard]] std::vector<double> water() const {
        std::vector<double> volume(throats());
        for (std::size_t t = 0; t < throats(); ++t) {
            const auto& [a, b, c] = network.throats.wetted[t];
            volume[t] = std::max(0.0, network.throats.hydraulic_radius[t] * (a + b + c));
        }
        return volume;
    }
};

/// Corners of pore p, and the middles of the throats opposite to them.
struct PorePlaces {
    std::array<Vec3, 4> corner, middle;

    PorePlaces(const Packing& packing, const pores::PoreNetwork& network, std::uint32_t p) {
        const pores::Pores& pores = network.pores;
        Vec3 sum = pores.center[p];
        for (std::size_t k = 0; k < 4; ++k) {
            corner[k] = packing.position[pores.grain[p][k]] + shift(packing.h, pores.grain_image[p][k]);
            sum += corner[k];
        }
        for (std::size_t k = 0; k < 4; ++k) {
            const auto [q, image] = pores::pore_beyond(network, p, k);
            middle[k] = (sum - corner[k] + pores.center[q] + shift(packing.h, image)) / 5;
        }
    }
};

TEST(ExchangeLegs, OfACubicLatticeOfSmallSpheresHaveTheirClosedForm) {
    // Tetrahedra that cut a cube of the lattice have their centers in its middle, however they cut it. The triangle to
    // there from an edge of the cube or from a diagonal of its face has one of two areas; a diagonal of the cube goes
    // through the middle. A leg is 1.2 x 4/3 times their sum over distances,
    // in single precision.
    const double r = 0.1;
    const Packing packing = test::lattice(2, 1, r, {{0.1, 0.2, 0.3}});
    const auto network = pores::build_network(packing.h, packing.position, packing.radius);
    const ExchangeLegs leg = exchange_legs(network, packing.position, packing.radius);
    const auto area_from = [&](double length) {
        const double edge = 0.5 * (std::sqrt(0.5) - 2 * r * r * std::atan(std::sqrt(2.0)));
        const double diagonal = 0.5 * (std::sqrt(0.5) - 2 * r * r * std::atan(std::sqrt(0.5)));
        return length < 1.2 ? edge : length < 1.6 ? diagonal : 0;
    };
    constexpr std::size_t pairs[6][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2},
                                         {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}};
    for (std::uint32_t p = 0; p < network.pores.size(); ++p) {
        const PorePlaces at(packing, network, p);
        std::array<double, 4> expected{};
        for (const auto& [k, l, a, b] : pairs) {
            const double exchange = area_from(norm(at.corner[a] - at.corner[b])) / norm(at.middle[k] - at.middle[l]);
            expected[k] += 1.6 * exchange, expected[l] += 1.6 * exchange;
        }
        for (std::size_t k = 0; k < 4; ++k) {
            EXPECT_NEAR(leg[network.pores.throat[p][k]][pores::side_of(network, p, k)] / expected[k], 1, 6e-8);
        }
    }
}

TEST(MomentumExchange, WithoutLegsEachThroatIsAlone) {
    const Sample sample;
    const std::vector<double> water = sample.water();
    const MomentumExchange exchange(sample.network, sample.drag, ExchangeLegs(sample.throats(), {0, 0}));
    const std::vector<double> velocity = exchange.velocities(water);
    const auto motion = exchange.motion(water);
    for (std::size_t t = 0; t < sample.throats(); ++t) {
        EXPECT_DOUBLE_EQ(velocity[t], water[t] / sample.drag[t]);
        EXPECT_EQ(exchange.to_grains(motion, water, t), water[t] * sample.network.throats.area[t]);
    }
}

TEST(MomentumExchange, PushesThatDragAloneBalancesMoveAllWaterAlike) {
    const Sample sample;
    const MomentumExchange exchange(sample.network, sample.drag, sample.leg, {.tolerance = 1e-12});
    RawColumn<double> push = sample.drag;
    for (double& each : push) {
        each *= 0.7;
    }
    for (const double velocity : exchange.velocities(push)) {
        EXPECT_NEAR(velocity, 0.7, 1e-9);
    }
}

TEST(MomentumExchange, OfStrongLegsMovesAllWaterAlike) {
    const Sample sample;
    ExchangeLegs leg = sample.leg;
    for (auto& [here, beyond] : leg) {
        here = 1e6, beyond = 1e6;
    }
    const std::vector<double> water = sample.water();
    double all_water = 0, all_drag = 0;
    for (std::size_t t = 0; t < sample.throats(); ++t) {
        all_water += water[t], all_drag += sample.drag[t];
    }
    const MomentumExchange exchange(sample.network, sample.drag, leg, {.tolerance = 1e-12});
    for (const double velocity : exchange.velocities(water)) {
        EXPECT_NEAR(velocity / (all_water / all_drag), 1, 1e-3);
    }
}

TEST(MomentumExchange, GivesGrainsDragTimesVelocity) {
    const Sample sample;
    const MomentumExchange exchange(sample.network, sample.drag, sample.leg, {.tolerance = 1e-12});
    const std::vector<double> pressure = sample.water();
    std::vector<double> along_z;
    double largest = 0;
    for (std::size_t t = 0; t < sample.throats(); ++t) {
        along_z.push_back(pressure[t] * sample.network.throats.area[t].z);
        largest = std::max(largest, std::abs(along_z[t]));
    }
    const std::vector<double> velocity = exchange.velocities(along_z);
    const auto motion = exchange.motion(pressure);
    for (std::size_t t = 0; t < sample.throats(); ++t) {
        const Vec3 drag = exchange.to_grains(motion, pressure, t);
        EXPECT_NEAR(drag.z / largest, sample.drag[t] * velocity[t] / largest, 1e-9);
    }
}

TEST(MomentumExchange, LosesNoMomentumWhateverTheTolerance) {
    const Sample sample;
    std::mt19937_64 random(2);
    std::normal_distribution<double> normal;
    std::vector<double> pressure(sample.throats());
    Vec3 given, reached;
    for (std::size_t t = 0; t < sample.throats(); ++t) {
        pressure[t] = normal(random);
        given += pressure[t] * sample.network.throats.area[t];
    }
    const MomentumExchange exchange(sample.network, sample.drag, sample.leg, {.tolerance = 0.5});
    const auto motion = exchange.motion(pressure);
    for (std::size_t t = 0; t < sample.throats(); ++t) {
        reached += exchange.to_grains(motion, pressure, t);
    }
    EXPECT_NEAR(norm(reached - given) / norm(given), 0, 1e-12);
}

TEST(MomentumExchange, SaysThatItDidNotConverge) {
    const Sample sample;
    const MomentumExchange exchange(
        sample.network, sample.drag, sample.leg, {.tolerance = 1e-12, .iteration_limit = 2}
    );
    EXPECT_THROW((void)exchange.velocities(sample.water()), SolverError);
}

TEST(MomentumExchange, SameBitsForAnyNumberOfThreads) {
    const Packing packing = test::reference_spheres("packing2000");
    const auto network = pores::build_network(packing.h, packing.position, packing.radius);
    const std::vector<double> ones(network.throats.size(), 1);
    const auto solve = [&] {
        const ExchangeLegs leg = exchange_legs(network, packing.position, packing.radius);
        return MomentumExchange(network, RawColumn<double>(ones.size(), 1e-4), leg).motion(ones).mean;
    };
    const RawColumn<Vec3> one = solve();
    for (const int threads : {2, 4}) {
        set_thread_count(threads);
        EXPECT_EQ(solve(), one);
        set_thread_count(1);
    }
}

} // namespace
} // namespace suffuse::flow
