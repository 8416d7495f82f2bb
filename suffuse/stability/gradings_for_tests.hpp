#pragma once
// Gradings whose numbers are known in closed form. [PHYSICS H4]

#include "suffuse/grains/soil.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace suffuse::stability::testing {

/// F = (d/dmax)^m down to 4^-12 of the largest size, 0 % below half of that. Points where criteria look, at steps of
/// two in size, and at all sizes four times as large or small: so that F(4d) is met as exactly as F(d).
inline grains::Grading power_law(double m, double largest = 10e-3) {
    std::vector<double> starts{1, 0.5}, sizes;
    for (const double share : {0.05, 0.15, 0.20, 0.30, 0.60, 0.90}) {
        starts.push_back(std::pow(share, 1 / m));
    }
    for (const double start : starts) {
        for (int k = -12; k <= 12; ++k) {
            const double size = start * std::pow(4.0, k);
            if (size <= 1 && size >= std::pow(4.0, -12)) {
                sizes.push_back(size * largest);
            }
        }
    }
    std::ranges::sort(sizes);
    sizes.erase(
        std::unique(sizes.begin(), sizes.end(), [](double a, double b) { return b < a * (1 + 1e-9); }), sizes.end()
    );
    grains::Grading grading{{sizes.front() / 2}, {0}, "power law"};
    for (const double d : sizes) {
        grading.diameter.push_back(d);
        grading.passing.push_back(std::pow(d / largest, m));
    }
    grading.passing.back() = 1;
    return grading;
}

/// Two boxes, uniform in log d: fines 0.15 to 0.30 mm, coarse 1 to 2 mm; the gap ratio is 10/3.
inline grains::Grading two_boxes(double fines_content) {
    return {{0.15e-3, 0.30e-3, 1e-3, 2e-3}, {0, fines_content, fines_content, 1}, "two boxes"};
}

/// Uniform in log d.
inline grains::Grading box(double smallest, double largest) {
    return {{smallest, largest}, {0, 1}, "box"};
}

} // namespace suffuse::stability::testing
