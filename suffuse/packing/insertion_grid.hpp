#pragma once
// Grains added one at a time to a periodic cube, and how deep a new one would overlap those already there. One regular
// grid a size class (a factor of two each), so that fines and gravel share a cell without slowing each other down.

#include "suffuse/base/vec3.hpp"
#include "suffuse/cell/bins.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace suffuse::packing {

class InsertionGrid {
public:
    /// For grains of these radii, added in this order, largest first, to a cube of this edge [m].
    InsertionGrid(double edge, std::span<const double> radius);

    /// Adds grain `g` at a position inside the cube [m].
    void insert(std::uint32_t g, const Vec3& position);

    /// Deepest overlap of a grain of that radius with those inserted [m]; zero or less where there is none. The search
    /// ends early, with some overlap deeper than `enough`, once it has found one.
    [[nodiscard]] double deepest_overlap(const Vec3& position, double radius, double enough) const;

private:
    struct Level {
        cell::Bins bins;
        double largest_radius = 0;
        bool used = false;
        std::vector<std::int32_t> head; // first grain of each bin, -1 where it is empty
    };

    [[nodiscard]] double deepest_in(const Level& level, const Vec3& position, double radius, double enough) const;

    double edge_;
    std::span<const double> radius_;
    std::vector<Level> levels_;
    std::vector<std::uint8_t> level_of_;
    std::vector<std::int32_t> next_; // the following grain of the same bin
    std::vector<Vec3> position_;
};

} // namespace suffuse::packing
