#pragma once
// How many grains a sample of two fractions needs to be representative: enough coarse grains, or a cell so many coarse
// diameters wide, whichever takes fewer grains in all; and never fewer than a floor, below which the means of a sample
// scatter too much. Fines alone are counted and measured by themselves.

#include "suffuse/grains/soil.hpp"

#include <cstdint>
#include <string_view>

namespace suffuse::grains {

struct SampleSizeSpec {
    std::int64_t coarse_grains = 200; ///< at least so many
    double cell_width = 10;           ///< or a cell so many median coarse diameters wide [-]
    std::int64_t at_least = 2000;     ///< grains of both fractions
};

/// Which of the rules decided.
enum class SizedBy { CoarseGrains, CellWidth, AtLeast };

/// The key of the rule, as in a case file.
constexpr std::string_view name_of(SizedBy rule) {
    return rule == SizedBy::CoarseGrains ? "coarse_grains" : rule == SizedBy::CellWidth ? "cell_width" : "at_least";
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
