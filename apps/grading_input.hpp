#pragma once
// Gradings that a user names on the command line: files, or - for standard input. Remarks say how they were
// understood.

#include "suffuse/gradings/read_grading.hpp"

#include "apps/console.hpp"
#include "apps/options.hpp"
#include <string>

namespace suffuse::apps {

inline constexpr const char* grading_text =
    "a grading: CSV with the columns d [mm], passing [%], or as laboratories write them; - for standard input";

/// Flags that say how a file is read.
struct ReadingFlags : gradings::ReadingOptions {
    /// @param help the line of the help for all of them; empty: none
    void add_to(Options& options, const std::string& help);
};

/// The curves of a file, of several samples that named `sample`, where it is not empty.
gradings::GradingFile
read_gradings_of(const std::string& path, const std::string& sample, const gradings::ReadingOptions& options = {});

/// The one curve that the file holds or `sample` names. @throws CaseError where there are several, with the flag that
/// names one.
gradings::GradingFile read_one_grading(
    const std::string& path, const std::string& sample, const gradings::ReadingOptions& options = {},
    const char* flag = "--sample"
);

inline constexpr const char* filter_sample_flag = "--filter-sample";

/// Which columns were read as what, and the points, soil by soil.
std::string shown_reading(const gradings::GradingFile& file);

/// A line for each remark.
void print_remarks(const gradings::GradingFile& file, const Console& console);

/// "dyke.csv:9: `Pan` is what passed the finest sieve".
std::string remark_text(const Diagnostic& remark);

} // namespace suffuse::apps
