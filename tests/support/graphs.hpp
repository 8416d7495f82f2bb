#pragma once
// Weighted graphs from lists of edges.

#include "suffuse/flow/weighted_graph.hpp"

namespace suffuse::test {

/// An undirected edge; edges between the same nodes add up.
struct GraphEdge {
    std::uint32_t i, j;
    double weight; ///< not negative
};

/// A graph without ground.
inline flow::WeightedGraph make_graph(std::size_t nodes, const std::vector<GraphEdge>& edges) {
    std::vector<flow::GraphRow> rows(nodes);
    for (const GraphEdge& e : edges) {
        rows[e.i].emplace_back(e.j, e.weight);
        rows[e.j].emplace_back(e.i, e.weight);
    }
    return flow::make_graph(nodes, [&](std::uint32_t i, flow::GraphRow& row) {
        row = rows[i];
        return 0.0;
    });
}

} // namespace suffuse::test
