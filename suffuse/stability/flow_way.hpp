#pragma once
// Which way water seeps through a soil that has weight.

#include <array>
#include <optional>
#include <string_view>

namespace suffuse::stability {

enum class FlowWay { Up, Down, Level };

inline constexpr std::array flow_ways{FlowWay::Up, FlowWay::Down, FlowWay::Level};

/// "up", "down", "level".
inline const char* name_of(FlowWay way) {
    return way == FlowWay::Up ? "up" : way == FlowWay::Down ? "down" : "level";
}

/// Nothing for other words.
inline std::optional<FlowWay> flow_way_of(std::string_view word) {
    for (const FlowWay way : flow_ways) {
        if (word == name_of(way)) {
            return way;
        }
    }
    return std::nullopt;
}

} // namespace suffuse::stability
