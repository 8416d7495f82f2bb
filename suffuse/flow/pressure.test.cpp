#include "suffuse/flow/pressure.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/flow/conductance.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/packings.hpp"
#include "tests/support/reference.hpp"
#include <algorithm>
#include <map>

namespace suffuse::flow {
namespace {

using test::Packing;

pores::PoreNetwork build(const Packing& packing) {
    return pores::build_network(packing.h, packing.position, packing.radius);
}

Packing sheared_packing() {
    return test::random_packing(from_columns({1, 0, 0}, {0.5, 1, 0.1}, {-0.2, 0.3, 0.9}), 120, 0.04, 0.1, 5);
}

/// Pores of the reference's 500 grains, matched with ours by their grains.
struct Match {
    nlohmann::json theirs;
    std::uint32_t ours;
};

std::vector<Match> match_pores(const pores::PoreNetwork& network, const nlohmann::json& reference) {
    std::map<std::array<std::uint32_t, 4>, std::uint32_t> by_grains;
    for (std::uint32_t p = 0; p < network.pores.size(); ++p) {
        auto grains = network.pores.grain[p];
        std::sort(grains.begin(), grains.end());
        by_grains[grains] = p;
    }
    std::vector<Match> matches;
    for (const nlohmann::json& pore : reference["cells"]) {
        std::array<std::uint32_t, 4> grains = pore["v"];
        std::sort(grains.begin(), grains.end());
        matches.push_back({pore, by_grains.at(grains)});
    }
    return matches;
}

TEST(Conductance, OfEveryThroatIsThatOfTheReference) {
    const Packing packing = test::reference_spheres("packing500");
    const pores::PoreNetwork network = build(packing);
    const std::vector<double> conductance = conductances(network, 1e-3);
    const auto reference = test::read_reference_json("pfv_500.json.gz");
    for (const Match& match : match_pores(network, reference)) {
        std::vector<double> expected = match.theirs["k"], found;
        for (const std::uint32_t t : network.pores.throat[match.ours]) {
            found.push_back(conductance[t]);
        }
        std::sort(expected.begin(), expected.end());
        std::sort(found.begin(), found.end());
        for (std::size_t k = 0; k < 4; ++k) {
            EXPECT_NEAR(found[k] / expected[k], 1, 1e-10); // the reference's own tolerance
        }
    }
}

TEST(Conductance, LengthHasAFloorAndViscosityDivides) {
    const double far = throat_conductance(2.0, 0.5, 4.0, 0.1);
    EXPECT_NEAR(far, 2.0 * 1.0 / (8 * 0.1 * 4.0), 1e-15);
    EXPECT_EQ(throat_conductance(2.0, 0.5, 1e-9, 0.1), throat_conductance(2.0, 0.5, 1e-6, 0.1));
    EXPECT_EQ(throat_conductance(2.0, 0.5, 4.0, 0.2), far / 2);
}

TEST(Pressure, InEveryPoreIsThatOfTheReference) {
    const Packing packing = test::reference_spheres("packing500");
    const pores::PoreNetwork network = build(packing);
    const Vec3 gradient{490.5, 0, 0};
    const FlowField field = solve_pressure(network, conductances(network, 1e-3), gradient);
    const Mat3 inverse_h = inverse(packing.h);
    double low = 1e300, high = -1e300, least = 1e300, most = -1e300;
    for (const Match& match : match_pores(network, test::read_reference_json("pfv_500.json.gz"))) {
        const auto& c = match.theirs["center"];
        const Vec3 apart = inverse_h * (network.pores.center[match.ours] - Vec3{c[0], c[1], c[2]});
        const Vec3 periods{std::round(apart.x), std::round(apart.y), std::round(apart.z)};
        EXPECT_NEAR(norm(packing.h * (apart - periods)), 0, 1e-12 * packing.h(0, 0));
        const double theirs = match.theirs["pp"];
        const double ours = field.pressure[match.ours] - dot(gradient, packing.h * periods);
        low = std::min(low, theirs), high = std::max(high, theirs);
        least = std::min(least, ours - theirs), most = std::max(most, ours - theirs);
    }
    EXPECT_LE(most - least, 1e-8 * (high - low)); // up to a constant; the reference's own tolerance
}

/// Flux through the plane where the cell coordinate along `axis` is `at`, counted throat by throat [m3/s].
double flux_through(const pores::PoreNetwork& network, const FlowField& field, int axis, double at) {
    const Mat3 inverse_h = inverse(network.h);
    const auto period = [&](const Vec3& x) { return std::floor((inverse_h * x)[axis] - at); };
    double sum = 0;
    for (std::size_t t = 0; t < network.throats.size(); ++t) {
        const auto [p, q] = network.throats.side[t];
        const Vec3 to = network.pores.center[q] + cell::shift(network.h, network.throats.image[t]);
        sum += field.flux[t] * (period(to) - period(network.pores.center[p]));
    }
    return sum;
}

TEST(Pressure, FluxThroughEveryCrossSectionIsTheSame) {
    for (const Packing& packing : {test::reference_spheres("packing2000"), sheared_packing()}) {
        const pores::PoreNetwork network = build(packing);
        const std::vector<double> conductance = conductances(network, 1e-3);
        const FlowField field = solve_pressure(network, conductance, {300, -200, 100});
        const Vec3 velocity = mean_velocity(network, field.flux);
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 section = cross(packing.h.column((axis + 1) % 3), packing.h.column((axis + 2) % 3));
            const double expected = dot(velocity, section);
            for (int k = 0; k < 100; ++k) {
                EXPECT_NEAR(flux_through(network, field, axis, 0.01 * k) / expected, 1, 1e-8);
            }
        }
        EXPECT_LE(field.net_outflow, 1e-9 * norm(velocity) * std::pow(determinant(packing.h), 2.0 / 3));
        EXPECT_LE(field.residual, 1e-12);
    }
}

TEST(Pressure, IsLinearInTheGradient) {
    const Packing packing = sheared_packing();
    const pores::PoreNetwork network = build(packing);
    const std::vector<double> conductance = conductances(network, 1e-3);
    const PressureSolver solver(network, conductance);
    const FlowField x = solver.solve({1, 0, 0}), y = solver.solve({0, 1, 0}), both = solver.solve({2, -3, 0});
    const auto [least, most] = std::minmax_element(both.pressure.begin(), both.pressure.end());
    for (std::size_t p = 0; p < network.pores.size(); ++p) {
        EXPECT_NEAR(both.pressure[p], 2 * x.pressure[p] - 3 * y.pressure[p], 1e-9 * (*most - *least));
    }
}

TEST(Pressure, MeanIsThatOfTheMeanGradientAtThePores) {
    const Packing packing = sheared_packing();
    const pores::PoreNetwork network = build(packing);
    const Vec3 gradient{1, 2, 3};
    const FlowField field = solve_pressure(network, conductances(network, 1e-3), gradient);
    double sum = 0, scale = 0;
    for (std::size_t p = 0; p < network.pores.size(); ++p) {
        sum += field.pressure[p] - dot(gradient, network.pores.center[p]);
        scale += std::abs(field.pressure[p]);
    }
    EXPECT_NEAR(sum / scale, 0, 1e-13);
}

TEST(Pressure, SaysSoWhenItDoesNotConverge) {
    const Packing packing = sheared_packing();
    const pores::PoreNetwork network = build(packing);
    const std::vector<double> conductance = conductances(network, 1e-3);
    try {
        (void)solve_pressure(network, conductance, {1, 0, 0}, {.tolerance = 1e-12, .iteration_limit = 2});
        FAIL() << "two iterations cannot be enough";
    } catch (const SolverError& error) {
        EXPECT_EQ(error.iterations, 2);
        EXPECT_GT(error.residual, 1e-12);
    }
}

TEST(Pressure, SameBitsForAnyNumberOfThreads) {
    const Packing packing = test::reference_spheres("packing500");
    const pores::PoreNetwork network = build(packing);
    const std::vector<double> conductance = conductances(network, 1e-3);
    const FlowField one = solve_pressure(network, conductance, {1, 0, 0});
    for (const int threads : {2, 4}) {
        set_thread_count(threads);
        const FlowField many = solve_pressure(network, conductance, {1, 0, 0});
        const Vec3 velocity = mean_velocity(network, many.flux);
        set_thread_count(1);
        EXPECT_EQ(one.pressure, many.pressure);
        EXPECT_EQ(one.flux, many.flux);
        EXPECT_EQ(mean_velocity(network, one.flux), velocity);
    }
}

} // namespace
} // namespace suffuse::flow
