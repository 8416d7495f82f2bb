#pragma once
// Samples of what the unknowns can be, given the data: from the prior, even over the allowed part of the unit cube, to
// the posterior by steps of temperature, each of which weighs, draws and moves all samples [Del Moral, Doucet and Jasra
// 2006]. All random numbers follow from the seed.

#include "suffuse/calibration/sobol.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace suffuse::calibration {

struct PosteriorProblem {
    int dimensions = 1;
    std::function<double(const Point&)> log_likelihood; ///< finite
    std::function<bool(const Point&)> is_allowed = {};  ///< empty: all of the cube is
    double share = 1;                                   ///< of the log likelihood that counts
    std::uint64_t seed = 1;
    int samples = 2000;
};

struct Posterior {
    std::vector<Point> samples; ///< all of the same weight
    double effective = 0;       ///< how many independent ones are worth as much
    Point best;                 ///< the likeliest that was seen
    double best_log_likelihood = 0;
};

/// @throws std::runtime_error where almost no point of the cube is allowed
Posterior sample_posterior(const PosteriorProblem& problem);

} // namespace suffuse::calibration
