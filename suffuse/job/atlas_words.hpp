#pragma once
// The answer of the atlas as people read it: a heading, a line for each density, and how far to trust them.

#include "suffuse/figures/page_table.hpp"
#include "suffuse/job/atlas_answer.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::job {

struct AtlasWords {
    std::string heading; ///< the soil as two parts; or why the atlas has no answer
    std::optional<figures::PageTable> table;
    std::vector<std::string> notes; ///< what the gradient moves, errors, sifting: sentences without capital and point
};

AtlasWords atlas_words(const AtlasAnswer& answer, const stability::Seepage& seepage);

/// As lines for a terminal, each indented.
std::string text_of(const AtlasWords& words);

} // namespace suffuse::job
