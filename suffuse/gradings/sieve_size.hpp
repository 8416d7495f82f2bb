#pragma once
// The size of a sieve in any notation of laboratories: millimeters, microns, inches and their fractions, numbers of
// ASTM E11, phi. Nominal inches and numbers stand for the openings that ASTM E11 gives them.

#include <optional>
#include <string>
#include <string_view>

namespace suffuse::gradings {

/// What a plain number of a column means.
enum class SizeScale { Unknown, Millimeters, Micrometers, Meters, Centimeters, Inches, SieveNumber, Phi };

/// How a size was written.
enum class SizeNotation {
    Plain,       ///< 4.75
    WithUnit,    ///< 4.75 mm
    Inches,      ///< 3/8", 1-1/2 in.
    SieveNumber, ///< No. 200
};

struct SieveSize {
    double diameter = 0; ///< [m]; of a plain number only once its scale is known
    SizeNotation notation = SizeNotation::Plain;
    bool is_on_scale = true; ///< false: a sieve number or opening that ASTM E11 does not have
};

/// The size that a cell says; nothing where it says none. A plain number is taken on `scale`, in mm where that is not
/// known. `comma` says whether a comma may be a decimal one.
std::optional<SieveSize> read_sieve_size(std::string_view text, SizeScale scale, bool comma = true);

/// Opening of a sieve number of ASTM E11 [m].
std::optional<double> sieve_opening(double number);

/// What a unit that stands in a heading means: "mm", "µm", "microns", "inches", "phi", "No."; Unknown where it is none.
SizeScale size_scale_of(std::string_view unit);

/// "um", as commands and reports name a scale; mm where it is not known.
const char* scale_name(SizeScale scale);

/// A number with a decimal point or, where `comma` allows, a decimal comma. Nothing else may stand next to it.
std::optional<double> plain_number(std::string_view text, bool comma);

} // namespace suffuse::gradings
