#include "suffuse/record/stage_sums.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/record/folder.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::record {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const char* const stage_numbers = "stage.json";
const char* const count_key = "checksums"; ///< of stage.json: how many there are

/// How many files stage.json says have checksums; nothing where it says none, or cannot be read.
std::optional<std::size_t> stated_count(const fs::path& folder) {
    try {
        const json numbers = read_json(folder / stage_numbers);
        return numbers.contains(count_key) ? std::optional(numbers.at(count_key).get<std::size_t>()) : std::nullopt;
    } catch (const json::exception&) { // its own checksum shows more
    } catch (const IoError&) {
    }
    return std::nullopt;
}

[[noreturn]] void complain(const fs::path& file, const std::string& what) {
    throw IoError(fmt::format("{} {}; {}", file.string(), what, advice_for({file.parent_path()})));
}

/// The checksums, or what is wrong with them; neither where the stage has none.
std::optional<Sums> find_sums(const fs::path& folder, std::string& wrong) {
    const std::optional<std::size_t> stated = stated_count(folder);
    if (!fs::exists(folder / checksums_file)) {
        wrong = stated ? "is missing" : "";
        return std::nullopt;
    }
    try {
        Sums sums = read_sums(folder / checksums_file);
        if (sums.contains(stage_numbers) && (!stated || *stated == sums.size())) {
            return sums;
        }
    } catch (const IoError&) { // a line that is no checksum
    }
    wrong = "was changed";
    return std::nullopt;
}

} // namespace

bool is_left_by_stage(const fs::directory_entry& file) {
    const std::string name = file.path().filename();
    return file.is_regular_file() && name != stage_numbers && name != checksums_file && name != partial_file &&
           name != failure_file && name.front() != '.' && !io::is_partial(name);
}

void seal_stage(const fs::path& folder, json numbers, Sums known, const std::vector<std::string>& strange) {
    Sums sums;
    for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
        const std::string name = file.path().filename();
        if (is_left_by_stage(file) && std::ranges::count(strange, name) == 0) {
            const auto found = known.find(name);
            sums[name] = found != known.end() ? found->second : checksum_of(file.path());
        }
    }
    numbers[count_key] = sums.size() + 1;
    const std::string text = file_text_of(numbers);
    sums[stage_numbers] = checksum_of_text(text);
    io::write_file(folder / checksums_file, sums_text(sums));
    io::write_file(folder / stage_numbers, text);
}

std::optional<Sums> read_stage_sums(const fs::path& folder) {
    std::string wrong;
    std::optional<Sums> sums = find_sums(folder, wrong);
    if (!wrong.empty()) {
        complain(folder / checksums_file, wrong);
    }
    return sums;
}

std::optional<std::vector<Damage>> check_stage(const fs::path& folder, const ChecksumOf& now) {
    std::string wrong;
    const std::optional<Sums> sums = find_sums(folder, wrong);
    if (!wrong.empty()) {
        return std::vector<Damage>{{checksums_file, wrong}};
    }
    if (!sums) {
        return std::nullopt;
    }
    std::vector<Damage> damages;
    for (const auto& [name, sum] : *sums) {
        if (std::string what = describe_damage(folder / name, sum, now); !what.empty()) {
            damages.push_back({name, std::move(what)});
        }
    }
    return damages;
}

void check_file(const fs::path& file) {
    const fs::path folder = file.parent_path();
    if (!fs::exists(folder / stage_numbers)) {
        return;
    }
    const std::optional<Sums> sums = read_stage_sums(folder);
    const auto found = sums ? sums->find(file.filename()) : Sums::const_iterator{};
    if (!sums || found == sums->end()) {
        return;
    }
    if (const std::string what = describe_damage(file, found->second); !what.empty()) {
        complain(file, what + " since its stage ended");
    }
}

std::string advice_for(const std::vector<fs::path>& folders) {
    std::string list;
    for (const fs::path& folder : folders) {
        list += (list.empty() ? "" : " ") + shell_word(folder.string());
    }
    return fmt::format(
        "remove {} and resume: {} then computed anew", list, folders.size() == 1 ? "its stage is" : "their stages are"
    );
}

} // namespace suffuse::record
