#pragma once
// A rectangular grid of nodes, some of which may be missing: which nodes surround a place, and which nodes their
// neighbors can stand in for. It never extrapolates.

#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace suffuse::atlas {

/// Of sizes and shares, relative: they are given with two or three digits, which move a place by that much; and a place
/// that is farther outside still differs in the three digits that are printed.
inline constexpr double read_error = 0.01;

struct Place {
    double x = 0, y = 0; ///< above 0
};

/// A node by its number, and its share in what is interpolated.
struct Corner {
    std::size_t node = 0;
    double weight = 0;
    bool counts =
        true; ///< more than reading errors could account for: the node's bounds and samples are those of a place
};

/// A node that has a neighbor on either side of it along a line of the grid.
struct LeftOut {
    std::size_t node = 0;
    std::vector<Corner> neighbors;
};

class Grid {
public:
    explicit Grid(const std::vector<Place>& nodes);

    /// Of the cell, of the line or the one node that a place is on; nothing where one of them is missing.
    /// @param error by how much reading errors move the place
    [[nodiscard]] std::vector<Corner> corners(const Place& at, const Place& error) const;

    /// @pre some nodes
    [[nodiscard]] double nearest_x(double x) const;

    /// Along both directions.
    [[nodiscard]] std::vector<LeftOut> left_out() const;

private:
    std::set<double> xs_, ys_;
    std::map<std::pair<double, double>, std::size_t> nodes_;
};

} // namespace suffuse::atlas
