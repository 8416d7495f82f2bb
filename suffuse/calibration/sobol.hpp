#pragma once
// Points that fill the unit cube evenly: Sobol's sequence with the direction numbers of Joe and Kuo (2008), shifted
// digit by digit by random bits [Cranley and Patterson; L'Ecuyer and Lemieux 2002], which keeps how evenly it fills.

#include <cstdint>
#include <vector>

namespace suffuse::calibration {

inline constexpr int most_dimensions = 16;

/// A point of the unit cube, a coordinate in [0, 1) for each unknown.
using Point = std::vector<double>;

/// Point `index` (from 0) of the plain sequence. @throws std::invalid_argument for more than `most_dimensions`.
Point sobol_point(std::uint32_t index, int dimensions);

/// Points `first` to `first + count - 1` of the shifted sequence. Any 2^k of them from a multiple of 2^k on have
/// exactly one in each of 2^k equal slices of every axis.
std::vector<Point> design_points(std::uint32_t first, int count, int dimensions, std::uint64_t seed);

} // namespace suffuse::calibration
