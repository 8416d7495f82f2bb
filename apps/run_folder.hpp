#pragma once
// The folder of a run as the command line sees it: its name, what was asked when it began, and that one program at a
// time works in it.

#include "apps/command_line.hpp"
#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::apps {

/// What was asked when a run began; kept beside it as run_options.json.
struct AskedRun {
    std::string case_file; ///< absolute
    std::string preset;
    std::vector<std::string> overrides;
};

/// Makes runs/NAME-0001, or the next free number; NAME is the folder of the case.
std::filesystem::path make_run_folder(const std::filesystem::path& case_file);

/// Makes `folder`, or takes one that a run began. @throws UsageError for one that holds something else.
void take_run_folder(const std::filesystem::path& folder);

void keep_asked(const std::filesystem::path& folder, const AskedRun& asked);

/// @throws UsageError where no run began in `folder`.
AskedRun read_asked(const std::filesystem::path& folder);

/// Holds the folder for this program. @throws UsageError where another one works in it.
class FolderLock {
public:
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int descriptor_ = -1;
};

} // namespace suffuse::apps
