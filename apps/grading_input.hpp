#pragma once
// Gradings that a user names on the command line: files, or - for standard input. Remarks say how they were
// understood.

#include "suffuse/gradings/read_grading.hpp"

#include "apps/console.hpp"
#include <string>

namespace suffuse::apps {

inline constexpr const char* grading_text =
    "a grading: CSV with the columns d [mm], passing [%], or as laboratories write them; - for standard input";

/// The curves of a file, of several samples that named `sample`, where it is not empty.
gradings::GradingFile read_gradings_of(const std::string& path, const std::string& sample);

/// The one curve that the file holds or `sample` names. @throws CaseError where there are several.
gradings::GradingFile read_one_grading(const std::string& path, const std::string& sample);

/// A line for each remark.
void print_remarks(const gradings::GradingFile& file, const Console& console);

/// "dyke.csv:9: `Pan` is what passed the finest sieve".
std::string remark_text(const Diagnostic& remark);

} // namespace suffuse::apps
