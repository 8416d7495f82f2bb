#pragma once
// Potentials on a weighted graph: sum_j w_ij (x_i - x_j) = b_i, the equation of a pore network. Its weights differ by
// ten orders of magnitude (somewhere in every packing pore centers almost coincide), which incomplete factors do not
// survive. Conjugate gradients in double precision, preconditioned by a cycle over graphs of joined nodes. The same
// bits for any number of threads.

#include "suffuse/flow/aggregation_cycle.hpp"
#include "suffuse/flow/weighted_graph.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace suffuse::flow {

class GraphMultigrid {
public:
    /// `graph`: without ground.
    explicit GraphMultigrid(WeightedGraph graph);

    struct Result {
        RawColumn<double> x; ///< zero at one node of each part
        int iterations = 0;
        double imbalance = 0; ///< size() of b - A x
    };

    /// Solves for a source `b` whose sum is zero over every connected part of the graph, until the size() of the
    /// imbalance is at most `wanted` or the limit of iterations is reached; the caller judges `imbalance`.
    [[nodiscard]] Result solve(std::vector<double> b, double wanted, int iteration_limit) const;

    /// Size of a source as the change of potential that it needs at each node: stiff couplings do not drown the others.
    [[nodiscard]] double size(std::span<const double> b) const;

    /// The graph solved, with its ground.
    [[nodiscard]] const WeightedGraph& graph() const { return graph_; }

    /// Stored couplings of all levels over those of the first.
    [[nodiscard]] double complexity() const { return cycle_.complexity(); }

private:
    struct Descent; ///< columns of the conjugate gradients

    void precondition(double scale, Descent& descent) const;
    void turn(double scale, Descent& descent) const;
    [[nodiscard]] bool go_down(Descent& descent) const;

    WeightedGraph graph_;
    AggregationCycle cycle_;
};

} // namespace suffuse::flow
