#pragma once
// What a compaction takes: its strain at the rate that it begins with, slowed as runs have shown, once or until a
// density is met.

#include "suffuse/packing/compact.hpp"
#include "suffuse/plan/price_stage.hpp"

namespace suffuse::plan {

/// The price of a compaction; `sample` goes from its cloud to the state that is expected.
StagePrice price_compaction(
    const casefile::Case& what, const casefile::Variant& variant, const packing::CompactSpec& spec, PricedSample& sample
);

} // namespace suffuse::plan
