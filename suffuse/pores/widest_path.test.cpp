#include "suffuse/pores/widest_path.hpp"

#include <gtest/gtest.h>

#include "tests/support/packings.hpp"
#include <limits>
#include <queue>
#include <set>

namespace suffuse::pores {
namespace {

using test::Packing;

PoreNetwork build(const Packing& packing) {
    return build_network(packing.h, packing.position, packing.radius);
}

void expect_radius(const Packing& packing, double r) {
    const PoreNetwork network = build(packing);
    for (int axis = 0; axis < 3; ++axis) {
        const std::vector<double> widest = widest_paths(network, axis);
        ASSERT_EQ(widest.size(), network.pores.size());
        for (const double d : widest) {
            EXPECT_NEAR(d, 2 * r, 1e-12);
        }
    }
}

TEST(WidestPath, ThroughLatticesHasItsClosedForm) {
    for (const int cells : {1, 2, 3}) {
        expect_radius(test::simple_cubic(cells, 1), std::sqrt(2.0) - 1);
        expect_radius(test::body_centered(cells, 1), 0.2247448713915890);
        expect_radius(test::face_centered(cells, 1), 2 / std::sqrt(3.0) - 1);
    }
}

/// Whether a path of throats at least this wide leads from `pore` one period along `axis`, by walking through a world
/// of copies of the cell, `reach` periods wide either way.
bool leads_through(const PoreNetwork& network, std::uint32_t pore, int axis, double diameter, int reach) {
    using Place = std::pair<std::uint32_t, cell::Image>;
    std::set<Place> seen = {{pore, {}}};
    std::queue<Place> next;
    next.push({pore, {}});
    while (!next.empty()) {
        const auto [p, at] = next.front();
        next.pop();
        for (std::size_t k = 0; k < 4; ++k) {
            if (2 * network.throats.inscribed_radius[network.pores.throat[p][k]] < diameter) {
                continue;
            }
            const PlacedPore beyond = pore_beyond(network, p, k);
            const cell::Image to = at + beyond.image;
            const std::uint32_t q = beyond.pore;
            if (std::max({std::abs(to.a), std::abs(to.b), std::abs(to.c)}) > reach) {
                continue;
            }
            if (q == pore && (axis == 0 ? to.a : axis == 1 ? to.b : to.c) == 1) {
                return true;
            }
            if (seen.insert({q, to}).second) {
                next.push({q, to});
            }
        }
    }
    return false;
}

TEST(WidestPath, OnDilutedPackingsIsThatOfAnExhaustiveWalk) {
    for (const unsigned seed : {1U, 2U, 3U, 4U}) {
        const Mat3 h = seed % 2 == 0 ? identity() : from_columns({1, 0.2, 0}, {0.3, 0.8, 0}, {0, 0.1, 1.2});
        const Packing packing = test::random_packing(h, 12, 0.1, 0.17, seed);
        const PoreNetwork network = build(packing);
        for (int axis = 0; axis < 3; ++axis) {
            const std::vector<double> widest = widest_paths(network, axis);
            for (std::uint32_t p = 0; p < network.pores.size(); p += 5) {
                ASSERT_GT(widest[p], 0);
                EXPECT_TRUE(leads_through(network, p, axis, widest[p], 3)) << seed << " axis " << axis << " pore " << p;
                EXPECT_FALSE(leads_through(network, p, axis, widest[p] * (1 + 1e-12), 3)) << seed << " pore " << p;
            }
        }
    }
}

/// A hand-made network: throats of given diameter between pores, displaced by periods.
struct Link {
    std::uint32_t p, q;
    cell::Image image;
    double diameter;
};

PoreNetwork network_of(std::size_t pores, const std::vector<Link>& links) {
    PoreNetwork network;
    network.pores.grain.resize(pores);
    for (const Link& link : links) {
        network.throats.side.push_back({link.p, link.q});
        network.throats.image.emplace_back(link.image);
        network.throats.inscribed_radius.push_back(link.diameter / 2);
    }
    return network;
}

TEST(WidestPath, CountsPeriodsAlongTheAxisOnly) {
    // Pore 0 loops along (1, 1, 0): along b as well as along a, whatever the other axis does. Pore 1 depends on it.
    const PoreNetwork network = network_of(2, {{0, 0, {1, 1, 0}, 4}, {0, 1, {0, 0, 1}, 2}});
    EXPECT_EQ(widest_paths(network, 0), (std::vector<double>{4, 2}));
    EXPECT_EQ(widest_paths(network, 1), (std::vector<double>{4, 2}));
    const double no = -std::numeric_limits<double>::infinity();
    EXPECT_EQ(widest_paths(network, 2), (std::vector<double>{no, no}));
}

TEST(WidestPath, NeedsExactlyOnePeriod) {
    // Loops of two and of three periods lead through only together: 3 - 2 = 1.
    const PoreNetwork network = network_of(2, {{0, 0, {2, 0, 0}, 5}, {1, 1, {3, 0, 0}, 4}, {0, 1, {0, 0, 0}, 3}});
    EXPECT_EQ(widest_paths(network, 0), (std::vector<double>{3, 3}));
}

TEST(WidestPath, JoinsPoresThatWereThroughAlready) {
    const PoreNetwork network =
        network_of(3, {{0, 0, {1, 0, 0}, 5}, {1, 1, {-1, 0, 0}, 4}, {0, 1, {0, 0, 0}, 3}, {2, 1, {0, 1, 0}, 1}});
    EXPECT_EQ(widest_paths(network, 0), (std::vector<double>{5, 4, 1}));
}

TEST(WidestPath, AxisIsTheOneClosestToTheFlow) {
    const Mat3 h = from_columns({2, 0, 0}, {0.3, 1, 0}, {0, 0, 5});
    EXPECT_EQ(axis_along(h, {-1, 0.1, 0}), 0);
    EXPECT_EQ(axis_along(h, {0.2, 1, 0.1}), 1);
    EXPECT_EQ(axis_along(h, {0, 0, -3}), 2);
}

} // namespace
} // namespace suffuse::pores
