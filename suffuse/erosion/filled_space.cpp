#include "suffuse/erosion/filled_space.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::erosion {
namespace {

constexpr double rounding = 1e-9; ///< of the radius: grains that touch do not overlap
constexpr std::int32_t most_bins_an_axis = 256;
constexpr double most_bins_a_grain = 4;

} // namespace

FilledSpace::FilledSpace(const Mat3& h, double bin, std::size_t grains)
    : h_(h), inverse_h_(inverse(h)), width_(cell::widths(h)) {
    // A coarse grain stands in every bin that it fills: of bins as small as a fine, that are (D/d)^3.
    const double most = most_bins_a_grain * static_cast<double>(std::max<std::size_t>(1, grains));
    bin = std::max(bin, std::cbrt(std::abs(determinant(h)) / most));
    for (std::size_t a = 0; a < 3; ++a) {
        const double wanted = width_[static_cast<int>(a)] / bin;
        bins_.along[a] = std::clamp(static_cast<std::int32_t>(wanted), 1, most_bins_an_axis);
    }
    spheres_.resize(bins_.count());
}

FilledSpace::Box FilledSpace::box_around(const Vec3& position, double radius) const {
    const Vec3 s = inverse_h_ * position, reach{radius / width_.x, radius / width_.y, radius / width_.z};
    return {s - reach, s + reach};
}

void FilledSpace::fill(const Vec3& position, double radius, std::uint32_t grain) {
    const auto [low, high] = box_around(position, radius);
    bins_.for_each(low, high, [&](std::size_t bin, const cell::Image& period) {
        spheres_[bin].push_back({position - cell::shift(h_, period), radius, grain});
    });
}

void FilledSpace::clear(const Vec3& position, double radius, std::uint32_t grain) {
    const auto [low, high] = box_around(position, radius);
    bins_.for_each(low, high, [&](std::size_t bin, const cell::Image&) {
        std::erase_if(spheres_[bin], [&](const Sphere& sphere) { return sphere.grain == grain; });
    });
}

bool FilledSpace::is_free(const Vec3& position, double radius, std::uint32_t own) const {
    const auto [low, high] = box_around(position, radius);
    return !bins_.any_of(low, high, [&](std::size_t bin, const cell::Image& period) {
        const Vec3 center = position - cell::shift(h_, period);
        return std::any_of(spheres_[bin].begin(), spheres_[bin].end(), [&](const Sphere& other) {
            const double overlap = radius + other.radius - norm(other.center - center);
            return other.grain != own && overlap > rounding * std::min(radius, other.radius);
        });
    });
}

} // namespace suffuse::erosion
