#pragma once
// A figure as it stands in the page: title, chart or drawing, our own number with that of the paper, caption, files,
// numbers.

#include "suffuse/report/numbering.hpp"
#include "suffuse/report/page.hpp"

namespace suffuse::report {

/// What a figure's files say of where they come from.
std::vector<std::pair<std::string, std::string>> csv_remarks(const figures::Figure& figure, const ReportData& report);

/// The drawing as a file of its own, which says where it comes from as the CSV of its numbers does.
std::string with_metadata(const figures::Figure& figure, const ReportData& report);

std::string figure_block(const figures::Figure& figure, const ReportData& report, Numbering& numbering);

/// A table at the head of a section, its title and note as its caption.
std::string table_block(const figures::PageTable& table, Numbering& numbering);

} // namespace suffuse::report
