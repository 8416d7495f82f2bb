#pragma once
// What sheets write below a curve that was read off it: D10, D30, D60, Cu, Cc, shares of gravel, sand and fines.
// Nothing is taken from them; a remark says where they contradict the curve.

#include "suffuse/base/diagnostics.hpp"
#include "suffuse/grains/soil.hpp"
#include "suffuse/io/sheet.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::io {

struct DerivedValue {
    enum class Kind {
        SizeAt, ///< D10
        Uniformity,
        Curvature,
        Cobbles,
        Gravel,
        Sand,
        Fines, ///< silt and clay together
        Silt,
        Clay,
        Passing, ///< what passes a named sieve
        Largest,
        Other, ///< known, and not a matter of the curve alone: fineness modulus, limits, classes
    };

    Kind kind = Kind::Other;
    double at = 0;               ///< share of SizeAt [-], size of Passing [m]
    std::optional<double> value; ///< size [m], share [-], ratio; empty where none was written
    std::string name;            ///< as written
    Place place;
    std::size_t column = 0; ///< of the value in its sheet, from 0
};

/// What a text names, as in "D60 (mm)", "% Gravel", "Cu", "D10= 0.12"; empty where it names none of these.
std::optional<DerivedValue> read_derived_name(std::string_view text);

/// All that a row says: a name before its value, or several; one value a soil in a table of many.
std::vector<DerivedValue> read_derived(const Sheet& sheet, const SheetRow& row);

/// The values that stand below their names: "Gravel %,Sand %,Fines %" above "28,60,12".
std::vector<DerivedValue> read_derived_below(const Sheet& sheet, const SheetRow& names, const SheetRow& values);

/// Tells what contradicts the curve.
void check_derived(
    const std::vector<DerivedValue>& values, const grains::Grading& grading, const std::string& soil, Problems& problems
);

} // namespace suffuse::io
