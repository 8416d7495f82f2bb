#pragma once
// Internal stability of a soil as the report shows it: the criteria side by side, the grading with the sizes that they
// read, and the H-F diagram. Our own figures; sizes in mm, shares in %.

#include "suffuse/figures/figure.hpp"
#include "suffuse/figures/figures.hpp"
#include "suffuse/figures/page_table.hpp"
#include "suffuse/stability/filter_between.hpp"

namespace suffuse::figures {

/// Each criterion with its number, limit, verdict, remark and source; critical gradients last.
PageTable stability_table(const stability::Assessment& assessment);

/// Each rule for a filter, with the verdict of all of them. @param filter its name
PageTable filter_table(const stability::FilterCheck& check, const std::string& filter);

/// The grading with d10, d15, d50, d60, d85 and d90, its gap and its fine fraction. [id own-stability-grading]
Figure stability_grading(const stability::Assessment& assessment, GradingAxis axis = GradingAxis::LeftToRight);

/// The shape curve H over F with the limits of Kenney and Lau and of Kezdi. [id own-stability-shape]
Figure stability_shape(const stability::Assessment& assessment);

} // namespace suffuse::figures
