#pragma once
// Which part of a periodic cell grains fill, as grains come and go: spheres in the bins that they reach into.

#include "suffuse/base/vec3.hpp"
#include "suffuse/cell/bins.hpp"
#include "suffuse/cell/cell.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace suffuse::erosion {

class FilledSpace {
public:
    /// @param bin about the diameter of the spheres in question [m]; wider bins are taken where those would be many
    /// more than the `grains` that may fill them
    FilledSpace(const Mat3& h, double bin, std::size_t grains);

    /// Positions need not lie inside the cell.
    void fill(const Vec3& position, double radius, std::uint32_t grain);
    void clear(const Vec3& position, double radius, std::uint32_t grain);

    /// Whether a sphere here overlaps no grain but `own`, by more than rounding.
    [[nodiscard]] bool is_free(const Vec3& position, double radius, std::uint32_t own) const;

private:
    struct Sphere {
        Vec3 center; ///< the image that reaches into the bin where it lies at home [m]
        double radius = 0;
        std::uint32_t grain = 0;
    };

    /// Around a sphere, in fractions of the cell vectors [-].
    struct Box {
        Vec3 low, high;
    };

    [[nodiscard]] Box box_around(const Vec3& position, double radius) const;

    Mat3 h_, inverse_h_;
    Vec3 width_; ///< of the cell [m]
    cell::Bins bins_;
    std::vector<std::vector<Sphere>> spheres_; ///< by bin
};

} // namespace suffuse::erosion
