// How units.hpp writes a quantity.

#include "suffuse/base/unit_table.hpp"
#include "suffuse/base/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace suffuse {

namespace {

using detail::UnitProduct;

/// Digits without leading or trailing zeros, and the power of ten of the first of them.
struct Digits {
    bool is_negative = false;
    std::string digits;
    int power = 0;
};

Digits shortest_digits(double value) {
    const std::string text = fmt::format("{}", value);
    Digits result;
    const std::size_t mark = text.find('e');
    const int exponent = mark == std::string::npos ? 0 : std::atoi(text.c_str() + mark + 1);
    bool after_point = false;
    for (const char c : text.substr(0, mark)) {
        if (c == '-') {
            result.is_negative = true;
        } else if (c == '.') {
            after_point = true;
        } else if (!(result.digits.empty() && c == '0')) {
            result.digits += c;
            result.power += after_point ? 0 : 1;
        } else if (after_point) {
            --result.power;
        }
    }
    while (!result.digits.empty() && result.digits.back() == '0') {
        result.digits.pop_back();
    }
    result.power += exponent - 1;
    return result;
}

std::string print_shifted(const Digits& number, int shift) {
    const std::string sign = number.is_negative ? "-" : "";
    if (number.digits.empty()) {
        return sign + "0";
    }
    const int power = number.power + shift;
    const int count = static_cast<int>(number.digits.size());
    if (power < -4 || power > 8) {
        const std::string tail = count > 1 ? fmt::format(".{}", number.digits.substr(1)) : "";
        return fmt::format("{}{}{}e{}", sign, number.digits[0], tail, power);
    }
    const auto zeros = [](int number_of_zeros) { return std::string(static_cast<std::size_t>(number_of_zeros), '0'); };
    if (power < 0) {
        return fmt::format("{}0.{}{}", sign, zeros(-power - 1), number.digits);
    }
    if (count <= power + 1) {
        return fmt::format("{}{}{}", sign, number.digits, zeros(power + 1 - count));
    }
    const auto point = static_cast<std::size_t>(power + 1);
    return fmt::format("{}{}.{}", sign, number.digits.substr(0, point), number.digits.substr(point));
}

/// `value` in a unit that is no power of ten, if some count of digits gives the same bits back.
std::optional<std::string> print_in(double value, const UnitProduct& unit, std::string_view symbol) {
    for (int digits = 1; digits <= 17; ++digits) {
        const double rounded = std::atof(fmt::format("{:.{}g}", value / unit.factor, digits).c_str());
        const std::string text = fmt::format("{} {}", print_shifted(shortest_digits(rounded), 0), symbol);
        if (parse_quantity(text).value == value) {
            return text;
        }
    }
    return std::nullopt;
}

} // namespace

std::string print_quantity(double value, Dimension dimension) {
    const Digits digits = shortest_digits(value);
    if (dimension == dimension::none) {
        return print_shifted(digits, 0);
    }
    // A power of ten reads like some digits more, and thousands like one.
    const auto length = [](const std::string& text) {
        constexpr std::size_t power_of_ten = 4;
        const std::string number = text.substr(0, text.find(' '));
        const bool thousands = std::min(number.find('.'), number.size()) > 3;
        return text.size() + (number.find('e') != std::string::npos ? power_of_ten : thousands ? 1 : 0);
    };
    std::string best;
    for (const std::string& symbol : usual_units(dimension)) {
        const UnitProduct unit = detail::parse_product(symbol);
        const auto text = unit.factor == 1
                              ? fmt::format("{} {}", print_shifted(digits, -static_cast<int>(unit.exponent)), symbol)
                              : print_in(value, unit, symbol).value_or("");
        // The most usual unit stays unless another saves more than a digit or a point.
        if (!text.empty() && (best.empty() || length(text) + 1 < length(best))) {
            best = text;
        }
    }
    return best.empty() ? fmt::format("{} {}", print_shifted(digits, 0), detail::base_units(dimension)) : best;
}

} // namespace suffuse
