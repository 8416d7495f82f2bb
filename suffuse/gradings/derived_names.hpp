#pragma once
// Names of what is read off a curve: D10, D30, D60, Cu, Cc, shares of gravel, sand and fines; in English, French,
// German, Spanish and Italian.

#include "suffuse/base/diagnostics.hpp"

#include <cstddef>
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

/// Where the value begins in a text that has it, too: "D10= 0.09", "Cu: 50", "D60 2.0 mm"; else its end.
std::size_t value_begin(std::string_view text);

/// "D10 / D30 / D60", "Cu/Cc": each of several names in one text, which may go on with "=" and values; else empty.
std::vector<DerivedValue> read_joined_names(std::string_view text);

/// What stands between slashes.
std::vector<std::string_view> split_joined(std::string_view text);

} // namespace suffuse::gradings
