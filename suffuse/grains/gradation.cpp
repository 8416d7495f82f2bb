#include "suffuse/grains/gradation.hpp"

#include "suffuse/base/error.hpp"

#include <algorithm>
#include <numeric>

namespace suffuse::grains {
namespace {

Gradation gradation_of(const Grains& grains, std::vector<std::uint32_t> rows) {
    std::sort(rows.begin(), rows.end(), [&](auto a, auto b) { return grains.radius[a] < grains.radius[b]; });
    Gradation gradation;
    // All grains are of one density; their mass may be one that they are lent (dem/lent_inertia.hpp).
    double solid = 0;
    for (const std::uint32_t g : rows) {
        solid += sphere_volume(grains.radius[g]);
        const double diameter = 2 * grains.radius[g];
        if (gradation.diameter.empty() || diameter > gradation.diameter.back()) {
            gradation.diameter.push_back(diameter);
            gradation.passing.push_back(solid);
        } else {
            gradation.passing.back() = solid;
        }
    }
    for (double& share : gradation.passing) {
        share /= solid;
    }
    return gradation;
}

} // namespace

Gradation measure_gradation(const Grains& grains) {
    std::vector<std::uint32_t> rows(grains.size());
    std::iota(rows.begin(), rows.end(), 0U);
    return gradation_of(grains, std::move(rows));
}

Gradation measure_gradation_of(const Grains& grains, bool fine) {
    std::vector<std::uint32_t> rows;
    for (std::uint32_t g = 0; g < grains.size(); ++g) {
        if ((grains.fine[g] != 0) == fine) {
            rows.push_back(g);
        }
    }
    return gradation_of(grains, std::move(rows));
}

double passing(const Gradation& gradation, double diameter) {
    const auto above = std::upper_bound(gradation.diameter.begin(), gradation.diameter.end(), diameter);
    const auto count = above - gradation.diameter.begin();
    return count > 0 ? gradation.passing[static_cast<std::size_t>(count - 1)] : 0;
}

double size_at(const Gradation& gradation, double fraction) {
    if (gradation.diameter.empty()) {
        return 0;
    }
    // A grain's share is a sum of rounded numbers: a fraction met to 1e-12 counts as met.
    const auto first = std::lower_bound(gradation.passing.begin(), gradation.passing.end(), fraction - 1e-12);
    const auto row =
        std::min(first - gradation.passing.begin(), static_cast<std::ptrdiff_t>(gradation.diameter.size()) - 1);
    return gradation.diameter[static_cast<std::size_t>(row)];
}

Grading curve_of_steps(const Gradation& gradation) {
    expects(!gradation.diameter.empty(), "a curve has grains");
    constexpr double width = 1e-6; // of a size: far below what a criterion distinguishes, far above rounding
    Grading curve;
    double finer = 0;
    for (std::size_t k = 0; k < gradation.diameter.size(); ++k) {
        const double size = gradation.diameter[k], below = size * (1 - width);
        if (curve.diameter.empty() || below > curve.diameter.back()) {
            curve.diameter.insert(curve.diameter.end(), {below, size});
            curve.passing.insert(curve.passing.end(), {finer, 0});
        }
        finer = gradation.passing[k];
        curve.passing.back() = finer;
    }
    curve.passing.back() = 1; // whatever the sum was rounded to
    return curve;
}

double median_diameter(const Grains& grains) {
    return size_at(measure_gradation(grains), 0.5);
}

} // namespace suffuse::grains
