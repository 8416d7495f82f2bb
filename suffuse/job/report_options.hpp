#pragma once
// What [report] of a case sets for the figures: which to show, which way dilation points, measured points laid over
// them.

#include "suffuse/casefile/case.hpp"
#include "suffuse/report/page.hpp"

namespace suffuse::job {

/// What cannot be done is warned of in the report: a long run ends with its report all the same.
void apply_report_options(const casefile::ReportSpec& spec, report::ReportData& data);

} // namespace suffuse::job
