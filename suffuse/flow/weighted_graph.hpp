#pragma once
// A weighted graph as sorted rows, what a pore network is to a linear solver, and its contraction by joining strongly
// coupled nodes.

#include <cstdint>
#include <span>
#include <vector>

namespace suffuse::flow {

/// An undirected edge; edges between the same nodes add up, an edge from a node to itself does nothing.
struct GraphEdge {
    std::uint32_t i, j;
    double weight; ///< not negative
};

struct WeightedGraph {
    std::vector<std::uint32_t> first;  ///< node i has the neighbors [first[i], first[i + 1]), in rising order,
    std::vector<std::uint32_t> middle; ///< those below i up to middle[i]
    std::vector<std::uint32_t> neighbor;
    std::vector<double> weight;
    std::vector<double> ground;      ///< coupling of a node to the potential zero
    std::vector<double> sum;         ///< of all weights of a node, that to the ground included
    std::vector<double> inverse_sum; ///< 0 where the sum is 0

    [[nodiscard]] std::size_t size() const { return sum.size(); }
};

/// A graph without ground.
WeightedGraph make_graph(std::size_t nodes, std::span<const GraphEdge> edges);

/// The graph with one node of each connected part made ground: the potentials are then determined. Such a node keeps
/// its row, without neighbors.
WeightedGraph grounded(const WeightedGraph& graph);

/// A group for each node, numbered from 0.
struct Grouping {
    std::vector<std::uint32_t> group;
    std::uint32_t groups = 0;
};

/// Joins every node with its most strongly coupled free neighbor. A node whose free neighbors couple much more weakly
/// than its strongest one joins the group of that one.
Grouping join_pairs(const WeightedGraph& graph);

/// The graph of groups; weights between two groups add up.
WeightedGraph contracted(const WeightedGraph& graph, const Grouping& grouping);

/// y_i = sum_j w_ij (x_i - x_j) + ground_i x_i for the nodes of [begin, end), or for all.
void multiply(
    const WeightedGraph& graph, std::span<const double> x, std::span<double> y, std::size_t begin, std::size_t end
);
void multiply(const WeightedGraph& graph, std::span<const double> x, std::span<double> y);

} // namespace suffuse::flow
