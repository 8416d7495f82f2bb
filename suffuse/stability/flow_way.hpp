#pragma once
// Which way water seeps through a soil that has weight.

#include <optional>
#include <string>
#include <string_view>

namespace suffuse::stability {

struct FlowWay {
    double rise = 90; ///< angle by which the water rises, negative where it sinks [degrees]

    friend bool operator==(const FlowWay&, const FlowWay&) = default;
};

inline constexpr FlowWay upward{90}, level_flow{0}, downward{-90};

inline constexpr std::string_view flow_ways_text =
    "up, down, level, or the angle by which the water rises, as in 30deg";

/// "up", "down", "level", "30deg".
std::string name_of(const FlowWay& way);

/// The adjective: "upward", "downward", "level", "rising" or "sinking".
std::string_view kind_of(const FlowWay& way);

/// Of such words, or of an angle from -90 to 90 degrees; nothing for others.
std::optional<FlowWay> flow_way_of(std::string_view word);

/// The upward part of one unit of the flow [-].
double lift_of(const FlowWay& way);

} // namespace suffuse::stability
