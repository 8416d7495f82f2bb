#include "apps/wording.hpp"

#include "suffuse/base/grouped.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::apps {
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

constexpr char escape = '\x1b'; ///< begins what sets a color; it takes no column

/// Where the next character begins after that at `at`: past the rest of its UTF-8, or of a color's sequence.
std::size_t after_character(std::string_view text, std::size_t at) {
    if (text[at] == escape) {
        return std::min(text.find('m', at), text.size() - 1) + 1;
    }
    do {
        ++at;
    } while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U);
    return at;
}

/// How a long line goes on: below its last column, or, where that stands far to the right, with the whole column below.
struct Hanging {
    std::size_t indent;          ///< of the lines that follow [columns]
    std::size_t first_break = 0; ///< where the line is broken first [bytes]; 0: where it is full
};

Hanging hang(std::string_view line, std::size_t columns) {
    const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
    constexpr std::string_view help = "= help: ";
    const std::size_t below = line.substr(begin).starts_with(help) ? begin + help.size() : begin > 0 ? begin : 4;
    const std::size_t gap = line.rfind("  ");
    if (gap == std::string_view::npos || gap < begin) {
        return {below};
    }
    const std::size_t before = columns_of(line.substr(0, gap + 2));
    return before <= columns / 2 ? Hanging{before} : Hanging{below, before <= columns ? gap + 1 : 0};
}

/// Quoted source with its caret, and commands to be copied, keep their line whatever the terminal does with it.
bool is_kept_whole(std::string_view line) {
    constexpr std::size_t place_of_bar = 8;
    const bool is_command = line.starts_with("suffuse ") && line.find(": ") == std::string_view::npos;
    return is_command || line.substr(0, place_of_bar).find('|') != std::string_view::npos;
}

std::string folded_line(std::string_view line, std::size_t columns) {
    if (columns_of(line) <= columns || is_kept_whole(line)) {
        return std::string(line);
    }
    const auto [indent, first_break] = hang(line, columns);
    std::string text, rest(line);
    while (columns_of(rest) > columns) {
        const std::size_t first_word = rest.find(' ', rest.find_first_not_of(' '));
        const std::size_t full = clipped(rest, columns).size();
        const std::size_t blank = rest.rfind(' ', text.empty() && first_break > 0 ? first_break : full);
        if (blank == std::string::npos || blank < first_word) {
            break; // a word longer than a line
        }
        text += rest.substr(0, rest.find_last_not_of(' ', blank) + 1) + "\n";
        const std::size_t next = rest.find_first_not_of(' ', blank);
        rest.replace(0, std::min(next, rest.size()), indent, ' ');
    }
    return text + rest;
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

std::string duration_range_text(const run::Range& seconds) {
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

std::string steps_text(const run::Range& steps) {
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

std::size_t columns_of(std::string_view text) {
    std::size_t columns = 0;
    for (std::size_t at = 0; at < text.size(); at = after_character(text, at)) {
        columns += text[at] == escape ? 0 : 1;
    }
    return columns;
}

std::string clipped(std::string_view text, std::size_t columns) {
    std::size_t taken = 0, at = 0;
    for (; at < text.size(); at = after_character(text, at)) {
        if (text[at] != escape && taken++ == columns) {
            break;
        }
    }
    return std::string(text.substr(0, at));
}

std::string folded(std::string_view text, std::size_t columns) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        out += folded_line(text.substr(at, end - at), columns);
        out += end < text.size() ? "\n" : "";
        at = end + 1;
    }
    return out;
}

} // namespace suffuse::apps
