#include "suffuse/atlas/look_up.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace suffuse::atlas {
namespace {

std::vector<WeightedNode> nodes_for(const std::vector<Node>& nodes, double size_ratio, double fines_content) {
    const Grid grid = grid_of(nodes);
    const double ratio = std::log(size_ratio), nearest = grid.nearest_x(ratio);
    const Place error{std::log1p(read_error), read_error * fines_content};
    std::vector<Corner> corners = grid.corners({ratio, fines_content}, error);
    if (corners.empty() && std::abs(nearest - ratio) <= std::log1p(same_ratio)) {
        corners = grid.corners({nearest, fines_content}, error);
    }
    return weighted(nodes, corners);
}

/// In steps of the atlas, about 1.4 in the size ratio and 5 % in the fines content.
double distance(const Node& node, double size_ratio, double fines_content) {
    constexpr double step_of_ratio = 0.34, step_of_content = 0.05;
    return std::hypot(
        std::log(node.size_ratio / size_ratio) / step_of_ratio, (node.fines_content - fines_content) / step_of_content
    );
}

} // namespace

int Found::seeds() const {
    std::map<std::pair<double, double>, int> samples;
    for (const Row& row : rows) {
        ++samples[{row.size_ratio, row.fines_content}];
    }
    const auto fewest = std::ranges::min_element(samples, {}, [](const auto& place) { return place.second; });
    return fewest == samples.end() ? 0 : fewest->second;
}

double Found::sifting() const {
    double most = 0;
    for (const Row& row : rows) {
        most = std::max(most, row.sifting);
    }
    return most;
}

Found look_up(const std::vector<Row>& rows, double size_ratio, double fines_content, Density density, Flow flow) {
    Found found{density, flow, {}, false, {}};
    const std::vector<Node> nodes = gather_nodes(rows, density, flow);
    if (nodes.empty()) {
        return found;
    }
    const std::vector<WeightedNode> corners = nodes_for(nodes, size_ratio, fines_content);
    if (corners.empty()) {
        found.rows = std::ranges::min_element(nodes, {}, [&](const Node& node) {
                         return distance(node, size_ratio, fines_content);
                     })->rows;
        return found;
    }
    found.node = blend(corners);
    found.rows = found.node->rows;
    found.is_interpolated = corners.size() > 1;
    return found;
}

std::vector<Density> densities_of(const std::vector<Row>& rows, Flow flow) {
    std::vector<Density> found;
    for (const Density density : {Density::Loose, Density::Medium, Density::Dense}) {
        if (std::ranges::any_of(rows, [&](const Row& row) { return row.density == density && row.flow == flow; })) {
            found.push_back(density);
        }
    }
    return found;
}

} // namespace suffuse::atlas
