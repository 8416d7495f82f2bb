// The cycle as a rough inverse: exact where the smallest graph is the whole, and near enough to precondition elsewhere.

#include "suffuse/flow/aggregation_cycle.hpp"

#include "suffuse/base/parallel.hpp"

#include <gtest/gtest.h>

#include "tests/support/graphs.hpp"
#include <cmath>
#include <random>

namespace suffuse::flow {
namespace {

/// A chain of nodes, coupled by 1, with one of them ground.
WeightedGraph chain(std::uint32_t nodes) {
    std::vector<test::GraphEdge> edges;
    for (std::uint32_t i = 0; i + 1 < nodes; ++i) {
        edges.push_back({i, i + 1, 1.0});
    }
    return grounded(test::make_graph(nodes, edges));
}

/// A cube of side^3 nodes, each coupled to its neighbors.
WeightedGraph cube(std::uint32_t side) {
    std::vector<test::GraphEdge> edges;
    const std::uint32_t nodes = side * side * side;
    for (std::uint32_t i = 0; i < nodes; ++i) {
        for (const std::uint32_t step : {1U, side, side * side}) {
            if (i / step % side + 1 < side) {
                edges.push_back({i, i + step, 1.0});
            }
        }
    }
    return grounded(test::make_graph(nodes, edges));
}

/// One cycle for the right side b, by node.
std::vector<double> cycle(const WeightedGraph& graph, const std::vector<double>& b) {
    const AggregationCycle inverse(graph);
    AggregationCycle::Columns columns = inverse.columns();
    for (std::size_t i = 0; i < b.size(); ++i) {
        columns.source()[inverse.row(i)] = static_cast<float>(b[i]);
    }
    inverse.apply(columns);
    std::vector<double> x(b.size());
    for (std::size_t i = 0; i < b.size(); ++i) {
        x[i] = columns.correction()[inverse.row(i)];
    }
    return x;
}

double norm_of(const std::vector<double>& v) {
    double sum = 0;
    for (const double one : v) {
        sum += one * one;
    }
    return std::sqrt(sum);
}

std::vector<double> random_source(const WeightedGraph& graph) {
    std::mt19937_64 random(5);
    std::vector<double> b(graph.size());
    for (std::size_t i = 0; i < b.size(); ++i) {
        const bool is_free = graph.first[i] != graph.first[i + 1];
        b[i] = is_free ? std::ldexp(static_cast<double>(random() >> 11), -53) - 0.5 : 0;
    }
    return b;
}

/// Norm of b - A x over that of b.
double residual(const WeightedGraph& graph, const std::vector<double>& b) {
    const std::vector<double> x = cycle(graph, b);
    std::vector<double> left(b.size());
    multiply(graph, x, left);
    for (std::size_t i = 0; i < b.size(); ++i) {
        left[i] = b[i] - left[i];
    }
    return norm_of(left) / norm_of(b);
}

TEST(AggregationCycle, SolvesASmallChainExactly) {
    const WeightedGraph graph = chain(5);
    std::vector<double> b = random_source(graph);
    EXPECT_EQ(AggregationCycle(graph).complexity(), 1);
    EXPECT_LT(residual(graph, b), 1e-5); // a few roundings of single precision
}

TEST(AggregationCycle, TakesMostOfTheResidualOfALargeGraphAway) {
    const WeightedGraph graph = cube(30);
    EXPECT_LT(residual(graph, random_source(graph)), 0.5); // K-cycles converge by about that at any size [Notay 2010]
    // Half the nodes a level, and somewhat more than half of the couplings: 2.04 for this cube.
    EXPECT_LT(AggregationCycle(graph).complexity(), 2.1);
}

TEST(AggregationCycle, HasTheSameBitsForAnyNumberOfThreads) {
    const WeightedGraph graph = cube(30);
    const std::vector<double> b = random_source(graph);
    const int before = thread_count();
    set_thread_count(1);
    const std::vector<double> alone = cycle(graph, b);
    set_thread_count(3);
    EXPECT_EQ(cycle(graph, b), alone);
    set_thread_count(before);
}

TEST(AggregationCycle, OfNoSourceIsNothing) {
    const WeightedGraph graph = cube(12);
    EXPECT_EQ(norm_of(cycle(graph, std::vector<double>(graph.size(), 0.0))), 0);
}

} // namespace
} // namespace suffuse::flow
