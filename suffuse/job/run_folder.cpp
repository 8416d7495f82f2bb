#include "suffuse/job/run_folder.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/io/folders.hpp"
#include "suffuse/io/leftovers.hpp"
#include "suffuse/io/run_tree.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/stored.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <string_view>
#include <sys/file.h>
#include <unistd.h>

namespace suffuse::job {
namespace {

namespace fs = std::filesystem;

const fs::path lock_file = ".lock";

/// Whether a run writes a file of this name into its folder, or into that of a sample.
bool is_written_here(std::string_view name) {
    constexpr std::array<std::string_view, 14> names = {
        "case.toml",  "case.resolved.toml", "run_options.json", "refinement.json", "provenance.json",
        "plan.json",  "progress.json",      "own_rules.json",   "summary.json",    "report.html",
        "report.pdf", "SHA256SUMS",         "tasks.txt",        "sweep.sbatch"};
    return std::ranges::count(names, name) > 0;
}

/// Whether a run writes a file of this name into the folder of a stage.
bool is_written_in_stage(std::string_view name) {
    constexpr std::array<std::string_view, 16> names = {
        "stage.json", "state.h5",     record::partial_file, record::failure_file, "results.cbor", "history.csv",
        "SHA256SUMS", "grains.csv",   "contacts.csv",       "pores.csv",          "throats.csv",  "grain_forces.csv",
        "grains.vtp", "contacts.vtp", "cell.vtp",           "pores.vtu"};
    return std::ranges::count(names, name) > 0;
}

/// Where the run, or a stage, has ended nothing else would.
void remove_leftovers_of_run(const fs::path& run) {
    io::remove_leftovers(run, is_written_here);
    std::error_code error;
    for (fs::recursive_directory_iterator entry(run / "studies", error), end; !error && entry != end;
         entry.increment(error)) {
        if (entry->is_directory(error) && !entry->is_symlink(error)) {
            io::remove_leftovers(entry->path(), is_written_in_stage);
        }
    }
}

/// The number at the end of NAME-0012, or 0.
int number_of(const std::string& folder, const std::string& name) {
    if (folder.rfind(name + "-", 0) != 0) {
        return 0;
    }
    const std::string digits = folder.substr(name.size() + 1);
    const bool is_number = !digits.empty() && digits.size() < 9 &&
                           std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
    return is_number ? std::stoi(digits) : 0;
}

/// A path: text, or the bytes of one that is not UTF-8, so that `resume` finds it.
nlohmann::json path_json(const std::string& path) {
    try {
        nlohmann::json text = path;
        [[maybe_unused]] const std::string valid = text.dump();
        return text;
    } catch (const nlohmann::json::type_error&) {
        return std::vector<std::uint8_t>(path.begin(), path.end());
    }
}

std::string path_of(const nlohmann::json& kept) {
    if (kept.is_string()) {
        return kept.get<std::string>();
    }
    const auto bytes = kept.get<std::vector<std::uint8_t>>();
    return {bytes.begin(), bytes.end()};
}

} // namespace

fs::path make_run_folder(const fs::path& case_file) {
    const std::string name = fs::absolute(case_file).lexically_normal().parent_path().filename().string();
    const std::string stem = name.empty() ? "run" : name;
    const fs::path runs = "runs";
    io::make_folders(runs);
    int last = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(runs)) {
        last = std::max(last, number_of(entry.path().filename().string(), stem));
    }
    // Another run may take the number between looking and making: only the maker of a folder gets it.
    for (;;) {
        const fs::path folder = runs / fmt::format("{}-{:04}", stem, ++last);
        if (io::make_folder(folder)) {
            return folder;
        }
    }
}

fs::path cache_next_to(const fs::path& folder) {
    fs::path plain = (folder / "").lexically_normal().parent_path();
    if (plain.empty() || plain.filename() == ".." || plain.filename() == ".") {
        plain = (fs::absolute(folder) / "").lexically_normal().parent_path();
    }
    return plain.parent_path() / "suffuse-cache";
}

void take_run_folder(const fs::path& folder) {
    if (fs::exists(folder) && !fs::is_directory(folder)) {
        throw UsageError(fmt::format("{} is a file; -o needs a folder", shown(folder.string())));
    }
    io::make_folders(folder);
    const auto is_ours = [](const fs::directory_entry& entry) { // of a run that could not even begin
        return entry.path().filename() == lock_file || io::is_leftover_of(entry.path(), record::options_file);
    };
    const bool is_free = std::all_of(fs::directory_iterator(folder), fs::directory_iterator(), is_ours);
    const bool is_begun = fs::exists(folder / record::options_file) || fs::exists(folder / record::resolved_case_file);
    if (!is_begun && !is_free) {
        throw UsageError(fmt::format(
            "{} is not empty and holds no run; give -o a new folder, so that none of your files are overwritten",
            shown(folder.string())
        ));
    }
}

void require_outside_runs(const fs::path& target) {
    fs::path folder = fs::weakly_canonical(fs::absolute(target)); // which may be a file
    for (; folder != folder.root_path(); folder = folder.parent_path()) {
        std::error_code error;
        if (fs::exists(folder / record::options_file, error) ||
            fs::exists(folder / record::resolved_case_file, error)) {
            throw UsageError(fmt::format(
                "{} would be written into the run folder {}; give another place, so that no result is overwritten",
                shown(target.string()), shown(folder.string())
            ));
        }
    }
}

void save_request(const fs::path& folder, const RunRequest& request) {
    nlohmann::json kept{
        {"case", path_json(request.case_file)},
        {"preset", request.preset},
        {"overrides", request.overrides},
        {"studies", request.studies}};
    if (request.cache) {
        kept["cache"] = path_json(*request.cache);
    }
    record::write_json(folder / record::options_file, kept);
}

RunRequest read_request(const fs::path& folder) {
    if (!fs::exists(folder / record::options_file)) {
        throw IoError(
            fmt::format("{} holds no run to resume; give the folder that suffuse run printed", shown(folder.string()))
        );
    }
    const nlohmann::json request = record::read_json(folder / record::options_file);
    return record::take_from(folder / record::options_file, [&] {
        RunRequest read{
            path_of(request.value("case", nlohmann::json(""))),
            request.value("preset", ""),
            request.value("overrides", std::vector<std::string>{}),
            request.value("studies", std::vector<std::string>{}),
            {}};
        if (request.contains("cache")) {
            read.cache = path_of(request.at("cache"));
        }
        return read;
    });
}

int try_lock(int descriptor, int kind) {
    while (flock(descriptor, kind | LOCK_NB) != 0) {
        if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

bool is_at_work(const fs::path& folder) {
    const int descriptor = open((folder / lock_file).c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) {
        return false;
    }
    const int refused = try_lock(descriptor, LOCK_SH);
    close(descriptor);
    return refused == EWOULDBLOCK;
}

FolderLock::FolderLock(const fs::path& folder, const std::function<void(const std::string&)>& warn, Kind kind) {
    if (const std::string remark = io::look_into_run(folder, io::Purpose::Work); !remark.empty()) {
        warn(remark);
    }
    descriptor_ = open((folder / lock_file).c_str(), O_CREAT | O_RDWR | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
        throw IoError(fmt::format("{}: cannot be written: {}", folder.string(), std::strerror(errno)));
    }
    const int refused = try_lock(descriptor_, kind == Kind::Shared ? LOCK_SH : LOCK_EX);
    if (refused == EWOULDBLOCK) {
        close(descriptor_);
        throw UsageError(fmt::format("another suffuse is at work in {}", shown(folder.string())));
    }
    if (refused != 0) { // some network file systems have no locks
        warn(fmt::format(
            "{} cannot be locked ({}): make sure that no other suffuse works in it", shown(folder.string()),
            std::strerror(refused)
        ));
    }
    remove_leftovers_of_run(folder);
}

FolderLock::~FolderLock() {
    close(descriptor_);
}

} // namespace suffuse::job
