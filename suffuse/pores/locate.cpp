#include "suffuse/pores/locate.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/pores/triangulation_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::pores {
namespace {

constexpr double tetrahedra_a_bin = 4;

std::int32_t floor_of(double x) {
    return static_cast<std::int32_t>(std::floor(x));
}

/// Remainder that is not negative.
std::int32_t wrapped(std::int32_t i, std::int32_t n) {
    return ((i % n) + n) % n;
}

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

std::size_t PoreLocator::bin(std::int32_t i, std::int32_t j, std::int32_t k) const {
    return static_cast<std::size_t>((i * bins_[1] + j) * bins_[2] + k);
}

/// Calls visit(bin, image) for every bin that the pore's bounding box, in cell coordinates, reaches into.
template <class Visit>
void PoreLocator::visit_bins(std::uint32_t pore, Visit&& visit) const {
    std::array<std::int32_t, 3> low{}, high{};
    for (std::size_t a = 0; a < 3; ++a) {
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (const Vec3& x : corner_[pore]) {
            const double s = (inverse_h_ * x)[static_cast<int>(a)];
            least = std::min(least, s), most = std::max(most, s);
        }
        const double rounding = 1e-12 * (1 + std::abs(least) + std::abs(most));
        low[a] = floor_of((least - rounding) * bins_[a]);
        high[a] = floor_of((most + rounding) * bins_[a]);
    }
    for (std::int32_t i = low[0]; i <= high[0]; ++i) {
        for (std::int32_t j = low[1]; j <= high[1]; ++j) {
            for (std::int32_t k = low[2]; k <= high[2]; ++k) {
                const std::int32_t u = wrapped(i, bins_[0]), v = wrapped(j, bins_[1]), w = wrapped(k, bins_[2]);
                // The bin at home holds the image of the tetrahedron that reaches there.
                visit(bin(u, v, w), cell::Image{(u - i) / bins_[0], (v - j) / bins_[1], (w - k) / bins_[2]});
            }
        }
    }
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
        bins_[a] = std::max(1, static_cast<std::int32_t>(width[static_cast<int>(a)] / side));
    }
    first_.assign(bin(bins_[0] - 1, bins_[1] - 1, bins_[2] - 1) + 2, 0);
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
    const Vec3 s = inverse_h_ * home;
    const auto cut = [&](int a) {
        return std::clamp(
            floor_of(s[a] * bins_[static_cast<std::size_t>(a)]), 0, bins_[static_cast<std::size_t>(a)] - 1
        );
    };
    const std::size_t b = bin(cut(0), cut(1), cut(2));
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

PoreLocator::Place locate_pore(const PoreNetwork& network, std::span<const Vec3> position, const Vec3& point) {
    return PoreLocator(network, position).find(point);
}

} // namespace suffuse::pores
