#pragma once
// Reads [calibrate].

#include "suffuse/casefile/calibrate_spec.hpp"
#include "suffuse/casefile/reader.hpp"

namespace suffuse::casefile {

/// Every unknown of the samples is in the result: without `fix_void_ratio` also the void ratio of each target.
/// @param entry the table, with its place
CalibrateSpec read_calibrate(ReadContext& context, const Node::Entry& entry);

/// The table with its defaults, and the table of a target with its own.
Node calibrate_defaults();
Node calibrate_target_defaults();

} // namespace suffuse::casefile
