#pragma once
// Potentials on a weighted graph: sum_j w_ij (x_i - x_j) = b_i, the equation of a pore network. Its weights differ by
// ten orders of magnitude (somewhere in every packing pore centers almost coincide), which incomplete factors do not
// survive. Here strongly coupled nodes are joined pairwise, again and again; the smaller graphs precondition the larger
// ones (aggregation and K-cycle, [Notay 2010]) in conjugate gradients. The constant that each part of the graph leaves
// free needs no pinned node.

#include "suffuse/flow/weighted_graph.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace suffuse::flow {

class GraphMultigrid {
public:
    /// `graph`: without ground.
    explicit GraphMultigrid(const WeightedGraph& graph);

    struct Result {
        std::vector<double> x; ///< zero at one node of each part
        int iterations = 0;
        double imbalance = 0; ///< size() of b - A x
    };

    /// Solves for a source `b` whose sum is zero over every connected part of the graph, until the size() of the
    /// imbalance is at most `wanted` or the limit of iterations is reached; the caller judges `imbalance`.
    [[nodiscard]] Result solve(std::span<const double> b, double wanted, int iteration_limit) const;

    /// Size of a source as the change of potential that it asks of each node: stiff couplings do not drown the others.
    [[nodiscard]] double size(std::span<const double> b) const;

    /// The graph solved, with its ground.
    [[nodiscard]] const WeightedGraph& graph() const { return levels_.front().graph; }

    [[nodiscard]] std::size_t levels() const { return levels_.size(); }

    /// Stored couplings of all levels over those of the first.
    [[nodiscard]] double complexity() const;

private:
    struct Level {
        WeightedGraph graph;
        std::vector<std::uint32_t> coarse; ///< node of the next level that a node belongs to
    };

    struct Work; ///< columns of one level during a solution

    void factor_last();
    void solve_last(std::span<const double> b, std::span<double> x) const;
    void cycle(std::size_t l, std::span<const double> b, std::span<double> x, std::vector<Work>& work) const;
    void solve_coarse(std::size_t l, std::vector<Work>& work) const;

    std::vector<Level> levels_;
    std::vector<double> factor_; ///< Cholesky factor of the last level, dense, by rows
};

} // namespace suffuse::flow
