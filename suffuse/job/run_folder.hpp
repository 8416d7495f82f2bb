#pragma once
// The folder of a run as the command line sees it: its name, the request when it began, and that one program at a
// time works in it.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace suffuse::job {

/// The request when a run began; kept next to it as run_options.json.
struct RunRequest {
    std::string case_file; ///< absolute
    std::string preset;
    std::vector<std::string> overrides, studies;
    std::optional<std::string> cache; ///< its folder, empty for none; nothing where the usual one was taken
};

/// Where stages are kept for a run in `folder`: in suffuse-cache next to it, shared by all runs there.
std::filesystem::path cache_next_to(const std::filesystem::path& folder);

/// Makes runs/NAME-0001, or the next free number; NAME is the folder of the case.
std::filesystem::path make_run_folder(const std::filesystem::path& case_file);

/// Makes `folder`, or takes one that a run began. @throws UsageError for one that holds something else.
void take_run_folder(const std::filesystem::path& folder);

/// That `target`, a file or a folder to write, is not one of a run or calibration, nor below its folder. @throws
/// UsageError
void require_outside_runs(const std::filesystem::path& target);

void save_request(const std::filesystem::path& folder, const RunRequest& request);

/// @throws IoError where no run began in `folder`.
RunRequest read_request(const std::filesystem::path& folder);

/// flock without waiting; `kind` is LOCK_SH or LOCK_EX. @return 0, EWOULDBLOCK where another program holds it, or why
/// it cannot be locked at all
int try_lock(int descriptor, int kind);

/// Whether a suffuse works in the folder now; not so where that cannot be known.
bool is_at_work(const std::filesystem::path& folder);

/// Holds the folder for this program; `warn` is called where it cannot be locked. @throws UsageError where another one
/// works in it.
class FolderLock {
public:
    /// Shared: together with other programs that share it, each of which holds a folder in it for itself.
    enum class Kind { Alone, Shared };

    FolderLock(
        const std::filesystem::path& folder, const std::function<void(const std::string&)>& warn,
        Kind kind = Kind::Alone
    );
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int descriptor_ = -1;
};

} // namespace suffuse::job
