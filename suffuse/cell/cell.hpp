#pragma once
// The periodic cell: a parallelepiped of any shape that deforms with a velocity gradient. Grain positions are never
// wrapped; a contact or a pore that reaches into a neighboring period carries an Image instead.

#include "suffuse/base/vec3.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>

namespace suffuse::cell {

/// Whole periods along the three cell vectors, in six bytes: tables of pairs, pores and throats hold millions of them.
struct Image {
    std::int16_t a = 0, b = 0, c = 0;

    constexpr Image() = default;

    /// @pre at most `largest_period` each way
    constexpr Image(std::integral auto along_a, std::integral auto along_b, std::integral auto along_c)
        : a(static_cast<std::int16_t>(along_a)), b(static_cast<std::int16_t>(along_b)),
          c(static_cast<std::int16_t>(along_c)) {}

    constexpr auto operator<=>(const Image&) const = default;
};

/// Positions further than this from the home period have no image: sums of three of them still fit.
inline constexpr std::int32_t largest_period = 10'000;

constexpr Image operator+(const Image& p, const Image& q) {
    return {p.a + q.a, p.b + q.b, p.c + q.c};
}

constexpr Image operator-(const Image& p, const Image& q) {
    return {p.a - q.a, p.b - q.b, p.c - q.c};
}

constexpr Image operator-(const Image& p) {
    return Image{} - p;
}

struct Cell {
    Mat3 h = identity();         ///< columns are the cell vectors [m]
    Mat3 velocity_gradient = {}; ///< dv/dx, extension positive [1/s]
};

constexpr double volume(const Cell& cell) {
    return determinant(cell.h);
}

/// Displacement between a point and its image [m].
constexpr Vec3 shift(const Mat3& h, const Image& image) {
    return h * Vec3{static_cast<double>(image.a), static_cast<double>(image.b), static_cast<double>(image.c)};
}

/// Distance between opposite faces of the cell, along each of its three directions [m].
inline Vec3 widths(const Mat3& h) {
    const double v = std::abs(determinant(h));
    const Vec3 a = h.column(0), b = h.column(1), c = h.column(2);
    return {v / norm(cross(b, c)), v / norm(cross(c, a)), v / norm(cross(a, b))};
}

/// Whether `position` lies within `largest_period`; not so if it is not finite.
inline bool has_period(const Mat3& inverse_h, const Vec3& position) {
    const Vec3 s = inverse_h * position;
    return std::max({std::abs(s.x), std::abs(s.y), std::abs(s.z)}) < largest_period;
}

/// The period that `position` lies in; subtracting its shift brings the point home into the cell.
/// @pre has_period
inline Image period_of(const Mat3& inverse_h, const Vec3& position) {
    const Vec3 s = inverse_h * position;
    const auto whole = [](double fraction) { return static_cast<std::int32_t>(std::floor(fraction)); };
    return {whole(s.x), whole(s.y), whole(s.z)};
}

/// `position` moved by whole periods into the cell.
inline Vec3 wrapped(const Mat3& h, const Mat3& inverse_h, const Vec3& position) {
    return position - shift(h, period_of(inverse_h, position));
}

} // namespace suffuse::cell
