#pragma once
// SHA256SUMS of a run folder, as sha256sum writes and checks it: every file of the results, and what became of them.
// What goes on changing is left out: the log of events, the progress, the working files of stages under way.

#include "suffuse/run/missing_stages.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::run {

inline constexpr const char* checksums_file = "SHA256SUMS";

/// Writes it. @throws IoError.
void write_checksums(const std::filesystem::path& run);

/// A file that is not as it was, or a number that its state contradicts.
struct Damage {
    std::string file; ///< below the run folder
    std::string what; ///< in words
};

struct Verification {
    int files = 0;  ///< checked
    int states = 0; ///< read, and hashed anew
    std::vector<Damage> damages;
    std::vector<std::string> more; ///< files that came after the checksums
    MissingStages missing;         ///< stages that the case has and the folder has not
};

/// Checks every file against its checksum, and every state against the hash that its stage.json tells.
/// @throws IoError where the folder is no run, or its run was interrupted
Verification verify_run(const std::filesystem::path& run);

void to_json(nlohmann::json& json, const Verification& found);

} // namespace suffuse::run
