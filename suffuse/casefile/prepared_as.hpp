#pragma once
// Samples that take the preparation found for another: `prepared_as` of a compaction.

#include "suffuse/casefile/case.hpp"
#include "suffuse/casefile/reader.hpp"

namespace suffuse::casefile {

/// Whether this sample has more fines than the one that its compaction is to be prepared as, so that it does not search
/// itself.
bool is_prepared_as_another(const Variant& variant, const Stage& stage);

/// The sample whose search decides: of the same seed and the same values of all other swept keys. Null where the sweep
/// has none.
const Variant* sample_to_prepare_by(const Study& study, const Variant& variant, const Stage& stage);

/// The stage of this name; null where the sample has none.
const Stage* find_stage(const Variant& variant, const std::string& name);

/// Every sample that is prepared as another has that other, with the same stage.
void check_prepared_as(ReadContext& context, const Study& study);

} // namespace suffuse::casefile
