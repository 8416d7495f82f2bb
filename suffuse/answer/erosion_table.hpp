#pragma once
// Every erosion of a run next to the others: of each seed, each value swept, each branch of a study.

#include "suffuse/figures/page_table.hpp"
#include "suffuse/record/finished_stage.hpp"

#include <optional>
#include <vector>

namespace suffuse::answer {

/// A row for each erosion; nothing where there are fewer than two, which the page describes in detail.
std::optional<figures::PageTable> tabulate_erosions(const std::vector<record::FinishedStage>& stages);

} // namespace suffuse::answer
