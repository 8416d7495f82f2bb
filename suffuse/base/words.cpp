#include "suffuse/base/words.hpp"

#include "suffuse/base/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace suffuse {

namespace {

const char* const no_break = "\u00a0";
const std::array<std::string_view, 8> units = {"%", "kPa", "mm", "m²", "m/s", "s", "N", "grains"};

bool starts_with_unit(std::string_view rest) {
    return std::any_of(units.begin(), units.end(), [rest](std::string_view unit) {
        const bool ends_there =
            rest.size() == unit.size() || (rest.size() > unit.size() && !std::isalpha(rest[unit.size()]));
        return rest.starts_with(unit) && ends_there;
    });
}

std::string superscript(int exponent) {
    static const std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string out = exponent < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(exponent))) {
        out += digits[static_cast<std::size_t>(digit - '0')];
    }
    return out;
}

} // namespace

std::string short_number(double value, int digits) {
    if (!std::isfinite(value)) {
        return "–";
    }
    const double size = std::abs(value);
    const std::string sign = value < 0 ? "−" : "";
    if (size == 0 || (size >= 1e-3 && size < 1e5)) {
        // The round trip drops trailing zeros and never falls into powers of ten in this range.
        return sign + fmt::format("{}", std::strtod(fmt::format("{:.{}g}", size, digits).c_str(), nullptr));
    }
    return number_with_power(value, digits);
}

std::string number_with_power(double value, int digits) {
    const std::string text = fmt::format("{:.{}e}", std::abs(value), digits - 1);
    const std::size_t at = text.find('e');
    const double leading = std::strtod(text.substr(0, at).c_str(), nullptr);
    return fmt::format("{}{}·", value < 0 ? "−" : "", leading) + power_of_ten(std::atoi(text.c_str() + at + 1));
}

bool is_noise(double percent) {
    return std::abs(percent) < 0.01;
}

std::string percent_beyond_noise(double percent) {
    return is_noise(percent) ? "< 0.01" : fmt::format("{}{:.2f}", percent < 0 ? "−" : "", std::abs(percent));
}

std::string power_of_ten(int exponent) {
    return "10" + superscript(exponent);
}

std::string kept_together(std::string_view text) {
    std::string out;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const bool space = text[k] == ' ' && k > 0 && k + 1 < text.size();
        const bool unit = space && is_digit(text[k - 1]) && starts_with_unit(text.substr(k + 1));
        const auto relates = [](char c) { return c == '=' || c == '<'; };
        if (unit || (space && (relates(text[k - 1]) || relates(text[k + 1])))) {
            out += no_break;
        } else {
            out += text[k];
        }
    }
    return out;
}

std::string as_sentence(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') {
        text[0] = static_cast<char>(text[0] - 'a' + 'A');
    }
    return text;
}

} // namespace suffuse
