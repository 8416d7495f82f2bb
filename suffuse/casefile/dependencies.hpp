#pragma once
// What a stage's result follows from, besides the state it starts from: for a cache that must not mix results up.

#include "suffuse/casefile/case.hpp"

#include <string>

namespace suffuse::casefile {

/// Mode of the steps, material, damping, balance, seed and the stage itself with every default; the soil where grains
/// are made or marked, the fluid where water flows, and what [output] makes a stage leave. Names of stages and studies
/// are left out, and so is the path of an imported packing: the file's content counts, and the caller adds it. The text
/// is TOML.
std::string dependencies_of(const Case& c, const Variant& variant, const Stage& stage);

} // namespace suffuse::casefile
