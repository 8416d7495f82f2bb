#pragma once
// Why an erosion or a removal stops, with the numbers that say so. Its words: facts/ending_words.hpp.

#include "suffuse/erosion/spec.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace suffuse::erosion {

/// The usual end of an erosion.
struct NothingLeaves {
    bool operator==(const NothingLeaves&) const = default;
};

/// What leaves cannot be distinguished from the noise of the probe's twin.
struct NoiseDecides {
    bool operator==(const NoiseDecides&) const = default;
};

/// The coarse skeleton has lost its meaning as a filter.
struct SkeletonDoubt {
    std::int64_t coarse = 0; ///< grains left
    double width = 0;        ///< of the cell, in median coarse diameters; 0 where the grains are too few [-]

    bool operator==(const SkeletonDoubt&) const = default;
};

/// The skeleton does not carry its stresses any more.
struct SkeletonFailed {
    double most_strain = 0; ///< that an axis may strain by in a pass [-]

    bool operator==(const SkeletonFailed&) const = default;
};

/// The skeleton finds no rest under its stresses, though it strains little.
struct SkeletonRestless {
    std::int64_t steps = 0; ///< under them
    double carried = 0;     ///< share of the mean stress at the end [-]

    bool operator==(const SkeletonRestless&) const = default;
};

/// As much has left as was specified.
struct TargetReached {
    double share = 0, specified = 0; ///< of the mass [-]
    ErodedTarget::Of of = ErodedTarget::Of::Fines;
    std::optional<SkeletonDoubt> doubt;

    bool operator==(const TargetReached&) const = default;
};

/// A removal of several passes took all that it may before the last.
struct NoneToRemove {
    int pass = 0, passes = 0;

    bool operator==(const NoneToRemove&) const = default;
};

/// Of a result by another version, which states it in words that this one does not use.
struct OtherWording {
    std::string words;

    bool operator==(const OtherWording&) const = default;
};

/// Why the procedure stops after a pass; false where it goes on.
struct Ending {
    std::variant<
        std::monostate, NothingLeaves, NoiseDecides, SkeletonDoubt, SkeletonFailed, SkeletonRestless, TargetReached,
        NoneToRemove, OtherWording>
        why;

    explicit operator bool() const { return !std::holds_alternative<std::monostate>(why); }

    bool operator==(const Ending&) const = default;
};

} // namespace suffuse::erosion
