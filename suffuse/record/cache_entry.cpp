#include "suffuse/record/cache_entry.hpp"

#include "suffuse/io/atomic_file.hpp"
#include "suffuse/record/folder.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::record {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const char* const entry_file = "entry.json";

bool is_plain_name(const std::string& name) {
    return name.find('/') == std::string::npos;
}

void check_part(const fs::path& file, const std::string& sum) {
    if (const std::string what = describe_damage(file, sum); !what.empty()) {
        throw DamagedEntry(fmt::format("{} {}", file.string(), what));
    }
}

/// A power cut after this leaves no file shorter than it was.
void copy_to_disk(const fs::path& from, const fs::path& to) {
    fs::remove(to); // which may be a link
    fs::copy_file(from, to);
    io::sync_file(to);
}

/// "studies/STUDY[/sweep values]/STAGE", without the first.
std::string name_of_stage(const fs::path& stage_folder) {
    std::string name;
    for (fs::path part = stage_folder; part.filename() != "studies" && part.has_relative_path();
         part = part.parent_path()) {
        name.insert(0, name.empty() ? 0 : 1, '/');
        name.insert(0, part.filename().string());
    }
    return name;
}

} // namespace

std::optional<WholeEntry> read_entry(const fs::path& folder) {
    try {
        const json entry = read_json(folder / entry_file);
        return WholeEntry{
            {folder, entry.at("made_as"), entry.at("end_state"), entry.at("bytes"), entry.at("wall_seconds")},
            entry.at("depends_on")};
    } catch (const IoError&) {
    } catch (const json::exception&) {
    }
    return std::nullopt;
}

Sums checked_sums(const fs::path& entry) {
    try {
        Sums sums = read_sums(entry / checksums_file);
        for (const char* const name : {entry_file, "stage.json"}) {
            if (!sums.contains(name)) {
                throw DamagedEntry(fmt::format("{} was changed", (entry / checksums_file).string()));
            }
            check_part(entry / name, sums[name]);
        }
        sums.erase(entry_file);
        const bool is_whole = read_json(entry / "stage.json").at("checksums") == sums.size();
        const bool is_flat = std::ranges::all_of(sums, [](const auto& sum) { return is_plain_name(sum.first); });
        if (!is_whole || !is_flat) {
            throw DamagedEntry(fmt::format("{} was changed", (entry / checksums_file).string()));
        }
        return sums;
    } catch (const DamagedEntry&) {
        throw;
    } catch (const std::exception& error) { // of files that cannot be read, or of what stands in them
        throw DamagedEntry(error.what());
    }
}

void copy_checked(const fs::path& from, const fs::path& to, const Sums& sums) {
    for (const auto& [name, sum] : sums) {
        if (!fs::is_regular_file(from / name)) {
            throw DamagedEntry(fmt::format("{} is missing", (from / name).string()));
        }
        copy_to_disk(from / name, to / name);
        if (checksum_of(to / name) != sum) {
            throw DamagedEntry(fmt::format("{} was changed", (from / name).string()));
        }
    }
}

void fill_entry(const fs::path& entry_folder, const fs::path& stage_folder, Sums sums, const std::string& key) {
    copy_checked(stage_folder, entry_folder, sums);
    const json numbers = read_json(entry_folder / "stage.json");
    std::uintmax_t bytes = 0;
    for (const auto& [name, sum] : sums) {
        bytes += name == "stage.json" ? 0 : fs::file_size(entry_folder / name);
    }
    const json about{
        {"made_as", name_of_stage(stage_folder)},
        {"end_state", numbers.at("end_state")},
        {"bytes", bytes},
        {"wall_seconds", numbers.at("wall_seconds")},
        {"depends_on", key}};
    write_json(entry_folder / entry_file, about);
    sums[entry_file] = checksum_of(entry_folder / entry_file);
    io::write_file(entry_folder / checksums_file, sums_text(sums));
}

} // namespace suffuse::record
