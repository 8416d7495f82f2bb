#pragma once
// The samples of a swept study in a table: what each set of values came to, and which sample to look at.

#include "suffuse/figures/page_table.hpp"
#include "suffuse/flow/fluid.hpp"
#include "suffuse/study/fines_sweep.hpp"
#include "suffuse/study/study_outcome.hpp"

#include <optional>

namespace suffuse::answer {

/// A row for each set of values; nothing for a study of one. @param fines of the same run: its study adds the structure
/// that fines make to the results; may be null
std::optional<figures::PageTable> tabulate_samples(
    const study::StudyOutcome& outcome, const flow::Fluid& fluid, const study::FinesSweep* fines = nullptr
);

} // namespace suffuse::answer
