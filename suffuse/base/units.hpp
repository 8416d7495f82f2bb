#pragma once
// Quantities with their unit, "0.5 mm" -> 5e-4: the only unit conversion in the project. A unit is a product of known
// symbols with whole powers (kg/m^3, kg/m3, mPa*s, 1/s). Decimal prefixes move the decimal exponent of the number
// before it is read, so that "0.26 mm", "260 um" and "2.6e-4 m" give the same bits.

#include "suffuse/base/error.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace suffuse {

/// Powers of meter, kilogram, second and radian. An angle is kept apart, so that a ratio is never taken for one.
struct Dimension {
    int length = 0, mass = 0, time = 0, angle = 0;

    constexpr bool operator==(const Dimension&) const = default;
};

namespace dimension {
inline constexpr Dimension none{};
inline constexpr Dimension length{1, 0, 0, 0};
inline constexpr Dimension time{0, 0, 1, 0};
inline constexpr Dimension mass{0, 1, 0, 0};
inline constexpr Dimension angle{0, 0, 0, 1};
inline constexpr Dimension rate{0, 0, -1, 0};
inline constexpr Dimension velocity{1, 0, -1, 0};
inline constexpr Dimension acceleration{1, 0, -2, 0};
inline constexpr Dimension force{1, 1, -2, 0};
inline constexpr Dimension pressure{-1, 1, -2, 0};
inline constexpr Dimension viscosity{-1, 1, -1, 0};
inline constexpr Dimension density{-3, 1, 0, 0};
inline constexpr Dimension mass_per_length{-1, 1, 0, 0};
} // namespace dimension

/// A text that is no quantity, or the wrong one. `help` is one thing to do. Who decides by an error reads its kind,
/// never its words.
struct UnitError : Error {
    enum class Kind { NoNumber, UnknownUnit, Malformed, OutOfRange, NoUnit, OtherDimension };

    UnitError(Kind its_kind, const std::string& message, std::string what_to_do)
        : Error(message), kind(its_kind), help(std::move(what_to_do)) {}

    Kind kind;
    std::string help;
};

struct Quantity {
    double value = 0; ///< in SI
    Dimension dimension;
    bool has_unit = false; ///< a unit was written; "%" is one
};

/// The quantity that `text` says; a quotient of two of one dimension, as a hydraulic gradient is measured, "12 m / 30
/// m", is a ratio. Throws UnitError: no number, unknown unit (naming the nearest known), out of range.
Quantity parse_quantity(std::string_view text);

/// The same in SI, of the wanted dimension. Throws UnitError where the unit is missing or of another dimension.
double parse_quantity(std::string_view text, Dimension wanted);

/// What a unit stands for in SI, written with its number or without: "mm" and "1 mm" are both 1e-3. Throws UnitError.
double parse_unit(std::string_view text, Dimension wanted);

/// `value` [SI] in the most usual unit, or in one that makes it clearly shorter; reading it back gives the same bits.
std::string print_quantity(double value, Dimension dimension);

/// "pressure", or the powers of the base units where the dimension has no name.
std::string name_of(Dimension dimension);

/// The same with its article: "a pressure", "an angle".
std::string with_article(Dimension dimension);

/// Units in which people of the field write this dimension, the most usual first.
std::vector<std::string> usual_units(Dimension dimension);

} // namespace suffuse
