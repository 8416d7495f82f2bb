#pragma once
// Which pore a point lies in: the tetrahedra of a network sorted into bins over the periodic cell.

#include "suffuse/base/vec3.hpp"
#include "suffuse/cell/bins.hpp"
#include "suffuse/pores/network.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace suffuse::pores {

class PoreLocator {
public:
    /// `position`: of the grains that the network was built from. Both are used only here.
    PoreLocator(const PoreNetwork& network, std::span<const Vec3> position);

    struct Place {
        std::uint32_t pore = 0;
        cell::Image image; ///< the point lies in the pore's tetrahedron moved by these periods
    };

    /// The pore whose tetrahedron holds `point` [m]; on a common facet, one of the two.
    [[nodiscard]] Place find(const Vec3& point) const;

private:
    /// A tetrahedron, or an image of it, that reaches into a bin.
    struct Entry {
        std::uint32_t pore = 0;
        cell::Image image;
    };

    template <class Visit>
    void visit_bins(std::uint32_t pore, Visit&& visit) const;

    Mat3 h_, inverse_h_;
    cell::Bins bins_;
    std::vector<std::array<Vec3, 4>> corner_; ///< [m]
    std::vector<std::uint32_t> first_;        ///< entries of bin b are [first_[b], first_[b + 1])
    std::vector<Entry> entries_;
};

} // namespace suffuse::pores
