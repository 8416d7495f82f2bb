#pragma once
// The state of a run in HDF5, to the last bit: what the next step depends on and nothing else. Contacts that do not
// touch are left out, as they carry no memory. Plain names (`grains/position`), SI units, and a `unit` at each array.

#include "suffuse/dem/world.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::io {

/// Texts that travel with a state: the stage that it is of.
using Attributes = std::map<std::string, std::string>;

struct Checkpoint {
    dem::World world;
    Attributes attributes;
    std::vector<std::uint8_t> unfinished; ///< of a state in the middle of a stage: what its verb needs to go on
    bool is_hashed = false; ///< whether the file held its SHA-256 and met it; those of earlier versions hold none
};

/// Saves a state under `path`, in full or not at all (IoError). Attribute names hold no '/', texts no zero byte.
/// @param made_by where the state comes from, beyond program, commit and seed: short texts at the root of the file,
/// for those who find it alone; they are no part of the state
void save_world(
    const std::filesystem::path& path, const dem::World& world, const Attributes& attributes = {},
    const Attributes& made_by = {}, std::span<const std::uint8_t> unfinished = {}
);

/// Loads what `save_world` wrote. Throws IoError where the file is not such a state, is damaged or of another schema.
Checkpoint load_world(const std::filesystem::path& path);

/// What `made_by` of `save_world` said under this name; empty where it said nothing, or the file is no whole state.
std::string origin_of(const std::filesystem::path& path, const std::string& name);

/// The bytes of the file that `save_world` would write, for another process.
std::string world_to_bytes(const dem::World& world);

/// @throws IoError as `load_world`
dem::World world_from_bytes(std::string_view bytes);

} // namespace suffuse::io
