#include "suffuse/record/finished_stages.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/record/checksums.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/stage_sums.hpp"
#include "suffuse/record/stored.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

namespace suffuse::record {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> finished_folders(const fs::path& root) {
    std::vector<fs::path> folders;
    if (!fs::exists(root)) {
        return folders;
    }
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root)) {
        if (entry.path().filename() == "stage.json") {
            folders.push_back(entry.path().parent_path());
        }
    }
    std::ranges::sort(folders);
    return folders;
}

/// Those of the files of one stage.
Sums sums_below(const Sums& of_run, const fs::path& run, const fs::path& folder) {
    const std::string start = folder.lexically_relative(run).string() + "/";
    Sums sums;
    for (auto each = of_run.lower_bound(start); each != of_run.end() && each->first.starts_with(start); ++each) {
        sums[each->first.substr(start.size())] = each->second;
    }
    return sums;
}

/// A folder that was copied or moved is whole, and yet another stage's.
std::string tell_stranger(const fs::path& folder, const std::string& name) {
    const nlohmann::json numbers = read_json(folder / "stage.json");
    const std::string stage = folder.filename(), sample = name.substr(0, name.size() - stage.size() - 1);
    return take_from(folder / "stage.json", [&]() -> std::string {
        const std::string its_stage = numbers.value("stage", stage), its_sample = numbers.value("sample", sample);
        return its_stage == stage && its_sample == sample ? ""
                                                          : fmt::format("is of the stage {}/{}", its_sample, its_stage);
    });
}

void check_one(
    const fs::path& run, const fs::path& folder, const Sums& of_run, const ChecksumOf& now, StagesCheck& found
) {
    const std::string name = folder.lexically_relative(run / "studies").string();
    std::optional<std::vector<Damage>> damages = check_stage(folder, now);
    ++found.stages;
    if (!damages) {
        damages.emplace();
        found.without.push_back(name);
        const Sums sums = sums_below(of_run, run, folder);
        for (const auto& [file, sum] : sums) {
            if (std::string what = what_became_of(folder / file, sum, now); !what.empty()) {
                damages->push_back({file, std::move(what)});
            }
        }
        if (!sums.contains("stage.json")) {
            found.unchecked.push_back(name);
        }
    }
    if (damages->empty()) {
        if (std::string what = tell_stranger(folder, name); !what.empty()) {
            damages->push_back({"stage.json", std::move(what)});
        }
    }
    if (!damages->empty()) {
        found.to_remove.push_back(folder);
    }
    for (const Damage& damage : *damages) {
        found.damages.push_back({(folder / damage.file).lexically_relative(run).string(), damage.what});
    }
}

} // namespace

StagesCheck check_stages(const fs::path& run, const std::string& sample, const ChecksumOf& now) {
    StagesCheck found;
    const Sums of_run = read_run_sums(run);
    for (const fs::path& folder : finished_folders(run / "studies" / sample)) {
        check_one(run, folder, of_run, now, found);
    }
    return found;
}

std::vector<std::string> require_whole_stages(const fs::path& run, const std::string& sample) {
    constexpr std::size_t most_named = 5;
    StagesCheck found = check_stages(run, sample);
    if (found.damages.empty()) {
        return std::move(found.unchecked);
    }
    std::vector<std::string> named;
    for (const Damage& damage : found.damages) {
        if (named.size() < most_named) {
            named.push_back(fmt::format("{} {}", (run / damage.file).string(), damage.what));
        }
    }
    const std::size_t more = found.damages.size() - named.size();
    throw IoError(fmt::format(
        "a finished stage is not as it was: {}{}; {}", fmt::join(named, ", "),
        more > 0 ? fmt::format(" and {} more", more) : "", advice_for(found.to_remove)
    ));
}

std::vector<std::string> require_whole_run(const fs::path& run, const std::string& sample) {
    require_same_inputs(run);
    return require_whole_stages(run, sample);
}

std::string tell_unchecked(const std::vector<std::string>& stages) {
    constexpr std::size_t most_named = 3;
    if (stages.empty()) {
        return "";
    }
    const std::size_t named = std::min(stages.size(), most_named);
    return fmt::format(
        "an earlier version left no checksums of {}{}: nothing tells whether they are as they were",
        fmt::join(std::span(stages).first(named), ", "),
        stages.size() > named ? fmt::format(" and {} more", stages.size() - named) : ""
    );
}

} // namespace suffuse::record
