#pragma once
// What a study over the fines content found: sentences for the head of the report, and its table of thresholds.

#include "suffuse/figures/page_table.hpp"
#include "suffuse/study/fines_findings.hpp"
#include "suffuse/study/fines_sweep.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::answer {

/// Of a study over the fines content: about five.
std::vector<std::string> answer_of_fines(const study::FinesSweep& sweep);

/// What the thresholds say, for the report's answer; empty where there are none.
std::string thresholds_sentence(const std::optional<study::FinesResults>& results);

/// The thresholds as a table of the report; nothing where there are none.
std::optional<figures::PageTable> thresholds_table(const std::optional<study::FinesResults>& results);

} // namespace suffuse::answer
