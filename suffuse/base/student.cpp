#include "suffuse/base/student.hpp"

#include "suffuse/base/constants.hpp"

#include <cmath>
#include <limits>

namespace suffuse {

double student_within(double t, std::size_t freedom) {
    const double angle = std::atan(t / std::sqrt(static_cast<double>(freedom)));
    const double c2 = std::cos(angle) * std::cos(angle);
    const bool is_odd = freedom % 2 == 1;
    double term = is_odd ? std::cos(angle) : 1, sum = freedom > 1 ? term : 0;
    for (std::size_t k = is_odd ? 3 : 2; k + 1 < freedom; k += 2) { // from the power of the cosine before
        term *= c2 * static_cast<double>(k - 1) / static_cast<double>(k);
        sum += term;
    }
    return is_odd ? 2 / pi * (angle + std::sin(angle) * sum) : std::sin(angle) * sum;
}

double student_90(std::size_t freedom) {
    constexpr double confidence = 0.9;
    double low = 0, high = 10; // one degree of freedom: 6.3
    constexpr int halvings = 60;
    for (int k = 0; k < halvings; ++k) {
        const double middle = 0.5 * (low + high);
        (student_within(middle, freedom) < confidence ? low : high) = middle;
    }
    return high;
}

double next_sample_90(std::size_t samples) {
    return samples < 2 ? std::numeric_limits<double>::infinity()
                       : student_90(samples - 1) * std::sqrt(1 + 1 / static_cast<double>(samples));
}

} // namespace suffuse
