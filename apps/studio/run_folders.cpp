#include "apps/studio/run_folders.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/folders.hpp"
#include "suffuse/job/calibration_folder.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/record/folder.hpp"

#include <fmt/format.h>

#include "apps/studio/http.hpp"
#include <algorithm>
#include <cctype>
#include <csignal>
#include <fstream>
#include <functional>
#include <regex>
#include <tuple>
#include <utility>

namespace suffuse::studio {
namespace {

namespace fs = std::filesystem;

/// Whether a descriptor of a process holds a lock for itself alone.
bool holds_lock(const fs::path& process, const std::string& descriptor) {
    std::ifstream file(process / "fdinfo" / descriptor);
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("lock:") && line.find("FLOCK") != std::string::npos &&
            line.find("WRITE") != std::string::npos) {
            return true;
        }
    }
    return false;
}

/// Each regular file in the folders of the stages of a run. Links are not followed.
void for_each_file(const fs::path& run, const std::function<void(const fs::path&)>& see) {
    constexpr int deepest = 8; // folders: a study, its swept keys, a replicate, a stage
    constexpr int most = 1'000'000;
    std::error_code error;
    const fs::path root = run / "studies";
    if (!fs::is_directory(fs::symlink_status(root, error))) {
        return;
    }
    int count = 0;
    for (fs::recursive_directory_iterator one(root, error), end; !error && one != end && count < most;
         one.increment(error), ++count) {
        std::error_code gone; // files of a run at work come and go
        if (one.depth() >= deepest) {
            one.disable_recursion_pending();
        }
        if (!one->is_symlink(gone) && one->is_regular_file(gone)) {
            see(one->path());
        }
    }
}

/// Whether a run or a calibration began in this folder.
bool holds_run(const fs::path& folder) {
    std::error_code error;
    return fs::is_regular_file(folder / record::resolved_case_file, error) || job::is_calibration(folder);
}

} // namespace

fs::path find_below(const fs::path& root, const std::string& name) {
    std::error_code error;
    const fs::path above = fs::canonical(root, error);
    fs::path found = fs::canonical(root / fs::path(name).relative_path(), error);
    const auto [end, rest] = std::mismatch(above.begin(), above.end(), found.begin(), found.end());
    if (error || end != above.end() || rest == found.end()) {
        throw Refusal(404, "there is no such file in the studio's folder");
    }
    return found;
}

fs::path find_run(const fs::path& root, const std::string& name) {
    fs::path found = find_below(root, name);
    const bool is_child = found.parent_path() == fs::canonical(root) && found.filename() == name;
    if (!is_child || !holds_run(found)) {
        throw Refusal(404, "there is no such run in the studio's folder");
    }
    return found;
}

std::vector<std::string> run_names(const fs::path& root) {
    std::vector<std::pair<fs::file_time_type, std::string>> found;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(root)) {
        if (!entry.is_symlink() && holds_run(entry.path())) {
            found.emplace_back(entry.last_write_time(error), entry.path().filename().string());
        }
    }
    std::ranges::sort(found, std::greater());
    std::vector<std::string> names;
    names.reserve(found.size());
    for (auto& [time, name] : found) {
        names.push_back(std::move(name));
    }
    return names;
}

fs::path work_folder(const fs::path& run) {
    const std::vector<fs::path> rounds = job::is_calibration(run) ? job::rounds_of(run) : std::vector<fs::path>();
    return rounds.empty() ? run : rounds.back();
}

std::vector<std::string> finished_stages(const fs::path& run) {
    std::vector<std::string> found;
    for_each_file(run, [&](const fs::path& file) {
        if (file.filename() == "stage.json") {
            found.push_back(file.parent_path().lexically_relative(run / "studies").string());
        }
    });
    std::ranges::sort(found);
    return found;
}

std::vector<GrainPicture> grain_pictures(const fs::path& run) {
    constexpr std::size_t most = 200;
    constexpr std::uintmax_t largest = std::uintmax_t{64} << 20; // [B]: half a million grains
    static const std::regex name("(grains|strain-[0-9]+|pass-[0-9]+)[.]vtp");
    std::vector<GrainPicture> found;
    for_each_file(run, [&](const fs::path& file) {
        std::error_code gone;
        if (std::regex_match(file.filename().string(), name) && fs::file_size(file, gone) <= largest && !gone) {
            found.push_back({file.lexically_relative(run).string(), fs::last_write_time(file, gone)});
        }
    });
    std::ranges::sort(found, [](const GrainPicture& a, const GrainPicture& b) {
        return std::tie(b.written, b.file) < std::tie(a.written, a.file);
    });
    found.resize(std::min(found.size(), most));
    return found;
}

std::vector<fs::path> runs_at_work(const fs::path& root) {
    std::vector<fs::path> runs;
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::canonical(root))) {
        if (!entry.is_symlink() && entry.is_directory() && job::is_at_work(entry.path())) {
            runs.push_back(entry.path());
        }
    }
    return runs;
}

std::optional<pid_t> process_of(const fs::path& run) {
    const fs::path lock = run / ".lock";
    std::error_code error;
    for (const fs::directory_entry& process : fs::directory_iterator("/proc", error)) {
        const std::string number = process.path().filename().string();
        if (!std::ranges::all_of(number, [](unsigned char c) { return std::isdigit(c) != 0; })) {
            continue;
        }
        std::error_code gone; // processes end, and those of others cannot be looked at
        for (fs::directory_iterator one(process.path() / "fd", gone), end; !gone && one != end; one.increment(gone)) {
            std::error_code closed;
            if (fs::read_symlink(one->path(), closed) == lock &&
                holds_lock(process.path(), one->path().filename().string())) {
                return static_cast<pid_t>(std::stol(number));
            }
        }
    }
    return std::nullopt;
}

void stop_run(const fs::path& run) {
    const std::optional<pid_t> process = job::is_at_work(run) ? process_of(run) : std::nullopt;
    if (!process) {
        throw Refusal(409, "no process of yours on this machine works on this run");
    }
    kill(*process, SIGTERM);
}

void remove_run(const fs::path& run) {
    if (job::is_at_work(run)) {
        throw Refusal(409, "this run is at work; stop it first");
    }
    if (!fs::is_regular_file(fs::symlink_status(run / record::provenance_file))) {
        throw Refusal(
            403, "this folder has no provenance.json, so suffuse did not finish it; remove it with your file manager"
        );
    }
    try {
        const job::FolderLock lock(run, [](const std::string&) {});
        fs::remove_all(run);
    } catch (const UsageError& error) { // another program works in it
        throw Refusal(409, error.what());
    }
}

fs::path make_numbered_folder(const fs::path& root, const std::string& name) {
    for (int number = 1;; ++number) {
        fs::path folder = root / fmt::format("{}-{:04}", name, number);
        const bool has_case =
            fs::exists(fs::symlink_status(root / "cases" / folder.filename())); // of a run now deleted
        if (!has_case && io::make_folder(folder)) {
            return folder;
        }
    }
}

std::string last_words(const fs::path& log) {
    constexpr std::streamoff most = 4000; // [B]
    std::error_code error;
    if (fs::canonical(log, error) != log || !fs::is_regular_file(log, error)) {
        return "";
    }
    std::ifstream file(log, std::ios::binary | std::ios::ate);
    file.seekg(std::max(std::streamoff{0}, static_cast<std::streamoff>(file.tellg()) - most));
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string folder_name(const std::string& title) {
    constexpr std::size_t most = 40;
    std::string name;
    for (const unsigned char c : title) {
        const bool is_plain = c < 0x80 && std::isalnum(c) != 0;
        if (is_plain) {
            name += static_cast<char>(std::tolower(c));
        } else if (!name.empty() && name.back() != '-') {
            name += '-';
        }
    }
    name.resize(std::min(name.size(), most));
    while (!name.empty() && name.back() == '-') {
        name.pop_back();
    }
    return name.empty() ? "run" : name;
}

} // namespace suffuse::studio
