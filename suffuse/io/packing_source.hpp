#pragma once
// The text of a packing, and what is known of it besides.

#include <optional>
#include <string>
#include <string_view>

namespace suffuse::io {

struct PackingSource {
    const std::string& file; ///< its name, for messages
    std::string_view text;
    double density = 2600;             ///< of the grains [kg/m3]
    std::optional<double> radius = {}; ///< of all grains, for a file that has none, in `unit`
    double unit = 1;                   ///< what a length of 1 in the file stands for, where it names no unit [m]
};

} // namespace suffuse::io
