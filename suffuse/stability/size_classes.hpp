#pragma once
// Shares of gravel, sand and fines by the two systems that reports use: ASTM D2487 and ISO 14688-1.

#include "suffuse/grains/soil.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::stability {

struct SizeClass {
    std::string name;            ///< "gravel"
    double finest = 0;           ///< [m]; 0 for the finest class
    std::optional<double> share; ///< of the mass [-]; nothing where a bound was not measured
};

/// Cobbles and boulders, gravel, sand, fines: limits 75, 4.75 and 0.075 mm.
std::vector<SizeClass> astm_classes(const grains::Grading& measured);

/// Very coarse soil, gravel, sand, silt, clay: limits 63, 2, 0.063 and 0.002 mm.
std::vector<SizeClass> iso_classes(const grains::Grading& measured);

/// "gravel 12 %, sand 60 %, fines 28 %": classes that have mass, or may have.
std::string classes_text(const std::vector<SizeClass>& classes);

} // namespace suffuse::stability
