#include "suffuse/calibration/sobol.hpp"

#include "suffuse/base/random.hpp"

#include <array>
#include <stdexcept>

namespace suffuse::calibration {
namespace {

constexpr int bits = 32;

/// A row of new-joe-kuo-6.21201: degree and inner coefficients of the primitive polynomial, first direction numbers.
struct Polynomial {
    int degree;
    std::uint32_t coefficients;
    std::array<std::uint32_t, 6> first;
};

constexpr std::array<Polynomial, most_dimensions - 1> polynomials{{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
}};

using Directions = std::array<std::uint32_t, bits>;

/// The recurrence of Bratley and Fox (1988), eq. 2 and 3; the first dimension is van der Corput's sequence.
Directions directions_of(int dimension) {
    Directions v{};
    if (dimension == 0) {
        for (int k = 0; k < bits; ++k) {
            v[k] = std::uint32_t{1} << (bits - 1 - k);
        }
        return v;
    }
    const Polynomial& p = polynomials[dimension - 1];
    for (int k = 0; k < bits; ++k) {
        if (k < p.degree) {
            v[k] = p.first[k] << (bits - 1 - k);
            continue;
        }
        v[k] = v[k - p.degree] ^ (v[k - p.degree] >> p.degree);
        for (int j = 1; j < p.degree; ++j) {
            if ((p.coefficients >> (p.degree - 1 - j) & 1U) != 0) {
                v[k] ^= v[k - j];
            }
        }
    }
    return v;
}

/// The coordinate as a binary fraction of 32 digits.
std::uint32_t digits_of(std::uint32_t index, int dimension) {
    const Directions v = directions_of(dimension);
    const std::uint32_t gray = index ^ (index >> 1);
    std::uint32_t digits = 0;
    for (int k = 0; k < bits; ++k) {
        if ((gray >> k & 1U) != 0) {
            digits ^= v[k];
        }
    }
    return digits;
}

double fraction_of(std::uint32_t digits) {
    return static_cast<double>(digits) * 0x1p-32;
}

void require_dimensions(int dimensions) {
    if (dimensions < 1 || dimensions > most_dimensions) {
        throw std::invalid_argument("Sobol's sequence is stored for 1 to 16 dimensions");
    }
}

} // namespace

Point sobol_point(std::uint32_t index, int dimensions) {
    require_dimensions(dimensions);
    Point point(dimensions);
    for (int d = 0; d < dimensions; ++d) {
        point[d] = fraction_of(digits_of(index, d));
    }
    return point;
}

std::vector<Point> design_points(std::uint32_t first, int count, int dimensions, std::uint64_t seed) {
    require_dimensions(dimensions);
    std::vector<Point> points(count, Point(dimensions));
    for (int d = 0; d < dimensions; ++d) {
        const std::uint32_t shift = RandomStream(seed, "design", d).bits();
        for (int k = 0; k < count; ++k) {
            points[k][d] = fraction_of(digits_of(first + static_cast<std::uint32_t>(k), d) ^ shift);
        }
    }
    return points;
}

} // namespace suffuse::calibration
