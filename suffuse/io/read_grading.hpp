#pragma once
// A grading curve from a CSV file: columns `d [mm]` and `passing [%]` by mass, `#` starts a comment; grading_csv.hpp
// says what else is read. Sizes may rise or fall from line to line, but not both.

#include "suffuse/grains/soil.hpp"
#include "suffuse/io/grading_csv.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace suffuse::io {

/// Grains are drawn from a curve that runs from 0 to 100 %; criteria may be asked of one that does not.
enum class CurveEnds { Closed, MayBeOpen };

/// The curve through the points, sizes rising; reports each point that breaks the rules of a grading and is empty then.
/// `whole` is the place of a problem of the curve as a whole.
std::optional<grains::Grading> make_grading(
    std::vector<GradingPoint> points, const std::string& origin, const Place& whole, Problems& problems,
    CurveEnds ends = CurveEnds::Closed
);

/// Reads the text of a CSV file; all its problems are reported.
std::optional<grains::Grading>
parse_grading(const std::shared_ptr<const Source>& source, Problems& problems, CurveEnds ends = CurveEnds::Closed);

/// Reads a file. Throws CaseProblems, or IoError where it cannot be read.
grains::Grading read_grading(const std::string& path, CurveEnds ends = CurveEnds::Closed);

} // namespace suffuse::io
