#pragma once
// `do = "import"`: a packing brought from elsewhere.

#include "suffuse/base/vec3.hpp"

#include <optional>
#include <string>

namespace suffuse::casefile {

struct ImportSpec {
    std::string path;                  ///< of the packing file, absolute
    std::string contacts;              ///< file of what its contacts remember, absolute; empty: nothing
    Mat3 cell = {};                    ///< columns are the cell vectors [m]; zeros: the file's own
    double unit = 1;                   ///< what a length of 1 in the file stands for [m]
    std::optional<double> radius = {}; ///< of all grains, for a file that has none [m]
    std::optional<Mat3> velocity_gradient =
        {};                   ///< that the file's velocities contain; found in them unless given [1/s]
    double max_overlap = 0.1; ///< largest overlap that is accepted / radius of the smaller grain [-]
    std::string place;        ///< where the case names it, "case.toml:31:11", for messages
};

} // namespace suffuse::casefile
