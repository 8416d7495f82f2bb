#pragma once
// How many grains a sample of two fractions needs to be representative: enough coarse grains, or a cell so many coarse
// diameters wide, whichever takes fewer grains in all; and never fewer than a floor, below which the means of a sample
// scatter too much. Where fines are many, a ceiling on the grains may take coarse ones away, down to a least number.
// Fines alone are counted and measured by themselves.

#include "suffuse/grains/soil.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace suffuse::grains {

struct SampleSizeSpec {
    std::int64_t coarse_grains = 200; ///< at least so many
    double cell_width = 10;           ///< or a cell so many median coarse diameters wide [-]
    std::int64_t at_least = 2000;     ///< grains of both fractions
    /// Grains of both fractions that can be paid for: beyond them coarse grains give way, down to `least_coarse`.
    std::optional<std::int64_t> at_most;
    std::int64_t least_coarse = 60;
};

/// Which of the rules decided.
enum class SizedBy { CoarseGrains, CellWidth, AtLeast, AtMost, LeastCoarse };

/// The key of the rule, as in a case file.
constexpr std::string_view name_of(SizedBy rule) {
    switch (rule) {
    case SizedBy::CoarseGrains:
        return "coarse_grains";
    case SizedBy::CellWidth:
        return "cell_width";
    case SizedBy::AtLeast:
        return "at_least";
    case SizedBy::AtMost:
        return "at_most";
    case SizedBy::LeastCoarse:
        return "least_coarse";
    }
    return {};
}

struct SampleSize {
    std::int64_t particles = 0;
    SizedBy rule = SizedBy::AtLeast;
};

/// Porosity of the settled sample whose cell is meant: of a sand at some 100 kPa.
inline constexpr double sized_porosity = 0.4;

/// @throws CaseError unless `soil` has a coarse and a fine grading and a fines content from 0 to 1.
SampleSize size_sample(const Soil& soil, const SampleSizeSpec& spec);

} // namespace suffuse::grains
