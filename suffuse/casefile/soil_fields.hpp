#pragma once
// [soil.NAME]: gradings from files or written out, and which grains are fine.

#include "suffuse/casefile/reader.hpp"
#include "suffuse/casefile/writer.hpp"

namespace suffuse::casefile {

grains::Soil read_soil(ReadContext& context, const Node& table, const Place& place, const std::string& path);

/// With its gradings written out, so that a resolved case needs no other file.
Node write_soil(const grains::Soil& soil);

} // namespace suffuse::casefile
