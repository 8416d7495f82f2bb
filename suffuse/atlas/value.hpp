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

/// What a gradient is at least, of samples some of which may not have reached it.
struct Floor {
    std::optional<double> gradient; ///< none: not known, because of other samples there are upper bounds alone
    bool is_reached = false;        ///< by one sample at least
};

/// @pre some samples
Value over_seeds(const std::vector<double>& samples);

/// Adds a deviation to a weighted sum, which there is none of where one that counts is not known.
void add_weighted(std::optional<double>& sum, const std::optional<double>& deviation, double weight, bool counts);

} // namespace suffuse::atlas
