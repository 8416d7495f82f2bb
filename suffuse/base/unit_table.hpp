#pragma once
// The units that texts may use and the names of dimensions: what is behind units.hpp, for no one else.

#include "suffuse/base/constants.hpp"
#include "suffuse/base/units.hpp"

#include <array>
#include <string>
#include <string_view>

namespace suffuse::detail {

struct Unit {
    std::string_view symbol;
    Dimension dimension;
    int exponent = 0;  ///< power of ten
    double factor = 1; ///< what is not a power of ten
};

inline constexpr std::array units = {
    Unit{"m", dimension::length},
    Unit{"km", dimension::length, 3},
    Unit{"dm", dimension::length, -1},
    Unit{"cm", dimension::length, -2},
    Unit{"mm", dimension::length, -3},
    Unit{"um", dimension::length, -6},
    Unit{"\u00b5m", dimension::length, -6},
    Unit{"\u03bcm", dimension::length, -6},
    Unit{"nm", dimension::length, -9},
    Unit{"s", dimension::time},
    Unit{"ms", dimension::time, -3},
    Unit{"us", dimension::time, -6},
    Unit{"\u00b5s", dimension::time, -6},
    Unit{"\u03bcs", dimension::time, -6},
    Unit{"ns", dimension::time, -9},
    Unit{"min", dimension::time, 0, 60},
    Unit{"h", dimension::time, 0, 3600},
    Unit{"day", dimension::time, 0, 86400},
    Unit{"kg", dimension::mass},
    Unit{"g", dimension::mass, -3},
    Unit{"mg", dimension::mass, -6},
    Unit{"t", dimension::mass, 3},
    Unit{"Pa", dimension::pressure},
    Unit{"mPa", dimension::pressure, -3},
    Unit{"hPa", dimension::pressure, 2},
    Unit{"kPa", dimension::pressure, 3},
    Unit{"MPa", dimension::pressure, 6},
    Unit{"GPa", dimension::pressure, 9},
    Unit{"bar", dimension::pressure, 5},
    Unit{"mbar", dimension::pressure, 2},
    Unit{"N", dimension::force},
    Unit{"mN", dimension::force, -3},
    Unit{"kN", dimension::force, 3},
    Unit{"MN", dimension::force, 6},
    Unit{"Hz", dimension::rate},
    Unit{"rad", dimension::angle},
    Unit{"deg", dimension::angle, 0, pi / 180.0},
    Unit{"\u00b0", dimension::angle, 0, pi / 180.0},
    Unit{"%", dimension::none, -2},
    Unit{"1", dimension::none},
};

struct NamedDimension {
    Dimension dimension;
    std::string_view name;
    std::array<std::string_view, 4> usual; ///< decimal ones, the first is used in advice
};

inline constexpr std::array named_dimensions = {
    NamedDimension{dimension::none, "ratio", {}},
    NamedDimension{dimension::length, "length", {"mm", "m", "um", "km"}},
    NamedDimension{dimension::time, "time", {"s", "ms", "us", {}}},
    NamedDimension{dimension::mass, "mass", {"kg", "g", "mg", {}}},
    NamedDimension{dimension::angle, "angle", {"deg", "rad", {}, {}}},
    NamedDimension{dimension::rate, "rate", {"1/s", {}, {}, {}}},
    NamedDimension{dimension::acceleration, "acceleration", {"m/s^2", {}, {}, {}}},
    NamedDimension{dimension::velocity, "velocity", {"m/s", "mm/s", "um/s", {}}},
    NamedDimension{dimension::force, "force", {"N", "kN", "mN", {}}},
    NamedDimension{dimension::pressure, "pressure", {"kPa", "Pa", "MPa", "GPa"}},
    NamedDimension{dimension::viscosity, "viscosity", {"mPa*s", "Pa*s", {}, {}}},
    NamedDimension{dimension::density, "density", {"kg/m^3", {}, {}, {}}},
    NamedDimension{dimension::mass_per_length, "mass per length", {"kg/m", "g/m", {}, {}}},
};

/// A product of units: what "kg/m^3" adds to a number.
struct UnitProduct {
    Dimension dimension;
    long exponent = 0;
    double factor = 1;
};

/// Throws UnitError: an unknown unit, naming those that are like it.
UnitProduct parse_product(std::string_view text);

/// "kg*m^-1*s^-2".
std::string base_units(Dimension dimension);

} // namespace suffuse::detail
