#pragma once
// How well the atlas interpolates: each node that has a neighbor on either side is left out and predicted from the two,
// which are twice as far apart as those that a soil is between. The real error is therefore rather smaller.

#include "suffuse/atlas/row.hpp"

namespace suffuse::atlas {

/// Relative, root of the mean square; none where no node could be left out.
struct InterpolationError {
    std::optional<double> moves_1, moves_10;
};

/// Of all densities together, along the fines content and along the size ratio.
InterpolationError error_of_interpolation(const std::vector<Row>& rows, Flow flow);

} // namespace suffuse::atlas
