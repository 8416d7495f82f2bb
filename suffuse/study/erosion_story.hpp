#pragma once
// What the report says about an erosion: the first stage that eroded a sample with fines and those that follow it, with
// the probes of its study, and the other erosions of that sample.

#include "suffuse/record/finished_stage.hpp"

#include <functional>
#include <vector>

namespace suffuse::study {

/// Where a pass of a story was made.
struct StagePass {
    const record::FinishedStage* stage = nullptr;
    int number = 0;       ///< within the stage, from 1
    bool is_last = false; ///< of the stage
};

using Erosions = std::vector<const record::FinishedStage*>;

struct ErosionStory {
    const record::FinishedStage* eroded = nullptr; ///< null where nothing was eroded
    Erosions chain;                                ///< it, and the stages whose passes follow its own
    std::vector<StagePass> made_in;                ///< each pass of `erosion`
    const record::FinishedStage* probed = nullptr; ///< the stage of the probes; null where there are none
    std::vector<erosion::ProbeResult> probes;
    erosion::DetachSpec probed_by;  ///< the rule that their stage specifies
    erosion::ErosionResult erosion; ///< all passes of the chain
    Erosions others;                ///< from other states of the same sample
};

using Belongs = std::function<bool(const record::FinishedStage&)>;

/// The first erosion, of those that belong, of a sample that has fines, or else the first; null where there is none.
const record::FinishedStage* find_eroded(const std::vector<record::FinishedStage>& stages, const Belongs& belongs);

/// An erosion and those that follow it, one from the other, whatever was done to the sample between them. Where two
/// follow the same one, the first of the case belongs to it, the other is a story of its own. Nothing from null.
Erosions find_chain(const std::vector<record::FinishedStage>& stages, const record::FinishedStage* eroded);

/// The erosions that led to this one, and itself.
Erosions chain_to(const std::vector<record::FinishedStage>& stages, const record::FinishedStage& last);

/// The passes of a chain as those of one erosion.
erosion::ErosionResult passes_of(const Erosions& chain);

/// The first stage, of those that belong, that probed a sample with fines; null where there is none.
const record::FinishedStage* find_probed(const std::vector<record::FinishedStage>& stages, const Belongs& belongs);

ErosionStory find_story(const std::vector<record::FinishedStage>& stages);

} // namespace suffuse::study
