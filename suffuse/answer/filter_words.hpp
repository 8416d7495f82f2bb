#pragma once
// Does a filter hold its base? In a sentence, a table, cards, and what makes it doubtful.

#include "suffuse/answer/headlines.hpp"
#include "suffuse/figures/page_table.hpp"
#include "suffuse/record/finished_stage.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::answer {

enum class FilterVerdict {
    Holds,          ///< motion ended at the last gradient, and nothing of the base left
    HoldsAfterLoss, ///< motion ended there, and at most `most_lost` left
    Undecided,      ///< that hold was cut while the base still moved, and no more than that had left
    LetsPass        ///< more than that left
};

/// Of the base's mass: more than that is no filter any more. Our choice; rules name no share.
inline constexpr double most_lost = 0.05;

/// @param lost of the base's mass; @param ended the motion
FilterVerdict judge_filter(double lost, bool ended);

/// "the filter holds after a loss".
std::string_view words_of(FilterVerdict verdict);

/// Stages in which a base migrates into its filter.
std::vector<const record::FinishedStage*> filter_stages(const std::vector<record::FinishedStage>& stages);

/// One sentence a stage of at most 20 words, or one for all where these are many. @pre some stages
std::vector<std::string> filter_verdict(const std::vector<const record::FinishedStage*>& stages);

/// At most three sentences, the largest first, over all stages; each says what would remove it.
std::vector<std::string> filter_doubts(const std::vector<const record::FinishedStage*>& stages);

/// What passed, of the first stages.
std::vector<Headline> filter_headlines(const std::vector<const record::FinishedStage*>& stages);

/// A row a stage; its note answers the question and names the two largest doubts.
std::optional<figures::PageTable> tabulate_filters(const std::vector<record::FinishedStage>& stages);

} // namespace suffuse::answer
