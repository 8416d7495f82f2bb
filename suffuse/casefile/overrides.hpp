#pragma once
// Changes of the tree before it is bound: presets, --set, and the values of sweeps. What they set keeps the place where
// it was written, so that a bad value is reported there.

#include "suffuse/base/diagnostics.hpp"
#include "suffuse/casefile/node.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::casefile {

/// Applies [presets.NAME]; "standard" needs no table and is the case as written. `preset_place` is where the name is.
/// @param weighs fines have weight: what a preset says of probes without it is passed over
void apply_preset(Node& root, const std::string& name, const Place& preset_place, bool weighs, Problems& problems);

/// Applies "study.erosion.stage.erosion.gradient=0.1"; stages are found by their names.
void apply_override(Node& root, const std::string& text, Problems& problems);

/// Whether an override is about presets, "presets.quick.particles=4000" or "preset=quick", and so comes before them.
bool sets_preset(const std::string& text);

/// Whether an override gives fines weight, "gravity.down=-z".
bool sets_gravity(const std::string& text);

/// Reports an override of a preset that is not in force: it would change nothing.
void check_preset_override(const std::string& text, const std::string& in_force, Problems& problems);

/// Reports an override of a key that all studies it is for set in their `sweep` or `rows`: it would change nothing.
void check_swept_override(const Node& root, const std::string& text, Problems& problems);

/// Leaves out the studies that are not among `names`; without names, none.
void keep_studies(Node& root, const std::vector<std::string>& names, Problems& problems);

/// What a swept key changes: the study, its soil, or the contact law.
struct SweepTarget {
    Node& study;
    Node* soil;    ///< null where the study has none
    Node& contact; ///< [contact] as this study has it
};

/// Sets one value of a sweep; false where none of them has such a key.
bool apply_sweep_value(SweepTarget target, const std::string& key, const Node& value);

/// Sets the key at the end of `path`; says what is missing on the way, nothing where all went well.
std::optional<std::string>
set_at(Node& table, const std::vector<std::string>& path, const Node& value, const Place& place);

} // namespace suffuse::casefile
