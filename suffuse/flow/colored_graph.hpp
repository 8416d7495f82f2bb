#pragma once
// A weighted graph laid out for Gauss-Seidel sweeps: nodes are colored so that no two coupled ones have the same color,
// rows of one color lie side by side and are done at the same time, `lanes` of them in one go and blocks of them on
// several threads. Single precision: this is what preconditions, not what is solved.

#include "suffuse/base/raw_column.hpp"
#include "suffuse/flow/weighted_graph.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace suffuse::flow {

inline constexpr std::size_t lanes = 8; ///< rows done side by side: a group

/// Sparse rows, a group at a time: entry s of the rows of group q are the `lanes` entries from lanes * (first[q] + s)
/// on. Shorter rows are filled up with entries of weight zero.
struct LaneRows {
    std::vector<std::uint32_t> first; ///< per group, and one more
    RawColumn<std::uint32_t> column;
    RawColumn<float> weight;
};

/// The last row is of no node. What only fills up a group points to the first row in `before` and to the last in
/// `after`: no sweep writes a row while it reads it so, for rows of the first color have nothing before them, and those
/// of the last nothing after.
struct ColoredGraph {
    RawColumn<std::uint32_t> row;     ///< of each node
    std::vector<std::uint32_t> color; ///< the groups of color c are [color[c], color[c + 1])
    LaneRows before, after;           ///< couplings to rows of earlier and of later colors
    RawColumn<float> inverse_sum;     ///< of all couplings of a row; 0 for rows that only fill up a group
    RawColumn<float> ground;

    [[nodiscard]] std::size_t rows() const { return inverse_sum.size(); } ///< those that fill up included
};

/// Colors the nodes of a block (`nodes_together`) one after the other, each with the first color that none of its
/// neighbors there has. Where a neighbor in an earlier block has it too, a node chooses anew at the end.
ColoredGraph color_graph(const WeightedGraph& graph);

/// Gauss-Seidel from x = 0, first color first. Columns have a place a row, as all below.
void sweep_up(const ColoredGraph& graph, std::span<const float> b, std::span<float> x);

/// b - A x after `sweep_up`: only couplings to later colors are out of balance.
void residual_after_sweep(const ColoredGraph& graph, std::span<const float> x, std::span<float> residual);

/// Gauss-Seidel, last color first.
void sweep_down(const ColoredGraph& graph, std::span<const float> b, std::span<float> x);

/// Scalar products of the steps of conjugate gradients, summed in double precision.
struct Products {
    double xy = 0, xb = 0, yc = 0;

    friend Products operator+(const Products& p, const Products& q) { return {p.xy + q.xy, p.xb + q.xb, p.yc + q.yc}; }
};

/// y_i = sum_j w_ij (x_i - x_j) + ground_i x_i, and products with b and c.
Products multiply(
    const ColoredGraph& graph, std::span<const float> x, std::span<const float> b, std::span<const float> c,
    std::span<float> y
);

} // namespace suffuse::flow
