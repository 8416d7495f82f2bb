#pragma once
// The state of a run in HDF5, to the last bit: what the next step depends on and nothing else. Contacts that do not
// touch are left out, as they carry no memory. Plain names (`grains/position`), SI units, and a `unit` at each array.

#include "suffuse/dem/world.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace suffuse::io {

/// Texts that travel with a state: the resolved case, the position within the stage.
using Attributes = std::map<std::string, std::string>;

struct Checkpoint {
    dem::World world;
    Attributes attributes;
};

/// Saves a state under `path`, in full or not at all (IoError). Attribute names hold no '/', texts no zero byte.
/// @param made_by where the state comes from, beyond program, commit and seed: short texts at the root of the file,
/// for those who find it alone; they are no part of the state
void save_world(
    const std::filesystem::path& path, const dem::World& world, const Attributes& attributes = {},
    const Attributes& made_by = {}
);

/// Loads what `save_world` wrote. Throws IoError where the file is not such a state, is damaged or of another schema.
Checkpoint load_world(const std::filesystem::path& path);

} // namespace suffuse::io
