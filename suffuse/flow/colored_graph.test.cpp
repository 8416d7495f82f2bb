#include "suffuse/flow/colored_graph.hpp"

#include <gtest/gtest.h>

#include "tests/support/graphs.hpp"
#include <algorithm>
#include <cmath>
#include <random>

namespace suffuse::flow {
namespace {

using test::GraphEdge;
using test::make_graph;

/// A ring with chords, one node of it ground.
WeightedGraph chorded_ring(std::uint32_t nodes) {
    std::mt19937_64 random(nodes);
    std::vector<GraphEdge> edges;
    for (std::uint32_t i = 0; i < nodes; ++i) {
        edges.push_back({i, (i + 1) % nodes, 1.0 + static_cast<double>(random() % 100)});
        edges.push_back({i, static_cast<std::uint32_t>(random() % nodes), 1.0 + static_cast<double>(random() % 100)});
    }
    return grounded(make_graph(nodes, edges));
}

/// One value a row from one a node; 0 in rows that fill up.
std::vector<float> by_row(const ColoredGraph& colored, const std::vector<double>& values) {
    std::vector<float> column(colored.rows(), 0.0F);
    for (std::size_t i = 0; i < values.size(); ++i) {
        column[colored.row[i]] = static_cast<float>(values[i]);
    }
    return column;
}

std::vector<double> some_values(std::size_t nodes) {
    std::vector<double> values;
    for (std::size_t i = 0; i < nodes; ++i) {
        values.push_back(std::sin(1.0 + 7.0 * static_cast<double>(i)));
    }
    return values;
}

/// What the nodes lack: b - A x, in double precision.
std::vector<double> residual_of(
    const WeightedGraph& graph, const ColoredGraph& colored, const std::vector<double>& b, const std::vector<float>& x
) {
    std::vector<double> by_node(graph.size()), image(graph.size());
    for (std::size_t i = 0; i < graph.size(); ++i) {
        by_node[i] = static_cast<double>(x[colored.row[i]]);
    }
    multiply(graph, by_node, image);
    for (std::size_t i = 0; i < graph.size(); ++i) {
        image[i] = b[i] - image[i];
    }
    return image;
}

TEST(ColoredGraph, NoTwoCoupledNodesShareAColor) {
    const WeightedGraph graph = chorded_ring(3 * nodes_together / 2); // chords from block to block
    const ColoredGraph colored = color_graph(graph);
    const auto color = [&](std::uint32_t node) {
        return std::upper_bound(colored.color.begin(), colored.color.end(), colored.row[node] / lanes);
    };
    for (std::uint32_t i = 0; i < graph.size(); ++i) {
        for (std::uint32_t k = graph.first[i]; k < graph.first[i + 1]; ++k) {
            EXPECT_NE(color(i), color(graph.neighbor[k]));
        }
    }
}

TEST(ColoredGraph, TheLastRowIsOfNoNode) {
    for (std::uint32_t nodes = 40; nodes < 40 + 4 * lanes; ++nodes) {
        const ColoredGraph colored = color_graph(chorded_ring(nodes));
        EXPECT_LT(*std::ranges::max_element(colored.row), colored.rows() - 1) << nodes;
    }
}

TEST(ColoredGraph, RowsReadNoneOfTheirOwnColorThatOtherThreadsWrite) {
    const ColoredGraph colored = color_graph(chorded_ring(333));
    std::size_t fillers = 0;
    for (std::size_t c = 0; c + 1 < colored.color.size(); ++c) {
        const std::size_t begin = lanes * colored.color[c], end = lanes * colored.color[c + 1];
        for (const LaneRows* const couplings : {&colored.before, &colored.after}) {
            for (std::size_t s = lanes * couplings->first[colored.color[c]];
                 s < lanes * couplings->first[colored.color[c + 1]]; ++s) {
                EXPECT_FALSE(begin <= couplings->column[s] && couplings->column[s] < end) << "color " << c;
                fillers += couplings->weight[s] == 0 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(fillers, 0);
}

TEST(ColoredGraph, ProductIsThatOfTheGraph) {
    const WeightedGraph graph = chorded_ring(333);
    const ColoredGraph colored = color_graph(graph);
    const std::vector<double> x = some_values(graph.size());
    std::vector<double> expected(graph.size());
    multiply(graph, x, expected);
    const std::vector<float> rows = by_row(colored, x);
    std::vector<float> y(colored.rows());
    const Products products = multiply(colored, rows, rows, rows, y);
    double energy = 0, square = 0;
    for (std::size_t i = 0; i < graph.size(); ++i) {
        energy += x[i] * expected[i];
        square += x[i] * x[i];
        EXPECT_NEAR(y[colored.row[i]], expected[i], 1e-6 * graph.sum[i]); // single precision
    }
    EXPECT_NEAR(products.xy / energy, 1, 1e-6);
    EXPECT_NEAR(products.yc / energy, 1, 1e-6);
    EXPECT_NEAR(products.xb / square, 1, 1e-6);
}

TEST(ColoredGraph, SweepsBalanceTheNodesOfTheColorDoneLast) {
    const WeightedGraph graph = chorded_ring(500);
    const ColoredGraph colored = color_graph(graph);
    std::vector<double> b = some_values(graph.size());
    for (std::size_t i = 0; i < graph.size(); ++i) {
        b[i] = graph.sum[i] > 0 ? b[i] : 0; // the node that is ground lacks nothing
    }
    std::vector<float> x(colored.rows()), residual(colored.rows());
    const auto rounding = [&](std::size_t i) {
        float largest = 0;
        for (const float value : x) {
            largest = std::max(largest, std::abs(value));
        }
        return 1e-6 * (graph.sum[i] * static_cast<double>(largest) + 1); // of single precision
    };
    sweep_up(colored, by_row(colored, b), x);
    residual_after_sweep(colored, x, residual);
    const std::vector<double> after_up = residual_of(graph, colored, b, x);
    const std::size_t last_color = colored.color[colored.color.size() - 2];
    for (std::size_t i = 0; i < graph.size(); ++i) {
        EXPECT_NEAR(residual[colored.row[i]], after_up[i], rounding(i));
        if (colored.row[i] / lanes >= last_color) {
            EXPECT_NEAR(after_up[i], 0, rounding(i));
        }
    }
    sweep_down(colored, by_row(colored, b), x);
    const std::vector<double> after_down = residual_of(graph, colored, b, x);
    for (std::size_t i = 0; i < graph.size(); ++i) {
        if (colored.row[i] / lanes < colored.color[1]) {
            EXPECT_NEAR(after_down[i], 0, rounding(i));
        }
    }
}

} // namespace
} // namespace suffuse::flow
