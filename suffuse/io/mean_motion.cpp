#include "suffuse/io/mean_motion.hpp"

#include <cmath>

namespace suffuse::io {

std::optional<Mat3> find_velocity_gradient(const grains::Grains& grains) {
    constexpr std::size_t least_grains = 10;
    constexpr double least_share = 0.5, flat = 1e-9;
    const std::size_t n = grains.size();
    if (n < least_grains) {
        return std::nullopt;
    }
    Vec3 mean_x{}, mean_v{};
    for (std::size_t g = 0; g < n; ++g) {
        mean_x = mean_x + grains.position[g];
        mean_v = mean_v + grains.velocity[g];
    }
    mean_x = (1.0 / static_cast<double>(n)) * mean_x;
    mean_v = (1.0 / static_cast<double>(n)) * mean_v;
    Mat3 spread{}, moved{}; // sums of x (x) x and of v (x) x about the means
    double scatter = 0;
    for (std::size_t g = 0; g < n; ++g) {
        const Vec3 x = grains.position[g] - mean_x, v = grains.velocity[g] - mean_v;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                spread(i, j) += x[i] * x[j];
                moved(i, j) += v[i] * x[j];
            }
        }
        scatter += norm2(v);
    }
    const double size = (spread(0, 0) + spread(1, 1) + spread(2, 2)) / 3;
    if (!(scatter > 0) || !std::isfinite(scatter) || !(determinant(spread) > flat * size * size * size)) {
        return std::nullopt;
    }
    const Mat3 gradient = moved * inverse(spread);
    double left = 0;
    for (std::size_t g = 0; g < n; ++g) {
        left += norm2(grains.velocity[g] - mean_v - gradient * (grains.position[g] - mean_x));
    }
    return left <= (1 - least_share) * scatter ? std::optional(gradient) : std::nullopt;
}

} // namespace suffuse::io
