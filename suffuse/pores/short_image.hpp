#pragma once
// Whole periods in six bytes: the tables of pores and throats hold millions of them.

#include "suffuse/cell/cell.hpp"

#include <compare>
#include <cstdint>

namespace suffuse::pores {

struct ShortImage {
    std::int16_t a = 0, b = 0, c = 0;

    constexpr ShortImage() = default;

    constexpr explicit(false) ShortImage(const cell::Image& image)
        : a(static_cast<std::int16_t>(image.a)), b(static_cast<std::int16_t>(image.b)),
          c(static_cast<std::int16_t>(image.c)) {}

    constexpr explicit operator cell::Image() const { return {a, b, c}; }

    constexpr auto operator<=>(const ShortImage&) const = default;
};

/// Periods beyond which an image no longer fits.
inline constexpr std::int32_t largest_period = 30'000;

constexpr ShortImage operator+(const ShortImage& p, const ShortImage& q) {
    return cell::Image(p) + cell::Image(q);
}

constexpr ShortImage operator-(const ShortImage& p, const ShortImage& q) {
    return cell::Image(p) - cell::Image(q);
}

constexpr ShortImage operator-(const ShortImage& p) {
    return cell::Image{} - cell::Image(p);
}

/// Displacement between a point and its image [m].
constexpr Vec3 shift(const Mat3& h, const ShortImage& image) {
    return h * Vec3{static_cast<double>(image.a), static_cast<double>(image.b), static_cast<double>(image.c)};
}

} // namespace suffuse::pores
