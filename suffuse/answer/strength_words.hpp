#pragma once
// The change of strength as the report shows it: sentences of the answer, a number for the eye, a table.

#include "suffuse/answer/headlines.hpp"
#include "suffuse/figures/page_table.hpp"
#include "suffuse/study/strength_change.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::answer {

/// One for each change while these are few, else one for all.
std::vector<std::string> strength_sentences(const std::vector<study::StrengthChange>& changes);

/// Of the first change that a number can express; nothing where there is none, or where there are too many for one
/// of them to stand for all.
std::optional<Headline> strength_headline(const std::vector<study::StrengthChange>& changes);

/// A row for each change; nothing without one.
std::optional<figures::PageTable> tabulate_strength(const std::vector<study::StrengthChange>& changes);

} // namespace suffuse::answer
