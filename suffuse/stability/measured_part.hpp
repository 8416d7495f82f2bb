#pragma once
// Sizes and shares of a grading where it was measured; its ends may be open.

#include "suffuse/grains/grading.hpp"

#include <limits>
#include <optional>

namespace suffuse::stability {

inline constexpr double sieve_200 = 0.075e-3; ///< what passes it is fines by ASTM D2487 [m]

/// The size [m] below which a share of the mass lies.
inline std::optional<double> size_within(const grains::Grading& grading, double share) {
    const bool is_measured = share >= grading.passing.front() && share <= grading.passing.back();
    return is_measured ? std::optional(grains::size_at(grading, share)) : std::nullopt;
}

/// Between which values a size [m] or a share lies; both are the same where it was measured.
struct Bounds {
    double least = 0, most = std::numeric_limits<double>::infinity();

    [[nodiscard]] bool is_known() const { return least == most; }
};

/// Of the size below which a share of the mass lies: a share that the finest measured size passes is finer than that.
inline Bounds size_bounds(const grains::Grading& grading, double share) {
    if (const auto size = size_within(grading, share)) {
        return {*size, *size};
    }
    return share < grading.passing.front() ? Bounds{0, grading.diameter.front()} : Bounds{grading.diameter.back()};
}

/// The share finer than a size [m].
inline std::optional<double> share_within(const grains::Grading& grading, double size) {
    if (size < grading.diameter.front()) {
        return grading.passing.front() > 0 ? std::nullopt : std::optional(0.0);
    }
    if (size > grading.diameter.back()) {
        return grading.passing.back() < 1 ? std::nullopt : std::optional(1.0);
    }
    return grains::passing(grading, size);
}

/// The same, where it was not measured between those that were.
inline Bounds share_bounds(const grains::Grading& grading, double size) {
    if (const auto share = share_within(grading, size)) {
        return {*share, *share};
    }
    return size < grading.diameter.front() ? Bounds{0, grading.passing.front()} : Bounds{grading.passing.back(), 1};
}

} // namespace suffuse::stability
