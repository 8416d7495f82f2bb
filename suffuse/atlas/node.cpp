#include "suffuse/atlas/node.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace suffuse::atlas {
namespace {

/// Ramps know a gradient to 0.01; below a tenth of that its logarithm would be noise, or none.
constexpr double least_gradient = 1e-3;

std::optional<Value> gradient_of(const std::vector<Row>& rows, Threshold Row::*threshold) {
    std::vector<double> samples;
    bool is_at_most = false;
    for (const Row& row : rows) {
        const Threshold& found = row.*threshold;
        if (!found.gradient) {
            return std::nullopt;
        }
        samples.push_back(*found.gradient / heave_gradient(row));
        is_at_most = is_at_most || found.is_at_most;
    }
    Value value = over_seeds(samples);
    value.is_at_most = is_at_most;
    return value;
}

Floor floor_of(const std::vector<Row>& rows, Threshold Row::*threshold) {
    Floor floor{0, false};
    for (const Row& row : rows) {
        const Threshold& found = row.*threshold;
        floor.is_reached = floor.is_reached || found.gradient;
        if (found.is_at_most) {
            floor.gradient.reset();
        } else if (floor.gradient) {
            const double over_heave = found.gradient.value_or(last_gradient(row)) / heave_gradient(row);
            *floor.gradient += over_heave / static_cast<double>(rows.size());
        }
    }
    return floor;
}

Node node_of(std::vector<Row> rows) {
    std::vector<double> porosities, alphas;
    for (const Row& row : rows) {
        porosities.push_back(row.porosity);
        alphas.push_back(row.alpha);
    }
    Node node;
    node.size_ratio = rows.front().size_ratio;
    node.fines_content = rows.front().fines_content;
    node.porosity = over_seeds(porosities).mean;
    node.alpha = over_seeds(alphas);
    node.moves_1 = gradient_of(rows, &Row::moves_1);
    node.moves_10 = gradient_of(rows, &Row::moves_10);
    node.least_1 = floor_of(rows, &Row::moves_1);
    node.least_10 = floor_of(rows, &Row::moves_10);
    node.rows = std::move(rows);
    return node;
}

Value blend_alpha(const std::vector<WeightedNode>& nodes) {
    Value value;
    value.deviation = 0;
    for (const auto& [node, weight, counts] : nodes) {
        value.mean += weight * node->alpha.mean;
        add_weighted(value.deviation, node->alpha.deviation, weight, counts);
    }
    return value;
}

std::optional<Value> blend_gradient(const std::vector<WeightedNode>& nodes, std::optional<Value> Node::*threshold) {
    double logarithm = 0, left_out = 0;
    std::optional<double> scatter = 0; // relative
    bool is_at_most = false;
    for (const auto& [node, weight, counts] : nodes) {
        const std::optional<Value>& found = node->*threshold;
        if (!found && counts) {
            return std::nullopt;
        }
        if (!found) {
            left_out += weight;
            continue;
        }
        const double gradient = std::max(found->mean, least_gradient);
        logarithm += weight * std::log(gradient);
        add_weighted(scatter, found->deviation, weight / gradient, counts);
        is_at_most = is_at_most || (counts && found->is_at_most);
    }
    const double mean = std::exp(logarithm / (1 - left_out));
    return Value{mean, scatter ? std::optional(*scatter * mean) : std::nullopt, is_at_most};
}

Floor blend_floor(const std::vector<WeightedNode>& nodes, Floor Node::*threshold) {
    double logarithm = 0, left_out = 0;
    Floor blended;
    bool is_known = true;
    for (const auto& [node, weight, counts] : nodes) {
        const Floor& floor = node->*threshold;
        blended.is_reached = blended.is_reached || (counts && floor.is_reached);
        if (floor.gradient) {
            logarithm += weight * std::log(std::max(*floor.gradient, least_gradient));
        } else {
            left_out += weight;
            is_known = is_known && !counts;
        }
    }
    if (is_known) {
        blended.gradient = std::exp(logarithm / (1 - left_out));
    }
    return blended;
}

} // namespace

std::vector<Node> gather_nodes(const std::vector<Row>& rows, Density density, Flow flow) {
    std::map<std::pair<double, double>, std::vector<Row>> by_place;
    for (const Row& row : rows) {
        if (row.density == density && row.flow == flow) {
            by_place[{row.size_ratio, row.fines_content}].push_back(row);
        }
    }
    std::vector<Node> nodes;
    nodes.reserve(by_place.size());
    for (auto& [place, samples] : by_place) {
        nodes.push_back(node_of(std::move(samples)));
    }
    return nodes;
}

Grid grid_of(const std::vector<Node>& nodes) {
    std::vector<Place> places;
    places.reserve(nodes.size());
    for (const Node& node : nodes) {
        places.push_back({std::log(node.size_ratio), node.fines_content});
    }
    return Grid(places);
}

std::vector<WeightedNode> weighted(const std::vector<Node>& nodes, const std::vector<Corner>& corners) {
    std::vector<WeightedNode> found;
    found.reserve(corners.size());
    for (const Corner& corner : corners) {
        found.push_back({&nodes[corner.node], corner.weight, corner.counts});
    }
    return found;
}

Node blend(const std::vector<WeightedNode>& nodes) {
    Node blended;
    double ratio = 0;
    for (const auto& [node, weight, counts] : nodes) {
        ratio += weight * std::log(node->size_ratio);
        blended.fines_content += weight * node->fines_content;
        blended.porosity += weight * node->porosity;
        if (counts) {
            blended.rows.insert(blended.rows.end(), node->rows.begin(), node->rows.end());
        }
    }
    blended.size_ratio = std::exp(ratio);
    blended.alpha = blend_alpha(nodes);
    blended.moves_1 = blend_gradient(nodes, &Node::moves_1);
    blended.moves_10 = blend_gradient(nodes, &Node::moves_10);
    blended.least_1 = blend_floor(nodes, &Node::least_1);
    blended.least_10 = blend_floor(nodes, &Node::least_10);
    return blended;
}

} // namespace suffuse::atlas
