#include "suffuse/erosion/filled_space.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::erosion {
namespace {

constexpr double rounding = 1e-9; ///< of the radius: grains that touch do not overlap
constexpr std::int32_t most_bins_an_axis = 256;
constexpr double most_bins_a_grain = 4;

std::int32_t floor_of(double x) {
    return static_cast<std::int32_t>(std::floor(x));
}

/// Periods by which bin `i` of `n` lies outside the cell.
std::int32_t periods(std::int32_t i, std::int32_t n) {
    return i >= 0 ? i / n : -((n - 1 - i) / n);
}

} // namespace

FilledSpace::FilledSpace(const Mat3& h, double bin, std::size_t grains)
    : h_(h), inverse_h_(inverse(h)), width_(cell::widths(h)) {
    // A coarse grain stands in every bin that it fills: of bins as small as a fine, that are (D/d)^3.
    const double most = most_bins_a_grain * static_cast<double>(std::max<std::size_t>(1, grains));
    bin = std::max(bin, std::cbrt(std::abs(determinant(h)) / most));
    std::size_t all = 1;
    for (std::size_t a = 0; a < 3; ++a) {
        bins_[a] = std::clamp(floor_of(width_[static_cast<int>(a)] / bin), 1, most_bins_an_axis);
        all *= static_cast<std::size_t>(bins_[a]);
    }
    spheres_.resize(all);
}

/// Calls visit(bin, center) for each bin that the sphere's bounding box reaches into, with the center moved by as many
/// periods as bring that bin home.
template <class Visit>
void FilledSpace::visit_bins(const Vec3& position, double radius, Visit&& visit) const {
    const Vec3 s = inverse_h_ * position;
    std::array<std::int32_t, 3> low{}, high{};
    for (std::size_t a = 0; a < 3; ++a) {
        const double reach = radius / width_[static_cast<int>(a)];
        low[a] = floor_of((s[static_cast<int>(a)] - reach) * bins_[a]);
        high[a] = floor_of((s[static_cast<int>(a)] + reach) * bins_[a]);
    }
    for (std::int32_t i = low[0]; i <= high[0]; ++i) {
        for (std::int32_t j = low[1]; j <= high[1]; ++j) {
            for (std::int32_t k = low[2]; k <= high[2]; ++k) {
                const std::int32_t u = periods(i, bins_[0]), v = periods(j, bins_[1]), w = periods(k, bins_[2]);
                const std::int32_t row = (i - u * bins_[0]) * bins_[1] + j - v * bins_[1];
                const std::int32_t bin = row * bins_[2] + k - w * bins_[2];
                visit(static_cast<std::size_t>(bin), position - cell::shift(h_, cell::Image(u, v, w)));
            }
        }
    }
}

void FilledSpace::fill(const Vec3& position, double radius, std::uint32_t grain) {
    visit_bins(position, radius, [&](std::size_t bin, const Vec3& center) {
        spheres_[bin].push_back({center, radius, grain});
    });
}

void FilledSpace::clear(const Vec3& position, double radius, std::uint32_t grain) {
    visit_bins(position, radius, [&](std::size_t bin, const Vec3&) {
        std::erase_if(spheres_[bin], [&](const Sphere& sphere) { return sphere.grain == grain; });
    });
}

bool FilledSpace::is_free(const Vec3& position, double radius, std::uint32_t own) const {
    bool is_free = true;
    visit_bins(position, radius, [&](std::size_t bin, const Vec3& center) {
        is_free = is_free && std::none_of(spheres_[bin].begin(), spheres_[bin].end(), [&](const Sphere& other) {
                      const double overlap = radius + other.radius - norm(other.center - center);
                      return other.grain != own && overlap > rounding * std::min(radius, other.radius);
                  });
    });
    return is_free;
}

} // namespace suffuse::erosion
