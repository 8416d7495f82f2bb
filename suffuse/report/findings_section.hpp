#pragma once
// What the paper found and how this run stands to it: the paper's words, our criterion with our numbers marked, this
// run, the verdict, and why.

#include "suffuse/report/numbering.hpp"
#include "suffuse/study/finding.hpp"

#include <string>
#include <vector>

namespace suffuse::report {

/// HTML of the section without its heading.
std::string findings_content(const std::vector<study::Finding>& findings, Numbering& numbering);

} // namespace suffuse::report
