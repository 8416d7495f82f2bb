#pragma once
// From points to a curve: sizes rising, percent passing never falling. A sieve analysis and a hydrometer's are joined,
// digitizing noise is smoothed, both reported; all else that breaks the rules of a grading is an error.

#include "suffuse/base/diagnostics.hpp"
#include "suffuse/grains/soil.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::gradings {

/// One point of a curve and where it was written.
struct GradingPoint {
    double diameter = 0; ///< [m]
    double passing = 0;  ///< [-]
    Place diameter_place, passing_place;
    bool has_unit = false; ///< the size was written with its unit: it means what it says
};

/// Grains are drawn from a curve that runs from 0 to 100 %; criteria may judge one that does not.
enum class CurveEnds { Closed, MayBeOpen };

/// The curve through the points; reports each point that breaks the rules of a grading and is empty then. `whole` is
/// the place of a problem of the curve as a whole.
std::optional<grains::Grading> make_grading(
    std::vector<GradingPoint> points, const std::string& origin, const Place& whole, Problems& problems,
    CurveEnds ends = CurveEnds::Closed
);

} // namespace suffuse::gradings
