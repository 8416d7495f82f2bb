#pragma once
// Grading curves out of what laboratories and site investigations keep: docs/gradings.md lists what is understood. The
// text (sheet_text) is cut into cells (sheet) and these into tables (sheet_tables, turned_table); the columns of each
// are found (grading_columns), its rows read (grading_rows), turned into percent passing (grading_shares), joined
// (grading_tables) and checked (grading_curve, check_derived). Remarks say how a sheet was understood; what
// could mean two things is refused.

#include "suffuse/gradings/grading_curve.hpp"
#include "suffuse/gradings/reading_options.hpp"
#include "suffuse/grains/soil.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace suffuse::gradings {

struct NamedGrading {
    std::string name;   ///< of the sample; empty where the file has one alone
    std::string sample; ///< likewise, but also where it is alone; empty where the file names none
    grains::Grading grading;
    SheetReading reading;
};

/// All curves of a text; empty where something is wrong, all of which is reported. Remarks are warnings. The first
/// error has the options that read the text, where some do.
std::vector<NamedGrading> parse_gradings(
    const std::shared_ptr<const Source>& source, Problems& problems, CurveEnds ends = CurveEnds::Closed,
    const ReadingOptions& options = {}
);

/// The one curve of a text; several are an error that names them.
std::optional<grains::Grading> parse_grading(
    const std::shared_ptr<const Source>& source, Problems& problems, CurveEnds ends = CurveEnds::Closed,
    const ReadingOptions& options = {}
);

/// The curves of a file and how it was understood.
struct GradingFile {
    std::vector<NamedGrading> soils;
    std::vector<Diagnostic> remarks;
};

/// Reads a file; of several samples that named `sample`, or all. Throws CaseProblems, or IoError where it cannot be
/// read.
GradingFile read_gradings(
    const std::shared_ptr<const Source>& source, CurveEnds ends, const std::string& sample = {},
    const ReadingOptions& options = {}
);

/// Reads a file that holds one curve. Throws as read_gradings().
grains::Grading
read_grading(const std::string& path, CurveEnds ends = CurveEnds::Closed, const ReadingOptions& options = {});

} // namespace suffuse::gradings
