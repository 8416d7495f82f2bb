#pragma once
// A rough inverse of the equations of a weighted graph: strongly coupled nodes are joined pairwise, again and again,
// and the smaller graphs correct the larger ones (aggregation and K-cycle, [Notay 2010]). In single precision: it
// preconditions. The same bits for any number of threads.

#include "suffuse/flow/colored_graph.hpp"
#include "suffuse/flow/weighted_graph.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace suffuse::flow {

class AggregationCycle {
public:
    explicit AggregationCycle(const WeightedGraph& graph);

    /// Columns of one level, a place a row.
    struct Work {
        RawColumn<float> b, x, v2; ///< on all levels
        RawColumn<float> c1, v1;   ///< where the level corrects another
        RawColumn<float> r, c2;    ///< where it does so in two steps
    };

    /// What one cycle after the other works on.
    struct Columns {
        std::vector<Work> levels;

        RawColumn<float>& source() { return levels.front().b; } ///< given, a place a row: row(node)

        RawColumn<float>& correction() { return levels.front().x; } ///< found
    };

    [[nodiscard]] Columns columns() const;

    /// One cycle from zero. It is not quite a linear map.
    void apply(Columns& columns) const;

    /// Place of a node in the columns.
    [[nodiscard]] std::size_t row(std::size_t node) const {
        return levels_.empty() ? node : levels_[0].graph.row[node];
    }

    /// Stored couplings of all levels over those of the first.
    [[nodiscard]] double complexity() const { return complexity_; }

private:
    struct Level {
        ColoredGraph graph;
        RawColumn<std::uint32_t> coarse; ///< row of the next level that a row belongs to
        LaneRows members;                ///< rows of this level that belong to a row of the next
    };

    void link(std::size_t l, std::span<const std::uint32_t> group);
    [[nodiscard]] std::size_t rows(std::size_t l) const; ///< of level l, which may be the last, the factored one
    void factor(const WeightedGraph& graph);
    void solve_last(std::span<const float> b, std::span<float> x) const;
    void cycle(std::size_t l, std::span<const float> b, std::span<float> x, std::vector<Work>& work) const;
    void solve_coarse(std::size_t l, std::vector<Work>& work) const;

    std::vector<Level> levels_;
    std::vector<double> factor_; ///< Cholesky factor of the smallest graph, dense, by rows
    std::size_t last_nodes_ = 0; ///< of the smallest graph
    double complexity_ = 1;
};

} // namespace suffuse::flow
