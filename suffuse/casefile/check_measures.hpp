#pragma once
// Whether a stage can measure what its key `measure` requests.

#include "suffuse/casefile/case.hpp"
#include "suffuse/casefile/reader.hpp"

namespace suffuse::casefile {

/// Reports measures that the stage's verb has not, with those that it has.
void check_measures(ReadContext& context, const Stage& stage, const Node& item);

} // namespace suffuse::casefile
