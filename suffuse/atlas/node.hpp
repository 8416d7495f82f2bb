#pragma once
// A node of the atlas: the samples of one size ratio, fines content, density and flow, which differ in their seed
// alone.

#include "suffuse/atlas/row.hpp"

namespace suffuse::atlas {

struct Value {
    double mean = 0;
    std::optional<double> deviation; ///< standard deviation of single samples; none of one sample
    bool is_at_most = false;         ///< an upper bound, as that of one sample at least is
};

/// Gradients are over i_c, so that soils of other porosities can be compared; none where a sample did not reach it.
struct Node {
    double size_ratio = 0;    ///< [-]
    double fines_content = 0; ///< [-]
    double porosity = 0;      ///< [-]
    Value alpha;              ///< [-]
    std::optional<Value> moves_1, moves_10;
    std::vector<Row> rows; ///< one a seed
};

/// In order of size ratio, then of fines content.
std::vector<Node> gather_nodes(const std::vector<Row>& rows, Density density, Flow flow);

/// A node and its share in what is interpolated.
struct WeightedNode {
    const Node* node = nullptr;
    double weight = 0;
};

/// Between nodes: porosity and alpha linear, gradients linear in their logarithm, as they span decades. An upper bound
/// of one node makes the result one.
Node blend(const std::vector<WeightedNode>& nodes);

} // namespace suffuse::atlas
