#pragma once
// The names that a case gives to its soils, studies, stages and presets.

#include "suffuse/casefile/reader.hpp"

namespace suffuse::casefile {

/// Letters, digits, - and _, and points within: names become folders. Reports others.
bool check_name(ReadContext& context, const std::string& what, const std::string& name, const Place& place);

/// Of a stage, whose folder is among files of the sample.
bool check_stage_name(ReadContext& context, const std::string& name, const Place& place);

} // namespace suffuse::casefile
