#pragma once
// What the atlas of filters says of a base on a filter: linear in the logarithms of D15/d85 and of the base's own
// d85/d15, within the cells whose corners all exist. It never extrapolates.

#include "suffuse/atlas/filter_row.hpp"
#include "suffuse/atlas/value.hpp"

#include <optional>
#include <vector>

namespace suffuse::atlas {

/// Samples of one ratio, width and gradient, which differ in their seed alone; or what is interpolated between such.
struct FilterNode {
    double ratio = 0, width = 0; ///< [-]
    Value passed;                ///< a lower bound where motion had not ended in all samples [-]
    double moving = 0;           ///< mean [-]
    bool ended = false;          ///< in all samples
    std::vector<FilterRow> rows; ///< all that it rests on
};

struct FilterFound {
    double gradient = 0;
    std::optional<FilterNode> node; ///< nothing outside
    bool is_interpolated = false;
    FilterNode nearest; ///< the node itself where it is inside
};

/// For each gradient of the atlas, rising. A base narrower than all of the atlas counts as its narrowest.
std::vector<FilterFound> look_up_filter(const std::vector<FilterRow>& rows, double ratio, double width);

/// Root of the mean square of what nodes that are left out differ from what their neighbors say, of the base's mass;
/// nothing where no node could be left out [-].
std::optional<double> error_of_filters(const std::vector<FilterRow>& rows, double gradient);

} // namespace suffuse::atlas
