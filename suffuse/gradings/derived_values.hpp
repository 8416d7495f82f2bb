#pragma once
// What sheets write below a curve that was read off it: D10, D30, D60, Cu, Cc, shares of gravel, sand and fines.
// Nothing is taken from them; a remark says where they contradict the curve.

#include "suffuse/base/diagnostics.hpp"
#include "suffuse/gradings/sheet.hpp"
#include "suffuse/grains/soil.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::gradings {

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
        Loss,  ///< in sieving: a mass, or percents
        Other, ///< known, and not a matter of the curve alone: fineness modulus, limits, classes
    };

    Kind kind = Kind::Other;
    double at = 0;               ///< share of SizeAt [-], size of Passing [m]
    std::optional<double> value; ///< size [m], share [-], ratio; empty where none was written
    std::string name;            ///< as written
    Place place;
    std::size_t column = 0; ///< of the value in its sheet, from 0
    std::string unit;       ///< behind its number: "%", "g"
};

/// What a text names, as in "D60 (mm)", "% Gravel", "Cu", "D10= 0.12"; empty where it names none of these.
std::optional<DerivedValue> read_derived_name(std::string_view text);

/// All that a row says: a name before its value, or several; one value a soil in a table of many; names
/// joined by slashes as well.
std::vector<DerivedValue> read_derived(const Sheet& sheet, const SheetRow& row);

/// The values that stand below their names: "Gravel %,Sand %,Fines %" above "28,60,12".
std::vector<DerivedValue> read_derived_below(const Sheet& sheet, const SheetRow& names, const SheetRow& values);

/// Which of some rows say derived values, and these.
struct DerivedRows {
    std::vector<bool> are_derived; ///< row by row from the first one
    std::vector<DerivedValue> values;
};

/// Of the rows from `first` to before `end`. @param is_sieve rows that are none of these, whatever they begin with
DerivedRows find_derived_rows(
    const Sheet& sheet, std::size_t first, std::size_t end, const std::function<bool(const SheetRow&)>& is_sieve
);

/// Reports what contradicts the curve.
void check_derived(
    const std::vector<DerivedValue>& values, const grains::Grading& grading, const std::string& soil, Problems& problems
);

} // namespace suffuse::gradings
