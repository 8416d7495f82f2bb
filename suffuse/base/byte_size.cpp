#include "suffuse/base/byte_size.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/base/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace suffuse {
namespace {

constexpr std::array<std::pair<std::string_view, double>, 9> byte_units{
    {{"B", 1},
     {"kB", 1e3},
     {"MB", 1e6},
     {"GB", 1e9},
     {"TB", 1e12},
     {"KiB", 1024.0},
     {"MiB", 1024.0 * 1024},
     {"GiB", 1024.0 * 1024 * 1024},
     {"TiB", 1024.0 * 1024 * 1024 * 1024}}};

/// The unit that was meant by "mb", "K" or "gib"; none for what is like none of them.
std::optional<std::string_view> meant_unit(std::string_view text) {
    const auto begins = [&](std::string_view name) {
        return text.size() <= name.size() && std::equal(text.begin(), text.end(), name.begin(), [](char a, char b) {
                   return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
               });
    };
    const auto found = std::ranges::find_if(byte_units, [&](const auto& unit) { return begins(unit.first); });
    return text.empty() || found == byte_units.end() ? std::nullopt : std::optional(found->first);
}

} // namespace

double parse_byte_size(std::string_view text) {
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(text.data(), end, number);
    if (problem == std::errc() && end - stop > 1 && *stop == ',' &&
        std::isdigit(static_cast<unsigned char>(stop[1])) != 0) {
        std::string with_point(text);
        with_point[static_cast<std::size_t>(stop - text.data())] = '.';
        std::string advice = "write a decimal point, as in " + with_point;
        try {
            parse_byte_size(with_point);
        } catch (const UnitError& further) {
            advice = further.help;
        }
        throw UnitError(
            UnitError::Kind::Malformed, fmt::format("{} has a decimal comma", shown(std::string(text))),
            std::move(advice)
        );
    }
    if (problem != std::errc() || !std::isfinite(number) || !(number > 0)) {
        throw UnitError(
            UnitError::Kind::NoNumber, fmt::format("{} is no amount of memory", shown(std::string(text))),
            "write it as in 16GB"
        );
    }
    std::string_view unit(stop, static_cast<std::size_t>(end - stop));
    unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
    for (const auto& [name, bytes] : byte_units) {
        if (unit == name) {
            return number * bytes;
        }
    }
    throw UnitError(
        unit.empty() ? UnitError::Kind::NoUnit : UnitError::Kind::UnknownUnit,
        unit.empty() ? fmt::format("{} has no unit", text)
                     : fmt::format("{} is no unit of memory", shown(std::string(unit))),
        fmt::format(
            "write {}{}; there are B, kB, MB, GB, TB, KiB, MiB, GiB and TiB", number, meant_unit(unit).value_or("GB")
        )
    );
}

} // namespace suffuse
