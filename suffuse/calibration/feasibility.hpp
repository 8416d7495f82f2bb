#pragma once
// Where in the unit cube a simulation succeeds, from where it did and where it failed: the share of successes among
// runs nearby, as if a tenth of a success were everywhere.

#include "suffuse/calibration/sobol.hpp"

#include <vector>

namespace suffuse::calibration {

class Feasibility {
public:
    Feasibility(std::vector<Point> succeeded, std::vector<Point> failed);

    /// 1 far from failures, and at least 0.2.
    [[nodiscard]] double chance(const Point& point) const;

private:
    std::vector<Point> succeeded_, failed_;
};

} // namespace suffuse::calibration
