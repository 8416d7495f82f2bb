#include "suffuse/flow/graph_multigrid.hpp"

#include "suffuse/base/parallel.hpp"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include "tests/support/graphs.hpp"
#include <cmath>
#include <random>

namespace suffuse::flow {
namespace {

using test::GraphEdge;
using test::make_graph;

/// A ring with random chords; weights over `decades` orders of magnitude.
std::vector<GraphEdge> random_edges(std::uint32_t nodes, double decades, unsigned seed) {
    std::mt19937_64 random(seed);
    const auto uniform = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
    std::vector<GraphEdge> edges;
    for (std::uint32_t i = 0; i < nodes; ++i) {
        edges.push_back({i, (i + 1) % nodes, std::pow(10.0, decades * uniform())});
        edges.push_back({i, static_cast<std::uint32_t>(random() % nodes), std::pow(10.0, decades * uniform())});
    }
    return edges;
}

std::vector<double> balanced_source(std::size_t nodes, unsigned seed) {
    std::mt19937_64 random(seed);
    std::vector<double> b(nodes);
    double sum = 0;
    for (double& v : b) {
        v = std::ldexp(static_cast<double>(random() >> 11), -53);
        sum += v;
    }
    for (double& v : b) {
        v -= sum / static_cast<double>(nodes);
    }
    return b;
}

/// Direct solution with the potential of node 0 set to zero.
Eigen::VectorXd direct(const WeightedGraph& graph, const std::vector<double>& b) {
    const auto n = static_cast<int>(graph.size()) - 1;
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right(n);
    for (std::uint32_t i = 1; i < graph.size(); ++i) {
        right[static_cast<int>(i) - 1] = b[i];
        entries.emplace_back(i - 1, i - 1, graph.sum[i]);
        for (std::uint32_t k = graph.first[i]; k < graph.first[i + 1]; ++k) {
            if (graph.neighbor[k] > 0) {
                entries.emplace_back(i - 1, graph.neighbor[k] - 1, -graph.weight[k]);
            }
        }
    }
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right);
}

TEST(GraphMultigrid, SolvesLikeADirectSolver) {
    for (const double decades : {0.0, 3.0, 8.0}) {
        for (const std::uint32_t nodes : {2U, 5U, 40U, 300U, 3000U}) {
            const std::vector<GraphEdge> edges = random_edges(nodes, decades, nodes);
            const GraphMultigrid multigrid(make_graph(nodes, edges));
            const std::vector<double> b = balanced_source(nodes, 7);
            const auto result = multigrid.solve(b, 1e-12 * multigrid.size(b), 200);
            EXPECT_LE(result.imbalance, 1e-12 * multigrid.size(b));
            const Eigen::VectorXd expected = direct(make_graph(nodes, edges), b);
            double range = 0, worst = 0;
            for (std::uint32_t i = 1; i < nodes; ++i) {
                range = std::max(range, std::abs(expected[static_cast<int>(i) - 1]));
                worst = std::max(worst, std::abs(result.x[i] - expected[static_cast<int>(i) - 1]));
            }
            // Both carry the rounding of weights that differ by the decades.
            EXPECT_LE(worst, 1e-9 * range) << nodes << " nodes, " << decades << " decades";
        }
    }
}

/// A periodic cubic grid, as local as a pore network.
std::vector<GraphEdge> grid_edges(std::uint32_t side, double decades) {
    std::mt19937_64 random(side);
    const auto uniform = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
    std::vector<GraphEdge> edges;
    const auto node = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        return (i % side * side + j % side) * side + k % side;
    };
    for (std::uint32_t i = 0; i < side; ++i) {
        for (std::uint32_t j = 0; j < side; ++j) {
            for (std::uint32_t k = 0; k < side; ++k) {
                for (const std::uint32_t other : {node(i + 1, j, k), node(i, j + 1, k), node(i, j, k + 1)}) {
                    edges.push_back({node(i, j, k), other, std::pow(10.0, decades * uniform())});
                }
            }
        }
    }
    return edges;
}

TEST(GraphMultigrid, NeedsFewIterationsOnWeightsOfAnySpread) {
    for (const double decades : {0.0, 4.0, 8.0}) {
        const GraphMultigrid multigrid(make_graph(30 * 30 * 30, grid_edges(30, decades)));
        const std::vector<double> b = balanced_source(30 * 30 * 30, 5);
        const auto result = multigrid.solve(b, 1e-10 * multigrid.size(b), 200);
        EXPECT_LE(result.imbalance, 1e-10 * multigrid.size(b));
        EXPECT_LE(result.iterations, 30);
        EXPECT_LE(multigrid.complexity(), 3); // memory stays linear in the graph
    }
}

TEST(GraphMultigrid, SameBitsForAnyNumberOfThreads) {
    constexpr std::uint32_t side = 52, nodes = side * side * side;
    static_assert(nodes > 2 * nodes_together, "several blocks of nodes choose side by side");
    const std::vector<double> b = balanced_source(nodes, 5);
    std::vector<RawColumn<double>> solutions;
    for (const int threads : {1, 2, 4}) {
        set_thread_count(threads);
        const GraphMultigrid multigrid(make_graph(nodes, grid_edges(side, 8)));
        solutions.push_back(multigrid.solve(b, 1e-10 * multigrid.size(b), 200).x);
    }
    set_thread_count(1);
    EXPECT_EQ(solutions[0], solutions[1]);
    EXPECT_EQ(solutions[0], solutions[2]);
}

TEST(GraphMultigrid, PartsMayBeApart) {
    std::vector<GraphEdge> edges;
    for (std::uint32_t part = 0; part < 3; ++part) {
        for (GraphEdge e : random_edges(100, 2, part)) {
            edges.push_back({e.i + 100 * part, e.j + 100 * part, e.weight});
        }
    }
    const GraphMultigrid multigrid(make_graph(301, edges)); // the last node is alone
    std::vector<double> b(301, 0.0);
    b[3] = 1, b[70] = -1, b[110] = 2, b[111] = -2;
    const auto result = multigrid.solve(b, 1e-13 * multigrid.size(b), 200);
    std::vector<double> balance(301);
    multiply(make_graph(301, edges), result.x, balance);
    for (std::size_t i = 0; i < b.size(); ++i) {
        EXPECT_NEAR(balance[i], b[i], 1e-11);
    }
}

TEST(GraphMultigrid, NoSourceNoPotential) {
    const GraphMultigrid multigrid(make_graph(100, random_edges(100, 2, 1)));
    const auto result = multigrid.solve(std::vector<double>(100, 0.0), 1e-12, 10);
    EXPECT_EQ(result.iterations, 0);
    EXPECT_EQ(result.x, RawColumn<double>(100, 0.0));
}

TEST(WeightedGraph, GroundIsOneNodeOfEachPart) {
    const std::vector<GraphEdge> edges = {{0, 1, 2}, {1, 2, 3}, {3, 4, 5}};
    const WeightedGraph graph = grounded(make_graph(6, edges));
    EXPECT_EQ(graph.ground, (RawColumn<double>{0, 2, 0, 0, 5, 0}));
    EXPECT_EQ(graph.sum, (RawColumn<double>{0, 5, 3, 0, 5, 0}));
    EXPECT_EQ(graph.weight, (RawColumn<double>{3, 3}));
}

TEST(WeightedGraph, ParallelEdgesAddUpAndLoopsDoNothing) {
    const std::vector<GraphEdge> edges = {{0, 1, 2}, {1, 0, 3}, {1, 1, 9}, {2, 1, 1}, {0, 2, 0}};
    const WeightedGraph graph = make_graph(3, edges);
    EXPECT_EQ(graph.first, (RawColumn<std::uint32_t>{0, 1, 3, 4}));
    EXPECT_EQ(graph.neighbor, (RawColumn<std::uint32_t>{1, 0, 2, 1}));
    EXPECT_EQ(graph.weight, (RawColumn<double>{5, 5, 1, 1}));
    EXPECT_EQ(graph.sum, (RawColumn<double>{5, 6, 1}));
}

} // namespace
} // namespace suffuse::flow
