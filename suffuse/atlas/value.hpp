#pragma once
// A number that several samples share.

#include <optional>
#include <vector>

namespace suffuse::atlas {

struct Value {
    double mean = 0;
    std::optional<double> deviation; ///< standard deviation of single samples; none of one sample
    bool is_at_most = false;         ///< an upper bound, as that of one sample at least is
};

/// @pre some samples
Value over_seeds(const std::vector<double>& samples);

} // namespace suffuse::atlas
