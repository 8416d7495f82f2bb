#pragma once
// A node of the atlas: the samples of one size ratio, fines content, density and flow, which differ in their seed
// alone.

#include "suffuse/atlas/grid.hpp"
#include "suffuse/atlas/row.hpp"
#include "suffuse/atlas/value.hpp"

namespace suffuse::atlas {

/// Gradients are over i_c, so that soils of other porosities can be compared; none where a sample did not reach it.
struct Node {
    double size_ratio = 0;    ///< [-]
    double fines_content = 0; ///< [-]
    double porosity = 0;      ///< [-]
    Value alpha;              ///< [-]
    std::optional<Value> moves_1, moves_10;
    Floor least_1, least_10;
    std::vector<Row> rows; ///< one a seed
};

/// In order of size ratio, then of fines content.
std::vector<Node> gather_nodes(const std::vector<Row>& rows, Density density, Flow flow);

/// Over the logarithm of the size ratio and the fines content.
Grid grid_of(const std::vector<Node>& nodes);

/// A node and its share in what is interpolated.
struct WeightedNode {
    const Node* node = nullptr;
    double weight = 0;
    bool counts = true; ///< as that of Corner
};

std::vector<WeightedNode> weighted(const std::vector<Node>& nodes, const std::vector<Corner>& corners);

/// Between nodes: porosity and alpha linear, gradients linear in their logarithm, as they span decades. An upper bound
/// of one node makes the result one. Where a node did not reach a gradient, only its floor is known.
/// Nodes that do not count lend their numbers, where they have them, and no more.
Node blend(const std::vector<WeightedNode>& nodes);

} // namespace suffuse::atlas
