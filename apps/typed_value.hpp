#pragma once
// Quantities as they are typed on the command line.

#include "suffuse/base/units.hpp"
#include "suffuse/base/vec3.hpp"
#include "suffuse/io/cut_box.hpp"
#include "suffuse/stability/flow_way.hpp"

#include <optional>
#include <string>

namespace suffuse::apps {

/// A number in SI, or a text with its unit. @throws UsageError, naming the flag.
double quantity_of(const std::string& text, Dimension dimension, const std::string& flag, bool bare_is_si);

/// Which way the water goes; nothing for an empty text. @throws UsageError, naming the flag.
std::optional<stability::FlowWay> flow_way_of(const std::string& text, const std::string& flag);

/// Edges "LX,LY,LZ" or nine numbers by rows, in meters or with units -> cell matrix [m]. @throws UsageError.
Mat3 cell_of(const std::string& text);

/// Corners "X1,Y1,Z1,X2,Y2,Z2", in meters or with units. @throws UsageError.
io::Box box_of(const std::string& text);

} // namespace suffuse::apps
