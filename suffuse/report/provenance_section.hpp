#pragma once
// Where a page comes from: the calls that made the run, the program, the case, and how to cite them.

#include "suffuse/report/numbering.hpp"
#include "suffuse/report/page.hpp"

#include <string>

namespace suffuse::report {

/// HTML of the section without its heading. @param notices of the software bundled in the page; may be empty
std::string provenance_content(const ReportData& report, const std::string& notices, Numbering& numbering);

/// "b-0001 · 2026-11-26": the run, and the day on which it ended.
std::string run_and_day(const ReportData& report);

/// The first page of the report in print: title, verdict, who, when, with what; then the sections. @param sections
/// anchor and name
std::string print_cover(const ReportData& report, const std::vector<std::pair<std::string, std::string>>& sections);

/// What stands in the margins of the pages that follow: rules of CSS.
std::string print_margins(const ReportData& report);

} // namespace suffuse::report
