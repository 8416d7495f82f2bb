#pragma once
// The first section of the page, the answer in one look: verdict, how sure it is, cards, the deciding picture, what
// disagrees; the rest folded.

#include "suffuse/report/numbering.hpp"
#include "suffuse/report/page.hpp"

#include <string>
#include <vector>

namespace suffuse::report {

/// Whether the sample before and after is the deciding picture.
bool shows_grains(const ReportData& report);

/// The figures that stand in the first section, and nowhere else.
std::vector<const figures::Figure*> opening_figures(const ReportData& report);

/// HTML of the section without its heading.
std::string answer_content(const ReportData& report, Numbering& numbering);

/// What stands before everything else in the page of a run that is not complete; else empty.
std::string unfinished_banner(const Unfinished& unfinished);

} // namespace suffuse::report
