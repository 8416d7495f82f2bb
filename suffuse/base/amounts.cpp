#include "suffuse/base/amounts.hpp"

#include "suffuse/base/grouped.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse {
namespace {

constexpr double minute = 60, hour = 3600, day = 86400;

/// Two digits: 4.2, 42, 420.
std::string two_digits(double value) {
    return value < 9.95 ? fmt::format("{:.1f}", value) : fmt::format("{:.0f}", value);
}

std::string whole_or_half(double value) {
    return value < 1.95 ? fmt::format("{:.1f}", value) : fmt::format("{:.0f}", value);
}

std::string one_number(double count) {
    constexpr double few = 1e4;
    if (count < few) {
        return count_text(std::llround(count));
    }
    const int power = static_cast<int>(std::floor(std::log10(count)));
    return fmt::format("{:.1f}e{}", count / std::pow(10.0, power), power);
}

} // namespace

std::string duration_text(double seconds) {
    if (seconds < 59.5) {
        return two_digits(std::max(seconds, 0.0)) + " s";
    }
    const auto whole = static_cast<std::int64_t>(std::llround(seconds));
    if (whole < 3600) {
        return fmt::format("{} min {} s", whole / 60, whole % 60);
    }
    return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

std::string duration_range_text(const Range& seconds) {
    struct Unit {
        double most, size;
        std::string_view name;
    };

    constexpr std::array units{
        Unit{99, 1, "s"}, Unit{99 * minute, minute, "min"}, Unit{48 * hour, hour, "h"}, Unit{1e300, day, "days"}};
    constexpr double narrowest = 1.1;
    const double most = std::max(seconds.most, narrowest * seconds.least);
    if (!std::isfinite(most)) {
        return "an unknown time";
    }
    if (most < 1) {
        return "under 1 s";
    }
    const Unit& unit = *std::find_if(units.begin(), units.end(), [&](const Unit& u) { return most < u.most; });
    const auto number = [&](double value) {
        return unit.size == 1 ? fmt::format("{:.0f}", value) : whole_or_half(value / unit.size);
    };
    const std::string low = number(seconds.least), high = number(most);
    if (low.find_first_not_of("0.") == std::string::npos) {
        return fmt::format("up to {} {}", high, unit.name);
    }
    return low == high ? fmt::format("about {} {}", high, unit.name) : fmt::format("{}-{} {}", low, high, unit.name);
}

std::string size_text(double bytes) {
    constexpr std::array names{"B", "kB", "MB", "GB", "TB"};
    std::size_t unit = 0;
    while (bytes >= 999.5 && unit + 1 < names.size()) {
        bytes /= 1000;
        ++unit;
    }
    return unit == 0 ? fmt::format("{:.0f} B", bytes) : fmt::format("{} {}", two_digits(bytes), names[unit]);
}

std::string count_text(std::int64_t count) {
    return grouped(count);
}

std::string digits_text(double value, int count) {
    return std::abs(value) < 100 ? fmt::format("{:.{}g}", value, count) : fmt::format("{:.0f}", value);
}

std::string steps_text(const Range& steps) {
    const std::string low = one_number(steps.least), high = one_number(steps.most);
    return low == high ? high : low + "-" + high;
}

std::string plural(std::int64_t count, std::string_view noun) {
    if (count == 1) {
        return fmt::format("1 {}", noun);
    }
    const bool is_y = noun.ends_with('y');
    return fmt::format("{} {}{}", count_text(count), is_y ? noun.substr(0, noun.size() - 1) : noun, is_y ? "ies" : "s");
}

} // namespace suffuse
