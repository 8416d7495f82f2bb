#pragma once
// A weighted graph as sorted rows, what a pore network is to a linear solver, and its contraction by joining strongly
// coupled nodes.

#include "suffuse/base/raw_column.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace suffuse::flow {

struct WeightedGraph {
    RawColumn<std::uint32_t> first; ///< node i has the neighbors [first[i], first[i + 1]), in rising order
    RawColumn<std::uint32_t> neighbor;
    RawColumn<double> weight;
    RawColumn<double> ground; ///< coupling of a node to the potential zero
    RawColumn<double> sum;    ///< of all weights of a node, that to the ground included

    [[nodiscard]] std::size_t size() const { return sum.size(); }

    /// 0 where the sum is 0.
    [[nodiscard]] double inverse_sum(std::size_t i) const { return sum[i] > 0 ? 1 / sum[i] : 0; }
};

/// What a node is coupled to, in any order, and the weights. Entries of one neighbor add up; entries of the node itself
/// and those of no weight do nothing.
using GraphRow = std::vector<std::pair<std::uint32_t, double>>;

/// The graph of the couplings that `gather(i, row)` puts into the empty row of node i; it returns the coupling to the
/// ground. Called on several threads.
/// @pre node i is coupled to node j as j is to i
WeightedGraph make_graph(std::size_t nodes, const std::function<double(std::uint32_t, GraphRow&)>& gather);

/// The graph with one node of each connected part made ground: the potentials are then determined. Such a node keeps
/// its row, without neighbors.
WeightedGraph grounded(const WeightedGraph& graph);

/// A group for each node, numbered from 0.
struct Grouping {
    RawColumn<std::uint32_t> group;
    std::uint32_t groups = 0;
};

/// Nodes that follow each other and choose before those of other such blocks, side by side with these: a constant, so
/// that nothing depends on the threads. The flow through 10,000 grains is one block.
inline constexpr std::size_t nodes_together = 65'536;

/// Joins every node with its most strongly coupled free neighbor. A node whose free neighbors couple much more weakly
/// than its strongest one joins the group of that one. Nodes of a block choose one after the other; where the strongest
/// neighbor lies in another block, a node chooses at the end.
Grouping join_pairs(const WeightedGraph& graph);

/// The graph of groups; weights between two groups add up.
WeightedGraph contracted(const WeightedGraph& graph, const Grouping& grouping);

/// y_i = sum_j w_ij (x_i - x_j) + ground_i x_i for the nodes of [begin, end), or for all.
void multiply(
    const WeightedGraph& graph, std::span<const double> x, std::span<double> y, std::size_t begin, std::size_t end
);
void multiply(const WeightedGraph& graph, std::span<const double> x, std::span<double> y);

} // namespace suffuse::flow
