#include "suffuse/base/byte_size.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/base/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
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

} // namespace

double parse_byte_size(std::string_view text) {
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(text.data(), end, number);
    if (problem != std::errc() || !std::isfinite(number) || !(number > 0)) {
        throw UnitError(fmt::format("{} is no amount of memory", shown(std::string(text))), "write it as in 16GB");
    }
    std::string_view unit(stop, static_cast<std::size_t>(end - stop));
    unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
    for (const auto& [name, bytes] : byte_units) {
        if (unit == name) {
            return number * bytes;
        }
    }
    throw UnitError(
        unit.empty() ? fmt::format("{} has no unit", text)
                     : fmt::format("{} is no unit of memory", shown(std::string(unit))),
        fmt::format("write {}GB; there are B, kB, MB, GB, TB, KiB, MiB, GiB and TiB", number)
    );
}

} // namespace suffuse
