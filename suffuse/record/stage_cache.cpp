#include "suffuse/record/stage_cache.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/state_hash.hpp"
#include "suffuse/base/version.hpp"
#include "suffuse/casefile/dependencies.hpp"
#include "suffuse/casefile/stage_traits.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/folders.hpp"
#include "suffuse/io/leftovers.hpp"
#include "suffuse/record/cache_entry.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/samples.hpp"
#include "suffuse/record/stage_sums.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <dlfcn.h>
#include <fstream>
#include <sys/stat.h>
#include <unistd.h>

namespace suffuse::record {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int layout = 2; // of entries; a change of it makes all of them unknown
const char* const settings_file = "cache.json";
const char* const about_cache =
    "stages that suffuse computed, each with all that it depends on; may be deleted at any time";

/// Lies in a folder where an entry is made or taken apart: nothing else of such a name is removed.
const char* const maker_file = ".made-by-suffuse";

std::string hash_of_file(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    StateHash hash;
    hash.add(std::string_view(bytes));
    return fmt::format("{:016x}, {} bytes", hash.value(), bytes.size());
}

/// The code that computes, whatever its version says: a program that was built anew may give other bits.
const std::string& program() {
    static const std::string text = [] {
        Dl_info object{};
        const bool is_found = dladdr(reinterpret_cast<const void*>(&StageCache::key_of), &object) != 0;
        std::error_code error;
        fs::path file = is_found && object.dli_fname != nullptr ? object.dli_fname : "";
        // A program that was found through PATH is known by its bare name, which may be another file's here.
        if (!file.has_parent_path() || !fs::is_regular_file(file, error)) {
            file = "/proc/self/exe";
        }
        return fmt::format("{} {}, {}", version(), commit(), hash_of_file(file));
    }();
    return text;
}

/// How the folder of an entry, and one that becomes an entry, is named. A folder of somebody's own may be named so,
/// too.
bool names_an_entry(const std::string& name) {
    return name.size() == 16 && name.find_first_not_of("0123456789abcdef") == std::string::npos;
}

bool names_one_being_made(const std::string& name) {
    return name.rfind("new-", 0) == 0 && name.find_first_not_of("0123456789-", 4) == std::string::npos;
}

bool holds_file(const fs::directory_entry& place, const char* file) {
    std::error_code error;
    return fs::is_directory(place.symlink_status(error)) && fs::is_regular_file(place.path() / file, error);
}

void mark_made_here(const fs::path& folder) {
    io::write_file(folder / maker_file, fmt::format("suffuse {}, process {}\n", version(), getpid()));
}

/// The mark goes last: what a kill leaves of the folder still has it.
void remove_marked(const fs::path& folder) {
    std::error_code error;
    for (const fs::directory_entry& part : fs::directory_iterator(folder, error)) {
        if (part.path().filename() != maker_file) {
            fs::remove_all(part.path(), error);
        }
    }
    fs::remove_all(folder, error);
}

/// Texts begin with the name of the stage, some with that of its study too.
json renamed(json texts, const std::string& made_as, const std::string& name_now) {
    const auto stage_of = [](const std::string& name) { return name.substr(name.rfind('/') + 1); };
    for (json& item : texts) {
        const std::string text = item;
        for (const auto& [from, to] : {std::pair{made_as, name_now}, {stage_of(made_as), stage_of(name_now)}}) {
            if (text.rfind(from + ": ", 0) == 0) {
                item = to + text.substr(from.size());
                break;
            }
        }
    }
    return texts;
}

/// stage.json of a stage that takes the entry's results.
json numbers_for(
    json numbers, const CacheEntry& entry, const casefile::Variant& variant, const casefile::Stage& stage
) {
    numbers["stage"] = stage.name;
    numbers["sample"] = variant.folder;
    numbers["from_cache"] = true;
    for (const char* const list : {"warnings", "flaws"}) {
        numbers[list] = renamed(numbers.at(list), entry.made_as, stage_name(variant, stage));
    }
    return numbers;
}

/// What a taking that failed has left.
void remove_files(const fs::path& folder, const Sums& named) {
    std::error_code error;
    for (const auto& [name, sum] : named) {
        fs::remove(folder / name, error);
    }
}

} // namespace

std::string describe_state(const dem::World& world) {
    StateHash hash;
    hash.add(dem::state_hash(world));
    hash.add(world.clock.time);
    hash.add(std::span(world.grains.id));
    hash.add(std::span(world.grains.fine));
    hash.add(std::span(world.grains.mass));
    return fmt::format("{:016x}", hash.value());
}

std::string StageCache::key_of(
    const casefile::Case& what, const casefile::Variant& variant, const casefile::Stage& stage,
    const std::string& start_state
) {
    std::string text = fmt::format("# suffuse {}, cache layout {}\n", program(), layout);
    text += start_state.empty() ? "# makes its own sample\n" : "# starts from the state " + start_state + "\n";
    if (const auto* import = std::get_if<casefile::ImportSpec>(&stage.spec)) {
        text += "# packing " + hash_of_file(import->path) + "\n";
        text += import->contacts.empty() ? "" : "# contacts " + hash_of_file(import->contacts) + "\n";
    }
    text += leaves_tables(what, variant, stage) ? "# leaves tables\n" : "";
    text += has_fractions(variant) ? "# tells of fines\n" : "";
    return text + casefile::dependencies_of(what, variant, stage);
}

bool StageCache::keeps(const casefile::Stage& stage) {
    return casefile::traits_of(stage).is_cached;
}

fs::path StageCache::place_of(const std::string& key) const {
    StateHash hash;
    hash.add(std::string_view(key));
    return folder_ / fmt::format("{:016x}", hash.value());
}

std::optional<CacheEntry> StageCache::find(const std::string& key) const {
    if (folder_.empty() || !may_take(place_of(key))) {
        return std::nullopt;
    }
    std::optional<WholeEntry> found = read_entry(place_of(key));
    return found && found->depends_on == key ? std::optional(std::move(found->entry)) : std::nullopt;
}

/// Only the owner of an entry's folder can have written what is in it.
bool StageCache::may_take(const fs::path& entry) const {
    struct stat there {};

    return owners_ == Owners::Anybody || (lstat(entry.c_str(), &there) == 0 && there.st_uid == geteuid());
}

bool StageCache::is_one() const {
    if (!fs::is_directory(folder_)) {
        return false;
    }
    const auto is_of_cache = [](const fs::directory_entry& place) {
        return place.path().filename() == prices_file || io::is_leftover_of(place.path(), settings_file);
    };
    // In this order: another program may be making the cache just now.
    if (std::all_of(fs::directory_iterator(folder_), fs::directory_iterator(), is_of_cache)) {
        return true;
    }
    try {
        const json settings = read_json(folder_ / settings_file);
        return settings.is_object() && settings.contains("about") && settings.at("about") == about_cache;
    } catch (const IoError&) { // there is none
        return false;
    }
}

void StageCache::require_one() const {
    if (!folder_.empty() && fs::is_directory(folder_) && !is_one()) {
        throw UsageError(fmt::format(
            "{} is not a cache: it holds files but no cache.json of suffuse; give --cache a new folder, or use "
            "--no-cache",
            folder_.string()
        ));
    }
}

CacheAnswer StageCache::take(
    const std::string& key, const casefile::Variant& variant, const casefile::Stage& stage,
    const fs::path& stage_folder, const std::string& stage_key
) const {
    const fs::path place = place_of(key);
    std::error_code error;
    if (folder_.empty() || !fs::exists(place, error) || !may_take(place)) {
        return {};
    }
    Sums sums;
    try {
        sums = checked_sums(place);
        const std::optional<CacheEntry> entry = find(key);
        if (!entry) { // one of another key with this hash
            return {};
        }
        json numbers = numbers_for(read_json(place / "stage.json"), *entry, variant, stage);
        numbers["key"] = stage_key;
        sums.erase("stage.json");
        copy_checked(place, stage_folder, sums);
        fs::last_write_time(place, fs::file_time_type::clock::now(), error);
        seal_stage(stage_folder, std::move(numbers), sums);
        return {true, ""};
    } catch (const DamagedEntry& damage) {
        remove_files(stage_folder, sums);
        if (!fs::exists(place, error)) { // another program dropped it meanwhile
            return {};
        }
        drop(place);
        return {false, damage.what()};
    } catch (const fs::filesystem_error&) { // the stage's folder cannot take it; computing the stage says so
        remove_files(stage_folder, sums);
    } catch (const IoError&) {
        remove_files(stage_folder, sums);
    }
    return {};
}

/// Where an entry is made, or taken apart: nobody looks there.
fs::path StageCache::place_to_work() const {
    static std::atomic<int> count{0};
    return folder_ / fmt::format("new-{}-{}", getpid(), ++count);
}

/// At once for its readers: an entry is whole, or gone.
void StageCache::drop(const fs::path& entry) const {
    const fs::path apart = place_to_work();
    std::error_code error;
    io::show_file(entry / maker_file, ""); // where it cannot be written, nothing can be removed
    fs::rename(entry, apart, error);
    remove_marked(error ? entry : apart);
}

void StageCache::keep(const std::string& key, const fs::path& stage_folder) {
    if (folder_.empty() || read_entry(place_of(key))) {
        return;
    }
    const std::optional<Sums> sums = read_stage_sums(stage_folder);
    expects(sums.has_value(), "a stage that is kept has checksums");
    const fs::path making = place_to_work();
    try {
        if (!fs::exists(folder_ / settings_file)) {
            set_limit(usual_limit);
        }
        io::make_folders(making);
        mark_made_here(making);
        fill_entry(making, stage_folder, *sums, key);
        if (fs::exists(place_of(key)) && !read_entry(place_of(key))) {
            drop(place_of(key)); // a damaged one
        }
        std::error_code error;
        fs::remove(making / maker_file, error);
        fs::rename(making, place_of(key), error);
        if (error) { // another sample was first, with the same bits
            fs::remove_all(making, error);
        }
    } catch (const fs::filesystem_error& problem) {
        std::error_code error;
        fs::remove_all(making, error);
        throw IoError(fmt::format("{}: {}", folder_.string(), problem.code().message()));
    } catch (...) {
        std::error_code error;
        fs::remove_all(making, error);
        throw;
    }
    shrink(limit());
}

std::vector<CacheEntry> StageCache::entries() const {
    std::vector<std::pair<fs::file_time_type, CacheEntry>> found;
    std::error_code error;
    for (const fs::directory_entry& place : fs::directory_iterator(folder_, error)) {
        if (!names_an_entry(place.path().filename().string())) {
            continue;
        }
        if (auto whole = read_entry(place.path())) {
            found.emplace_back(fs::last_write_time(place.path(), error), std::move(whole->entry));
        }
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
        return a.first != b.first ? a.first > b.first : a.second.folder < b.second.folder;
    });
    std::vector<CacheEntry> list;
    list.reserve(found.size());
    for (auto& [time, entry] : found) {
        list.push_back(std::move(entry));
    }
    return list;
}

std::int64_t StageCache::limit() const {
    try {
        return read_json(folder_ / settings_file).value("limit_bytes", usual_limit);
    } catch (const IoError&) { // none was set, or the file is damaged
    } catch (const json::exception&) {
    }
    return usual_limit;
}

void StageCache::set_limit(std::int64_t bytes) const {
    io::make_folders(folder_);
    write_json(folder_ / settings_file, {{"about", about_cache}, {"limit_bytes", bytes}});
}

int StageCache::clear() {
    return drop_leftovers(std::chrono::hours(0)) + shrink(0);
}

/// What killed programs began and never finished, and entries that cannot be read. @return how many of the latter
int StageCache::drop_leftovers(std::chrono::hours age) {
    int damaged = 0;
    std::error_code error;
    const auto now = fs::file_time_type::clock::now();
    for (const fs::directory_entry& place : fs::directory_iterator(folder_, error)) {
        const std::string name = place.path().filename().string();
        const bool is_damaged = names_an_entry(name) && holds_file(place, "entry.json") && !read_entry(place.path());
        const bool is_left = names_one_being_made(name) && holds_file(place, maker_file) &&
                             now - fs::last_write_time(place.path(), error) >= age;
        if (is_damaged || is_left) {
            remove_marked(place.path());
            damaged += is_damaged ? 1 : 0;
        }
    }
    return damaged;
}

int StageCache::shrink(std::int64_t bytes) {
    int dropped = drop_leftovers(std::chrono::hours(24)); // nobody takes a day to copy a stage
    std::int64_t held = 0;
    for (const CacheEntry& entry : entries()) {
        held += entry.bytes;
        if (held <= bytes) {
            continue;
        }
        drop(entry.folder);
        held -= entry.bytes;
        ++dropped;
    }
    return dropped;
}

} // namespace suffuse::record
