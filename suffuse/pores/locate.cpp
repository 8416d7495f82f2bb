#include "suffuse/pores/locate.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/pores/triangulation_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::pores {
namespace {

constexpr double tetrahedra_a_bin = 4;

/// How far inside the tetrahedron `x` is: its least barycentric coordinate, negative outside.
double depth(const std::array<Vec3, 4>& c, const Vec3& x) {
    const double whole = tetrahedron_volume(c[0], c[1], c[2], c[3]);
    if (!(whole > 0)) {
        return -std::numeric_limits<double>::infinity();
    }
    return std::min(
               {tetrahedron_volume(x, c[1], c[2], c[3]), tetrahedron_volume(c[0], x, c[2], c[3]),
                tetrahedron_volume(c[0], c[1], x, c[3]), tetrahedron_volume(c[0], c[1], c[2], x)}
           ) /
           whole;
}

} // namespace

/// Calls visit(bin, image) for every bin that the pore's bounding box, in cell coordinates, reaches into.
template <class Visit>
void PoreLocator::visit_bins(std::uint32_t pore, Visit&& visit) const {
    Vec3 low, high;
    for (int a = 0; a < 3; ++a) {
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (const Vec3& x : corner_[pore]) {
            const double s = (inverse_h_ * x)[a];
            least = std::min(least, s), most = std::max(most, s);
        }
        const double rounding = 1e-12 * (1 + std::abs(least) + std::abs(most));
        low[a] = least - rounding, high[a] = most + rounding;
    }
    bins_.for_each(low, high, [&](std::size_t bin, const cell::Image& period) {
        visit(bin, -period); // the bin at home holds the image of the tetrahedron that reaches there
    });
}

PoreLocator::PoreLocator(const PoreNetwork& network, std::span<const Vec3> position)
    : h_(network.h), inverse_h_(inverse(network.h)), corner_(network.pores.size()) {
    for (std::size_t p = 0; p < corner_.size(); ++p) {
        for (std::size_t k = 0; k < 4; ++k) {
            corner_[p][k] = position[network.pores.grain[p][k]] + shift(h_, network.pores.grain_image[p][k]);
        }
    }
    const double wanted = std::max(1.0, static_cast<double>(corner_.size()) / tetrahedra_a_bin);
    const Vec3 width = cell::widths(h_);
    const double side = std::cbrt(width.x * width.y * width.z / wanted);
    for (std::size_t a = 0; a < 3; ++a) {
        bins_.along[a] = std::max(1, static_cast<std::int32_t>(width[static_cast<int>(a)] / side));
    }
    first_.assign(bins_.count() + 1, 0);
    for (std::uint32_t p = 0; p < corner_.size(); ++p) {
        visit_bins(p, [&](std::size_t b, const cell::Image&) { ++first_[b + 1]; });
    }
    for (std::size_t b = 0; b + 1 < first_.size(); ++b) {
        first_[b + 1] += first_[b];
    }
    entries_.resize(first_.back());
    std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
    for (std::uint32_t p = 0; p < corner_.size(); ++p) {
        visit_bins(p, [&](std::size_t b, const cell::Image& image) { entries_[fill[b]++] = {p, image}; });
    }
}

PoreLocator::Place PoreLocator::find(const Vec3& point) const {
    const cell::Image period = cell::period_of(inverse_h_, point);
    const Vec3 home = point - cell::shift(h_, period);
    const std::size_t b = bins_.bin_of(inverse_h_ * home);
    const Entry* best = nullptr;
    double deepest = -std::numeric_limits<double>::infinity();
    for (std::uint32_t e = first_[b]; e < first_[b + 1]; ++e) {
        const double d = depth(corner_[entries_[e].pore], home - cell::shift(h_, entries_[e].image));
        if (d > deepest) {
            deepest = d, best = &entries_[e];
        }
    }
    expects(best != nullptr, "the tetrahedra of a network fill the cell and the point is finite");
    return {best->pore, best->image + period};
}

} // namespace suffuse::pores
