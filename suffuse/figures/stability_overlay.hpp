#pragma once
// Many soils on one page: their grading curves over each other, and what each criterion says of each.

#include "suffuse/figures/figure.hpp"
#include "suffuse/figures/page_table.hpp"
#include "suffuse/stability/assess.hpp"

#include <string>
#include <vector>

namespace suffuse::figures {

struct NamedAssessment {
    std::string name;
    const stability::Assessment* assessment = nullptr;
};

/// A row for each soil, a column for each counted criterion: verdict and number.
PageTable stability_matrix(const std::vector<NamedAssessment>& soils);

/// The measured curves in one chart, those that most criteria call unstable in another color. [id
/// own-stability-overlay]
Figure stability_overlay(const std::vector<NamedAssessment>& soils);

/// A soil and its filter in one chart. @param verdict the caption [id own-stability-filter]
Figure filter_overlay(const NamedAssessment& soil, const NamedAssessment& filter, const std::string& verdict);

} // namespace suffuse::figures
