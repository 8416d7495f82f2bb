#include "suffuse/base/units.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/base/unit_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace suffuse {

namespace {

using detail::named_dimensions;
using detail::NamedDimension;
using detail::Unit;
using detail::units;

const NamedDimension* find_named(Dimension wanted) {
    for (const NamedDimension& named : named_dimensions) {
        if (named.dimension == wanted) {
            return &named;
        }
    }
    return nullptr;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) {
        text.remove_prefix(1);
    }
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) {
        text.remove_suffix(1);
    }
    return text;
}

bool take(std::string_view& text, std::string_view token) {
    if (text.substr(0, token.size()) != token) {
        return false;
    }
    text.remove_prefix(token.size());
    return true;
}

/// The text of a number, cut from the front: sign and digits, and its decimal exponent apart.
struct Decimal {
    std::string digits; ///< "-0.26"
    long exponent = 0;
};

/// Reads digits, with single underscores between them as in TOML.
void take_digits(std::string_view& text, std::string& digits) {
    while (!text.empty() && (is_digit(text[0]) || (text[0] == '_' && !digits.empty() && is_digit(digits.back()) &&
                                                   text.size() > 1 && is_digit(text[1])))) {
        if (text[0] != '_') {
            digits += text[0];
        }
        text.remove_prefix(1);
    }
}

std::optional<Decimal> take_number(std::string_view& text) {
    std::string_view rest = text;
    Decimal number;
    if (take(rest, "-")) {
        number.digits = "-";
    } else {
        take(rest, "+");
    }
    const std::size_t sign = number.digits.size();
    take_digits(rest, number.digits);
    bool has_digits = number.digits.size() > sign;
    if (!rest.empty() && rest[0] == '.') {
        rest.remove_prefix(1);
        number.digits += has_digits ? "." : "0.";
        const std::size_t before = number.digits.size();
        take_digits(rest, number.digits);
        has_digits = has_digits || number.digits.size() > before;
    }
    if (!has_digits) {
        return std::nullopt;
    }
    if (rest.size() > 1 && (rest[0] == 'e' || rest[0] == 'E')) {
        const bool is_signed = rest[1] == '-' || rest[1] == '+';
        std::string_view power = rest.substr(is_signed ? 2 : 1);
        std::string digits;
        take_digits(power, digits);
        if (!digits.empty()) {
            // Six digits are far beyond what a double holds, and cannot overflow when unit exponents are added.
            const long size = digits.size() > 6 ? 999'999 : std::atol(digits.c_str());
            number.exponent = rest[1] == '-' ? -size : size;
            rest = power;
        }
    }
    text = rest;
    return number;
}

std::string_view take_symbol(std::string_view& text) {
    if (!text.empty() && text[0] == '1') {
        const std::string_view one = text.substr(0, 1);
        text.remove_prefix(1);
        return one;
    }
    constexpr std::string_view ends = "*/^ \t.()-+0123456789";
    std::size_t size = 0;
    while (size < text.size() && ends.find(text[size]) == std::string_view::npos && text.substr(size, 2) != "\u00b7" &&
           text.substr(size, 2) != "\u00b2" && text.substr(size, 2) != "\u00b3") {
        ++size;
    }
    const std::string_view symbol = text.substr(0, size);
    text.remove_prefix(size);
    return symbol;
}

int take_power(std::string_view& text, std::string_view whole) {
    if (take(text, "\u00b2")) {
        return 2;
    }
    if (take(text, "\u00b3")) {
        return 3;
    }
    const bool is_marked = take(text, "^");
    const bool is_negative = is_marked && take(text, "-");
    std::string digits;
    take_digits(text, digits);
    if (digits.empty() && !is_marked) {
        return 1;
    }
    if (digits.empty() || digits.size() > 1) {
        throw UnitError(
            UnitError::Kind::Malformed,
            fmt::format("the unit \"{}\" has a power that is no whole number below 10", whole),
            "write powers as in \"kg/m^3\" or \"1/s\""
        );
    }
    const int power = digits[0] - '0';
    return is_negative ? -power : power;
}

/// Units that the symbol may have been meant to be: capitals aside (mPa is not MPa), else with its end left out, else
/// misspelt.
std::vector<std::string> similar_units(std::string_view symbol) {
    std::vector<std::string> known, same, longer;
    for (const Unit& unit : units) {
        if (unit.symbol == "1" || symbol.empty()) {
            continue;
        }
        known.emplace_back(unit.symbol);
        if (edit_distance(symbol, unit.symbol.substr(0, symbol.size())) == 0) {
            (unit.symbol.size() == symbol.size() ? same : longer).emplace_back(unit.symbol);
        }
    }
    if (!same.empty() || !longer.empty()) {
        return same.empty() ? longer : same;
    }
    const std::optional<std::string> nearest = nearest_word(symbol, known);
    return nearest ? std::vector{*nearest} : std::vector<std::string>{};
}

/// The one unit that differs from the symbol by its capitals alone, kpa for kPa; none where two do: mpa is mPa or MPa.
const Unit* whatever_capitals(std::string_view symbol) {
    const Unit* found = nullptr;
    for (const Unit& unit : units) {
        if (symbol.size() > 2 && symbol.size() == unit.symbol.size() && edit_distance(symbol, unit.symbol) == 0) {
            if (found != nullptr) {
                return nullptr;
            }
            found = &unit;
        }
    }
    return found;
}

const Unit& find_unit(std::string_view symbol, std::string_view whole) {
    for (const Unit& unit : units) {
        if (unit.symbol == symbol) {
            return unit;
        }
    }
    if (const Unit* other = whatever_capitals(symbol)) {
        return *other;
    }
    const std::vector<std::string> similar = similar_units(symbol);
    const std::string what = symbol.empty()    ? fmt::format("\"{}\" is not a unit", whole)
                             : symbol == whole ? fmt::format("unknown unit \"{}\"", symbol)
                                               : fmt::format("unknown unit \"{}\" in \"{}\"", symbol, whole);
    throw UnitError(
        UnitError::Kind::UnknownUnit, what,
        similar.size() == 1 ? fmt::format("a unit with a similar name exists: \"{}\"", similar[0])
        : !similar.empty()  ? fmt::format("units with similar names exist: \"{}\"", fmt::join(similar, "\", \""))
                           : "known are m mm um cm km, s ms us min h, kg g mg t, Pa kPa MPa GPa bar, N kN, rad deg, %, "
                             "their products and powers such as \"kg/m^3\" or \"mPa*s\""
    );
}

} // namespace

detail::UnitProduct detail::parse_product(std::string_view text) {
    const std::string_view whole = text;
    UnitProduct product;
    int sign = take(text, "/") ? -1 : 1; // "10/s" is as clear as "10 1/s"
    while (true) {
        text = trimmed(text);
        const Unit& unit = find_unit(take_symbol(text), whole);
        const int power = sign * take_power(text, whole);
        product.dimension.length += power * unit.dimension.length;
        product.dimension.mass += power * unit.dimension.mass;
        product.dimension.time += power * unit.dimension.time;
        product.dimension.angle += power * unit.dimension.angle;
        product.exponent += power * unit.exponent;
        product.factor *= std::pow(unit.factor, power);
        text = trimmed(text);
        if (text.empty()) {
            return product;
        }
        sign = take(text, "/") ? -1 : 1;
        if (sign == 1) {
            if (!take(text, "*") && !take(text, "\u00b7")) {
                take(text, ".");
            }
        }
    }
}

std::string detail::base_units(Dimension dimension) {
    std::string text;
    const auto add = [&](std::string_view symbol, int power) {
        if (power != 0) {
            text += fmt::format("{}{}^{}", text.empty() ? "" : "*", symbol, power);
        }
    };
    add("kg", dimension.mass);
    add("m", dimension.length);
    add("s", dimension.time);
    add("rad", dimension.angle);
    return text;
}

namespace {

/// A number and its unit.
Quantity parse_one(std::string_view text) {
    std::string_view rest = trimmed(text);
    const auto number = take_number(rest);
    if (!number) {
        throw UnitError(
            UnitError::Kind::NoNumber, fmt::format("\"{}\" does not start with a number", text),
            "write a number and its unit, as in \"100 kPa\""
        );
    }
    if (rest.size() > 1 && rest[0] == ',' && is_digit(rest[1])) {
        throw UnitError(
            UnitError::Kind::Malformed, fmt::format("\"{}\" has a decimal comma", text), "write a decimal point"
        );
    }
    rest = trimmed(rest);
    Quantity quantity;
    quantity.has_unit = !rest.empty();
    const detail::UnitProduct unit = quantity.has_unit ? detail::parse_product(rest) : detail::UnitProduct{};
    const std::string digits = fmt::format("{}e{}", number->digits, number->exponent + unit.exponent);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), quantity.value);
    quantity.value *= unit.factor;
    if (error == std::errc::result_out_of_range || !std::isfinite(quantity.value)) {
        throw UnitError(
            UnitError::Kind::OutOfRange, fmt::format("\"{}\" is beyond what a number can hold", text),
            "write a value between 1e-300 and 1e300"
        );
    }
    if (error != std::errc{} || end != digits.data() + digits.size()) {
        throw Bug(fmt::format("the number {} was cut wrongly", digits));
    }
    quantity.dimension = unit.dimension;
    return quantity;
}

/// Where "12 m / 30 m" is divided: at the first / that a number follows. A unit never has one there but in 1/1.
std::size_t find_division(std::string_view text) {
    for (std::size_t at = text.find('/'); at != std::string_view::npos; at = text.find('/', at + 1)) {
        const std::string_view divisor = trimmed(text.substr(at + 1));
        if (!divisor.empty() && (is_digit(divisor[0]) || divisor[0] == '.')) {
            return at;
        }
    }
    return std::string_view::npos;
}

double parse_quotient(std::string_view text, std::size_t at) {
    const Quantity dividend = parse_one(text.substr(0, at)), divisor = parse_one(text.substr(at + 1));
    if (dividend.dimension != divisor.dimension) {
        throw UnitError(
            UnitError::Kind::Malformed,
            fmt::format(
                "\"{}\" divides {} by {}, a ratio is expected", text, with_article(dividend.dimension),
                with_article(divisor.dimension)
            ),
            "write both in units of one kind, as in \"12 m / 30 m\""
        );
    }
    if (!(std::abs(divisor.value) > 0) || !std::isfinite(dividend.value / divisor.value)) {
        throw UnitError(
            UnitError::Kind::OutOfRange, fmt::format("\"{}\" divides by nothing", text), "write a divisor above 0"
        );
    }
    return dividend.value / divisor.value;
}

} // namespace

Quantity parse_quantity(std::string_view text) {
    if (const std::size_t at = find_division(text); at != std::string_view::npos) {
        return {parse_quotient(text, at), dimension::none, true};
    }
    return parse_one(text);
}

double parse_quantity(std::string_view text, Dimension wanted) {
    const Quantity quantity = parse_quantity(text);
    if (quantity.dimension == wanted && (quantity.has_unit || wanted == dimension::none)) {
        return quantity.value;
    }
    const std::vector<std::string> usual = usual_units(wanted);
    const std::string advice =
        usual.empty()
            ? fmt::format(
                  "write {}", wanted == dimension::none ? "a bare number, or one with %" : detail::base_units(wanted)
              )
            : fmt::format("write it in {}", usual.front());
    if (!quantity.has_unit) {
        throw UnitError(
            UnitError::Kind::NoUnit, fmt::format("\"{}\" has no unit, {} is expected", text, with_article(wanted)),
            advice
        );
    }
    throw UnitError(
        UnitError::Kind::OtherDimension,
        fmt::format("\"{}\" is {}, {} is expected", text, with_article(quantity.dimension), with_article(wanted)),
        advice
    );
}

double parse_unit(std::string_view text, Dimension wanted) {
    std::string_view rest = trimmed(text);
    const bool has_number = take_number(rest).has_value();
    const double unit = has_number ? parse_quantity(text, wanted) : parse_quantity(fmt::format("1 {}", text), wanted);
    if (!(unit > 0)) {
        throw UnitError(
            UnitError::Kind::OutOfRange, fmt::format("\"{}\" is not a unit, which is above 0", text),
            "write it as in \"mm\" or \"1 mm\""
        );
    }
    return unit;
}

std::string name_of(Dimension dimension) {
    const NamedDimension* named = find_named(dimension);
    return named ? std::string(named->name) : fmt::format("quantity in {}", detail::base_units(dimension));
}

std::string with_article(Dimension dimension) {
    return (dimension == dimension::angle ? "an " : "a ") + name_of(dimension);
}

std::vector<std::string> usual_units(Dimension dimension) {
    std::vector<std::string> usual;
    if (const NamedDimension* named = find_named(dimension)) {
        for (const std::string_view symbol : named->usual) {
            if (!symbol.empty()) {
                usual.emplace_back(symbol);
            }
        }
    }
    return usual;
}

} // namespace suffuse
