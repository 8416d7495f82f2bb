#pragma once
// SHA256SUMS of a stage: every file that the stage left. It is written just before stage.json, whose checksum it has
// too, and stage.json shows how many files it lists: a finished stage cannot lose its checksums unnoticed. Stages that
// a version before them finished have none, and say so by the want of that number.

#include "suffuse/record/sums.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <vector>

namespace suffuse::record {

/// Whether a file in the folder of a stage is one that the finished stage consists of, but for stage.json and the
/// checksums themselves.
bool is_left_by_stage(const std::filesystem::directory_entry& file);

/// Completes a stage: checksums of all that it left, then stage.json with these numbers.
/// @param known checksums of files that were checked just now
/// @param strange names of files that the stage did not leave: they get no checksum
void seal_stage(
    const std::filesystem::path& folder, nlohmann::json numbers, Sums known = {},
    const std::vector<std::string>& strange = {}
);

/// Checksums of a finished stage, stage.json's included; nothing where a version without them finished it.
/// @throws IoError where they are missing or damaged
std::optional<Sums> read_stage_sums(const std::filesystem::path& folder);

/// What is not as the finished stage left it. Nothing where it has no checksums.
std::optional<std::vector<Damage>>
check_stage(const std::filesystem::path& folder, const ChecksumOf& now = checksum_of);

/// @throws IoError where the file is one of a finished stage, and not as the stage left it
void check_file(const std::filesystem::path& file);

/// What to do about damaged stages, whose folders these are.
std::string advice_for(const std::vector<std::filesystem::path>& folders);

} // namespace suffuse::record
