#pragma once
// The program itself, called for each request as from a terminal: what a hostile file could do to a reader ends with
// that call, and all answers are those of the command line.

#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <string>
#include <sys/types.h>
#include <vector>

namespace suffuse::studio {

struct ProgramCall {
    int code = -1;                 ///< minus the signal that ended it
    nlohmann::json document;       ///< on standard output; null where it is no JSON
    std::vector<std::string> talk; ///< lines on standard error
};

/// Calls `suffuse words... --json` in a folder, and waits for it. It is ended after the time limit.
ProgramCall call_program(
    const std::vector<std::string>& words, const std::filesystem::path& folder,
    std::chrono::seconds limit = std::chrono::seconds(120)
);

/// Starts `suffuse words...` in a folder, in a session of its own, which outlives this program; its words go to `log`.
pid_t start_program(
    const std::vector<std::string>& words, const std::filesystem::path& folder, const std::filesystem::path& log
);

/// A private folder, removed with this.
class ScratchFolder {
public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace suffuse::studio
