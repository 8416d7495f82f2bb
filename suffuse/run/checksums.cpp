#include "suffuse/run/checksums.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/sha256.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/checkpoint.hpp"
#include "suffuse/run/folder.hpp"
#include "suffuse/run/missing_stages.hpp"
#include "suffuse/run/refine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <set>
#include <string_view>

namespace suffuse::run {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> changing = {
    checksums_file, "events.jsonl", "progress.json", "plan.json", partial_file};

std::string checksum_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw IoError(fmt::format("{}: cannot be read", path.string()));
    }
    Sha256 hash;
    std::vector<char> part(1U << 20U);
    while (file.read(part.data(), static_cast<std::streamsize>(part.size())) || file.gcount() > 0) {
        hash.add({part.data(), static_cast<std::size_t>(file.gcount())});
    }
    return hash.hex();
}

/// Files of the results below the folder, by name.
std::set<std::string> list_results(const fs::path& run) {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(run)) {
        const std::string name = entry.path().filename();
        const bool is_result = name.front() != '.' && !io::is_partial(name) && std::ranges::count(changing, name) == 0;
        if (entry.is_regular_file() && is_result) {
            names.insert(entry.path().lexically_relative(run).string());
        }
    }
    return names;
}

std::string missing_in(const fs::path& run) {
    return tell_missing(find_missing_stages(load_run(run), run));
}

std::map<std::string, std::string> read_checksums(const fs::path& run) {
    std::ifstream file(run / checksums_file);
    if (!file) {
        check_is_run(run);
        const std::string missing = missing_in(run);
        throw IoError(
            missing.empty() ? fmt::format(
                                  "{0}: has no {1}: an earlier version made it, or it was stopped in its last moment; "
                                  "suffuse report {2} writes them for what is there now",
                                  run.string(), checksums_file, shell_word(run.string())
                              )
                            : fmt::format(
                                  "{0}: the run has not ended: {1}; suffuse resume {2} goes on, and suffuse watch {2} "
                                  "shows whether it still runs",
                                  run.string(), missing, shell_word(run.string())
                              )
        );
    }
    constexpr std::size_t digits = 64, gap = 2;
    std::map<std::string, std::string> sums;
    for (std::string line; std::getline(file, line);) {
        if (line.size() <= digits + gap) {
            throw IoError(fmt::format("{}: the line \"{}\" is no checksum", (run / checksums_file).string(), line));
        }
        sums[line.substr(digits + gap)] = line.substr(0, digits);
    }
    return sums;
}

/// The state says of itself what stage.json says of it.
void check_state(const fs::path& run, const std::string& numbers_file, Verification& found) {
    const fs::path folder = (run / numbers_file).parent_path();
    const nlohmann::json numbers = read_json(run / numbers_file);
    if (!numbers.contains("state_hash") || !fs::exists(folder / "state.h5")) {
        return;
    }
    const std::string told = numbers.at("state_hash");
    const std::string hash = fmt::format("{:016x}", dem::state_hash(io::load_world(folder / "state.h5").world));
    ++found.states;
    if (hash != told) {
        found.damages.push_back({numbers_file, fmt::format("tells the state {}, and state.h5 holds {}", told, hash)});
    }
}

} // namespace

void write_checksums(const fs::path& run) {
    std::string text;
    for (const std::string& name : list_results(run)) {
        text += fmt::format("{}  {}\n", checksum_of(run / name), name);
    }
    io::write_file(run / checksums_file, text);
}

Verification verify_run(const fs::path& run) {
    Verification found;
    const std::map<std::string, std::string> sums = read_checksums(run);
    std::set<std::string> broken;
    for (const auto& [name, sum] : sums) {
        ++found.files;
        const bool is_there = fs::exists(run / name);
        if (!is_there || checksum_of(run / name) != sum) {
            broken.insert(name);
            found.damages.push_back({name, is_there ? "was changed" : "is missing"});
        }
    }
    for (const std::string& name : list_results(run)) {
        if (!sums.contains(name)) {
            found.more.push_back(name);
        }
    }
    if (!broken.contains(resolved_case_file)) {
        found.missing = find_missing_stages(load_run(run), run);
    }
    for (const auto& [name, sum] : sums) {
        const fs::path file = name;
        const std::string state = (file.parent_path() / "state.h5").string();
        if (file.filename() == "stage.json" && !broken.contains(name) && !broken.contains(state)) {
            check_state(run, name, found);
        }
    }
    return found;
}

void to_json(nlohmann::json& json, const Verification& found) {
    nlohmann::json damages = nlohmann::json::array();
    for (const Damage& damage : found.damages) {
        damages.push_back({{"file", damage.file}, {"what", damage.what}});
    }
    json = {
        {"files", found.files},
        {"states", found.states},
        {"damages", damages},
        {"came_later", found.more},
        {"missing_stages", found.missing.names}};
}

} // namespace suffuse::run
