#pragma once
// Which fines the water carries out, in sentences, cards and a table, and what makes it doubtful.

#include "suffuse/answer/doubt.hpp"
#include "suffuse/answer/headlines.hpp"
#include "suffuse/figures/page_table.hpp"
#include "suffuse/record/finished_stage.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::answer {

using FinishedStages = std::vector<const record::FinishedStage*>;

/// Stages in which fines of one soil migrate: of a stack see filter_words.hpp.
FinishedStages migration_stages(const std::vector<record::FinishedStage>& stages);

/// One sentence a stage of at most 20 words, or two for all where these are many. @pre some stages
std::vector<std::string> migration_verdict(const FinishedStages& stages);

/// At most three sentences, the largest first, over all stages; each says what would remove it.
std::vector<std::string> migration_doubts(const FinishedStages& stages);

/// What left, of the first stages.
std::vector<Headline> migration_headlines(const FinishedStages& stages);

/// A row a gradient.
std::optional<figures::PageTable> tabulate_migrations(const std::vector<record::FinishedStage>& stages);

/// @pre `stage` is a migration, as below
const erosion::MigrationResult& migration_of(const record::FinishedStage& stage);

/// The hold that ended it.
const erosion::MigrationHold& last_hold(const record::FinishedStage& stage);

/// Permeability of the last flow over that of the first.
double permeability_change(const record::FinishedStage& stage);

/// Where motion had not ended in one of these migrations, of a stack or not.
void doubt_end(const FinishedStages& stages, std::vector<Doubt>& doubts);

/// Where grains that moved overlapped by too much. @param remedy what mends that: the end of a sentence
void doubt_overlap(const FinishedStages& stages, const std::string& remedy, std::vector<Doubt>& doubts);

} // namespace suffuse::answer
