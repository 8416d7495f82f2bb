#include "suffuse/stability/flow_way.hpp"

#include "suffuse/base/constants.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace suffuse::stability {
namespace {

constexpr std::array<std::pair<std::string_view, FlowWay>, 3> named_ways{
    {{"up", upward}, {"down", downward}, {"level", level_flow}}};

} // namespace

std::string name_of(const FlowWay& way) {
    for (const auto& [name, named] : named_ways) {
        if (way == named) {
            return std::string(name);
        }
    }
    return fmt::format("{:g}deg", way.rise);
}

std::string_view kind_of(const FlowWay& way) {
    return way == upward       ? "upward"
           : way == downward   ? "downward"
           : way == level_flow ? "level"
           : way.rise > 0      ? "rising"
                               : "sinking";
}

std::optional<FlowWay> flow_way_of(std::string_view word) {
    for (const auto& [name, way] : named_ways) {
        if (word == name) {
            return way;
        }
    }
    constexpr std::string_view unit = "deg";
    if (word.ends_with(unit)) {
        word.remove_suffix(unit.size());
    }
    while (word.ends_with(' ')) {
        word.remove_suffix(1);
    }
    double rise = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), rise);
    const bool is_angle = error == std::errc() && end == word.data() + word.size() && std::abs(rise) <= 90;
    return is_angle ? std::optional(FlowWay{rise}) : std::nullopt;
}

double lift_of(const FlowWay& way) {
    return way == upward ? 1 : way == level_flow ? 0 : way == downward ? -1 : std::sin(way.rise * pi / 180);
}

} // namespace suffuse::stability
