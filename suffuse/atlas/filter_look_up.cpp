#include "suffuse/atlas/filter_look_up.hpp"

#include "suffuse/atlas/grid.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace suffuse::atlas {
namespace {

FilterNode filter_node_of(std::vector<FilterRow> rows) {
    std::vector<double> passed;
    FilterNode node;
    node.ratio = rows.front().ratio, node.width = rows.front().width;
    node.ended = std::ranges::all_of(rows, &FilterRow::ended);
    for (const FilterRow& row : rows) {
        passed.push_back(row.passed);
        node.moving += row.moving / static_cast<double>(rows.size());
    }
    node.passed = over_seeds(passed);
    node.rows = std::move(rows);
    return node;
}

/// Those of one gradient, on their grid.
class FilterNodes {
public:
    FilterNodes(const std::vector<FilterRow>& rows, double gradient)
        : nodes_(gather(rows, gradient)), grid_(places_of(nodes_)) {}

    /// Where a base is; nodes are at the same.
    static Place place_of(double ratio, double width) { return {std::log(ratio), std::log(width)}; }

    [[nodiscard]] const std::vector<FilterNode>& all() const { return nodes_; }

    [[nodiscard]] const Grid& grid() const { return grid_; }

    [[nodiscard]] const FilterNode& nearest(const Place& place) const {
        return *std::ranges::min_element(nodes_, {}, [&](const FilterNode& node) {
            const Place at = place_of(node.ratio, node.width);
            return std::hypot(at.x - place.x, at.y - place.y);
        });
    }

    [[nodiscard]] FilterNode blend(const std::vector<Corner>& corners) const {
        FilterNode blended;
        double ratio = 0, width = 0;
        blended.ended = true;
        blended.passed.deviation = 0;
        for (const auto& [k, weight, counts] : corners) {
            const FilterNode& node = nodes_[k];
            ratio += weight * std::log(node.ratio), width += weight * std::log(node.width);
            blended.passed.mean += weight * node.passed.mean;
            add_weighted(blended.passed.deviation, node.passed.deviation, weight, counts);
            blended.moving += weight * node.moving;
            blended.ended = blended.ended && (node.ended || !counts);
            if (counts) {
                blended.rows.insert(blended.rows.end(), node.rows.begin(), node.rows.end());
            }
        }
        blended.ratio = std::exp(ratio), blended.width = std::exp(width);
        return blended;
    }

private:
    static std::vector<FilterNode> gather(const std::vector<FilterRow>& rows, double gradient) {
        std::map<std::pair<double, double>, std::vector<FilterRow>> by_place;
        for (const FilterRow& row : rows) {
            if (row.gradient == gradient) {
                by_place[{row.ratio, row.width}].push_back(row);
            }
        }
        std::vector<FilterNode> nodes;
        nodes.reserve(by_place.size());
        for (auto& [place, samples] : by_place) {
            nodes.push_back(filter_node_of(std::move(samples)));
        }
        return nodes;
    }

    static std::vector<Place> places_of(const std::vector<FilterNode>& nodes) {
        std::vector<Place> places;
        places.reserve(nodes.size());
        for (const FilterNode& node : nodes) {
            places.push_back(place_of(node.ratio, node.width));
        }
        return places;
    }

    std::vector<FilterNode> nodes_;
    Grid grid_;
};

/// The simulated ratio that equals a given one within this error; the given one where there is none.
double snapped(const std::vector<FilterRow>& rows, double FilterRow::*ratio, double given) {
    const double nearest =
        (*std::ranges::min_element(rows, {}, [&](const FilterRow& row) { return std::abs(row.*ratio - given); })).*
        ratio;
    return std::abs(given / nearest - 1) <= read_error ? nearest : given;
}

std::set<double> gradients_of(const std::vector<FilterRow>& rows) {
    std::set<double> gradients;
    for (const FilterRow& row : rows) {
        gradients.insert(row.gradient);
    }
    return gradients;
}

} // namespace

std::vector<FilterFound> look_up_filter(const std::vector<FilterRow>& rows, double ratio, double width) {
    std::vector<FilterFound> all;
    if (rows.empty()) {
        return all;
    }
    const double wide = std::max(width, std::ranges::min(rows, {}, &FilterRow::width).width);
    const Place given = FilterNodes::place_of(ratio, wide), error{std::log1p(read_error), std::log1p(read_error)};
    const Place place =
        FilterNodes::place_of(snapped(rows, &FilterRow::ratio, ratio), snapped(rows, &FilterRow::width, wide));
    for (const double gradient : gradients_of(rows)) {
        const FilterNodes nodes(rows, gradient);
        const std::vector<Corner> corners = nodes.grid().corners(place, error);
        FilterFound found{gradient, {}, corners.size() > 1, nodes.nearest(given)};
        if (!corners.empty()) {
            found.node = nodes.blend(corners);
        }
        all.push_back(std::move(found));
    }
    return all;
}

std::optional<double> error_of_filters(const std::vector<FilterRow>& rows, double gradient) {
    const FilterNodes nodes(rows, gradient);
    double squares = 0;
    const std::vector<LeftOut> left_out = nodes.grid().left_out();
    for (const auto& [node, neighbors] : left_out) {
        squares += std::pow(nodes.blend(neighbors).passed.mean - nodes.all()[node].passed.mean, 2);
    }
    return left_out.empty() ? std::nullopt : std::optional(std::sqrt(squares / static_cast<double>(left_out.size())));
}

} // namespace suffuse::atlas
