#pragma once
// [[study.NAME.stage]]: the stages of a study in their order, and which of them starts from which.

#include "suffuse/casefile/reader.hpp"
#include "suffuse/casefile/writer.hpp"

#include <string>
#include <vector>

namespace suffuse::casefile {

/// The key `stage` of a study, with the parents of its stages; what is wrong with them is reported.
std::vector<Stage> read_stages(ReadContext& context, Reader& study);

std::vector<std::string> names_of(const std::vector<Stage>& stages);

/// The table of one stage; stages of `default_spec` feed the schema's defaults.
Node write_stage(const Stage& stage);

/// A stage that has every default, by its verb.
StageSpec default_spec(std::size_t verb);

} // namespace suffuse::casefile
