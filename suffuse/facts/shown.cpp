#include "suffuse/facts/shown.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/facts/by_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace suffuse::facts {
namespace {

struct Conversion {
    std::string_view from, to;
    double times, over; ///< one of them is 1, so that a value has the bits of the plain product or quotient
};

constexpr std::array conversions{
    Conversion{"Pa", "kPa", 1, 1e3}, Conversion{"Pa", "MPa", 1, 1e6}, Conversion{"-", "%", 100, 1},
    Conversion{"m", "mm", 1e3, 1},   Conversion{"m2", "m²", 1, 1},    Conversion{"rad", "°", degrees(1), 1},
};

const Fact& fact_of(std::string_view key) {
    const Fact* const fact = shown_fact(key);
    if (fact == nullptr) {
        throw Bug(fmt::format("\"{}\" has no name for tables and axes", key));
    }
    return *fact;
}

} // namespace

std::string title(std::string_view key) {
    const Shown& shown = fact_of(key).shown;
    return fmt::format("{}{}{} [{}]", shown.name, shown.symbol.empty() ? "" : " ", shown.symbol, shown.unit);
}

std::string short_title(std::string_view key) {
    const Shown& shown = fact_of(key).shown;
    return fmt::format("{} [{}]", shown.symbol.empty() ? shown.name : shown.symbol, shown.unit);
}

std::string_view unit_shown(std::string_view key) {
    return fact_of(key).shown.unit;
}

int digits_shown(std::string_view key) {
    return fact_of(key).shown.digits;
}

double in_unit_shown(std::string_view key, double value) {
    const Fact& fact = fact_of(key);
    if (fact.unit == fact.shown.unit) {
        return value;
    }
    const auto* const found = std::ranges::find_if(conversions, [&](const Conversion& conversion) {
        return conversion.from == fact.unit && conversion.to == fact.shown.unit;
    });
    if (found == conversions.end()) {
        throw Bug(fmt::format("{} has no conversion to {}", fact.unit, fact.shown.unit));
    }
    return value * found->times / found->over;
}

std::string text_shown(std::string_view key, double value) {
    return short_number(in_unit_shown(key, value), digits_shown(key));
}

} // namespace suffuse::facts
