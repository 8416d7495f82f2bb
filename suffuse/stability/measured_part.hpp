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

/// Between which sizes one lies [m]; both are the same where it was measured.
struct SizeBounds {
    double least = 0, most = std::numeric_limits<double>::infinity();

    [[nodiscard]] bool is_known() const { return least == most; }
};

/// Of the size below which a share of the mass lies: a share that the finest measured size passes is finer than that.
inline SizeBounds size_bounds(const grains::Grading& grading, double share) {
    if (const auto size = size_within(grading, share)) {
        return {*size, *size};
    }
    return share < grading.passing.front() ? SizeBounds{0, grading.diameter.front()}
                                           : SizeBounds{grading.diameter.back()};
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

} // namespace suffuse::stability
