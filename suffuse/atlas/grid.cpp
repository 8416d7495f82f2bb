#include "suffuse/atlas/grid.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace suffuse::atlas {
namespace {

constexpr double rounding = 1e-6; // relative, of sizes and shares that were computed

struct WeightedLine {
    double at = 0, weight = 0;
    double doubt = 0; ///< by how much a reading error changes the weight, relative
};

/// The line of the grid that a coordinate is on, or the two that it is between; nothing outside.
std::vector<WeightedLine> lines_around(const std::set<double>& lines, double at, double error) {
    const auto after = lines.lower_bound(at * (1 - rounding));
    if (after == lines.end()) {
        return {};
    }
    if (*after <= at * (1 + rounding)) {
        return {{*after, 1}};
    }
    if (after == lines.begin()) {
        return {};
    }
    const double low = *std::prev(after), high = *after, share = (at - low) / (high - low);
    const double change = error / (high - low);
    return {{low, 1 - share, change / (1 - share)}, {high, share, change / share}};
}

/// Nodes by their place along a line of the grid.
using Line = std::map<double, std::size_t>;

void leave_out_each(const Line& line, std::vector<LeftOut>& found) {
    if (line.size() < 3) {
        return;
    }
    for (auto middle = std::next(line.begin()); std::next(middle) != line.end(); ++middle) {
        const auto before = std::prev(middle), after = std::next(middle);
        const double share = (middle->first - before->first) / (after->first - before->first);
        found.push_back({middle->second, {{before->second, 1 - share}, {after->second, share}}});
    }
}

} // namespace

Grid::Grid(const std::vector<Place>& nodes) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        xs_.insert(nodes[k].x);
        ys_.insert(nodes[k].y);
        nodes_[{nodes[k].x, nodes[k].y}] = k;
    }
}

std::vector<Corner> Grid::corners(const Place& at, const Place& error) const {
    std::vector<Corner> found;
    for (const WeightedLine& first : lines_around(xs_, at.x, error.x)) {
        for (const WeightedLine& second : lines_around(ys_, at.y, error.y)) {
            const auto node = nodes_.find({first.at, second.at});
            if (node == nodes_.end()) {
                return {};
            }
            found.push_back({node->second, first.weight * second.weight, first.doubt + second.doubt < 1});
        }
    }
    if (!found.empty()) {
        std::ranges::max_element(found, {}, &Corner::weight)->counts = true;
    }
    return found;
}

double Grid::nearest_x(double x) const {
    return *std::ranges::min_element(xs_, {}, [&](double line) { return std::abs(line - x); });
}

std::vector<LeftOut> Grid::left_out() const {
    std::map<double, Line> along_y, along_x;
    for (const auto& [place, node] : nodes_) {
        along_y[place.first][place.second] = node;
        along_x[place.second][place.first] = node;
    }
    std::vector<LeftOut> found;
    for (const auto* const lines : {&along_y, &along_x}) {
        for (const auto& [at, line] : *lines) {
            leave_out_each(line, found);
        }
    }
    return found;
}

} // namespace suffuse::atlas
