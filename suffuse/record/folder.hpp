#pragma once
// What a run folder holds, and where: names that users' scripts rely on.

#include "suffuse/casefile/case.hpp"
#include "suffuse/record/run_outcome.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::record {

std::filesystem::path
stage_folder(const std::filesystem::path& run, const casefile::Variant& variant, const casefile::Stage& stage);

/// Where an `erode` stage leaves the state after a pass that is not its last.
std::filesystem::path pass_file(const std::filesystem::path& stage_folder, int pass);

/// Where a `migrate` stage keeps its frames, the states on the way, counted from 0.
std::filesystem::path frame_file(const std::filesystem::path& stage_folder, std::size_t frame);

nlohmann::json read_json(const std::filesystem::path& path);
void write_json(const std::filesystem::path& path, const nlohmann::json& json);

/// What write_json writes.
std::string file_text_of(const nlohmann::json& json);

/// Results with many numbers, as CBOR: compact, and to the bit.
nlohmann::json read_cbor(const std::filesystem::path& path);
void write_cbor(const std::filesystem::path& path, const nlohmann::json& json);

/// Makes the folder ready for this case: fresh, or one that the same case began.
/// @throws CaseError when the folder belongs to another case, IoError when it cannot be written.
void open_folder(const std::filesystem::path& run, const casefile::Case& what, const std::string& case_text);

/// The case as it was resolved when the run began: what makes a folder that of a run.
inline constexpr const char* resolved_case_file = "case.resolved.toml";

/// The request when the run began: preset, overrides, studies.
inline constexpr const char* options_file = "run_options.json";

/// @throws IoError where the folder holds no run that has begun.
void check_is_run(const std::filesystem::path& folder);

/// @throws IoError where the folder of a run that works in it has been moved or removed: it must not be made anew.
void check_is_in_place(const std::filesystem::path& run);

/// The user's own case file, which the run began with; empty where the folder does not say.
std::string case_that_began(const std::filesystem::path& run);

/// What `refine` added.
inline constexpr const char* refinement_file = "refinement.json";

/// By what the results were made, and when.
inline constexpr const char* provenance_file = "provenance.json";

/// What the folder of a stage that failed holds instead of its numbers, until it is run again.
inline constexpr const char* failure_file = "failed.json";

/// A stage that is under way, or was stopped: its state, and what its verb needs to go on.
inline constexpr const char* partial_file = "partial.h5";

/// What the tasks of a sweep said, and the one that gathered them, which goes on saying it when all else is done.
inline constexpr const char* tasks_folder = "tasks";

void keep_failure(const std::filesystem::path& run, const FailedSample& failure);

/// The failures that the folder holds, in the order of the samples.
std::vector<FailedSample> read_failures(const std::filesystem::path& run, const casefile::Case& what);

/// Appends one event to events.jsonl.
void log_event(const std::filesystem::path& run, nlohmann::json event);

/// Writes the provenance of a run, or of a sample alone: version, compiler, processor, threads, seed, hash of the
/// resolved case, and every call that worked on it, with their time together.
/// @param command, wall_seconds of this call; @param until the stage that each sample was to end with, if any
void keep_provenance(
    const std::filesystem::path& folder, const casefile::Case& what, const std::string& command, double wall_seconds,
    const std::string& until = {}
);

} // namespace suffuse::record
