#pragma once
// What a reader of the report meets first: the answer in sentences and numbers, what to beware of, and, where the case
// follows a paper, how its findings fared.

#include "suffuse/report/page.hpp"

#include <string>

namespace suffuse::report {

/// HTML of the section without its heading.
std::string answer_content(const ReportData& report);

/// That stages are missing, and how to go on, for the top of the page; empty where the run is complete.
std::string unfinished_banner(const Unfinished& unfinished);

} // namespace suffuse::report
