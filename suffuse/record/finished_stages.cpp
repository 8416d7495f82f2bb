#include "suffuse/record/finished_stages.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/record/checksums.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/refine.hpp"
#include "suffuse/record/samples.hpp"
#include "suffuse/record/stage_key.hpp"
#include "suffuse/record/stage_sums.hpp"
#include "suffuse/record/stored.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <utility>

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

/// Whose the stages of a run are to be.
class KnownStages {
public:
    explicit KnownStages(const casefile::Case* what) : what_(what) {
        if (what == nullptr) {
            return;
        }
        for (const Sample& sample : list_samples(*what)) {
            for (const casefile::Stage& stage : sample.variant->stages) {
                stages_.emplace(stage_name(*sample.variant, stage), std::pair(sample.variant, &stage));
            }
        }
    }

    /// Of a whole stage: what it is of, where that is not what its place says; empty where it is.
    [[nodiscard]] std::string find_mismatch(const fs::path& folder, const std::string& name, StagesCheck& found) const {
        const nlohmann::json numbers = read_json(folder / "stage.json");
        return take_from(folder / "stage.json", [&] { return find_mismatch(numbers, name, found); });
    }

private:
    [[nodiscard]] std::string
    find_mismatch(const nlohmann::json& numbers, const std::string& name, StagesCheck& found) const {
        const std::size_t end_of_sample = name.rfind('/');
        const std::string stage = name.substr(end_of_sample + 1), sample = name.substr(0, end_of_sample);
        const std::string its_stage = numbers.value("stage", stage), its_sample = numbers.value("sample", sample);
        if (its_stage != stage || its_sample != sample) {
            return fmt::format("is of the stage {}/{}", its_sample, its_stage);
        }
        if (what_ == nullptr) {
            return "";
        }
        const auto known = stages_.find(name);
        if (known == stages_.end()) {
            found.is_of_other_case = true;
            return fmt::format("is of a stage that {} does not have", resolved_case_file);
        }
        const auto& [variant, settings] = known->second;
        const std::string key = key_of_stage(
            *what_, *variant, *settings, numbers.value("start_state", ""), numbers.value(imported_files_key, Sums{})
        );
        const SameStage same = compare_keys(numbers.value("key", ""), key);
        if (same == SameStage::Unknown) {
            found.unverified.push_back(name);
        }
        if (same != SameStage::No) {
            return "";
        }
        found.is_of_other_case = true;
        return fmt::format("is of another case: its settings, sample or seed are not those of {}", resolved_case_file);
    }

    const casefile::Case* what_;
    std::map<std::string, std::pair<const casefile::Variant*, const casefile::Stage*>> stages_; ///< by name
};

void check_one(
    const fs::path& run, const fs::path& folder, const Sums& of_run, const KnownStages& known, const ChecksumOf& now,
    StagesCheck& found
) {
    const std::string name = folder.lexically_relative(run / "studies").string();
    std::optional<std::vector<Damage>> damages = check_stage(folder, now);
    ++found.stages;
    if (!damages) {
        damages.emplace();
        found.without.push_back(name);
        const Sums sums = sums_below(of_run, run, folder);
        for (const auto& [file, sum] : sums) {
            if (std::string what = describe_damage(folder / file, sum, now); !what.empty()) {
                damages->push_back({file, std::move(what)});
            }
        }
        if (!sums.contains("stage.json")) {
            found.unchecked.push_back(name);
        }
    }
    if (damages->empty()) {
        if (std::string what = known.find_mismatch(folder, name, found); !what.empty()) {
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

/// "s/x, s/y and 3 more".
std::string first_of(const std::vector<std::string>& stages) {
    constexpr std::size_t most_named = 3;
    const std::size_t named = std::min(stages.size(), most_named);
    return fmt::format(
        "{}{}", fmt::join(std::span(stages).first(named), ", "),
        stages.size() > named ? fmt::format(" and {} more", stages.size() - named) : ""
    );
}

/// What an earlier version left that cannot be checked.
std::string words_on_doubts(const StagesCheck& found) {
    if (!found.unchecked.empty()) {
        return fmt::format(
            "an earlier version left no checksums of {}: it is unknown whether they changed", first_of(found.unchecked)
        );
    }
    return found.unverified.empty() ? ""
                                    : fmt::format(
                                          "unverified: an earlier version left no key of {} that this version can "
                                          "compare; it is unknown whether they belong to this case",
                                          first_of(found.unverified)
                                      );
}

/// Where it is the case that was changed, not the stage.
std::string advice_on_case(const fs::path& run) {
    const std::string began_with = case_that_began(run);
    return fmt::format(
        "if {} was changed, restore it{}; otherwise ", (run / resolved_case_file).string(),
        began_with.empty() ? "" : fmt::format(" (the run began with {})", began_with)
    );
}

} // namespace

StagesCheck
check_stages(const fs::path& run, const casefile::Case* what, const std::string& sample, const ChecksumOf& now) {
    StagesCheck found;
    const Sums of_run = read_run_sums(run);
    const KnownStages known(what);
    for (const fs::path& folder : finished_folders(run / "studies" / sample)) {
        check_one(run, folder, of_run, known, now, found);
    }
    return found;
}

std::string require_whole_stages(const fs::path& run, const std::string& sample) {
    constexpr std::size_t most_named = 5;
    const std::optional<casefile::Case> what =
        fs::exists(run / resolved_case_file) ? std::optional(load_run(run)) : std::nullopt;
    const StagesCheck found = check_stages(run, what ? &*what : nullptr, sample);
    if (found.damages.empty()) {
        return words_on_doubts(found);
    }
    std::vector<std::string> named;
    for (const Damage& damage : found.damages) {
        if (named.size() < most_named) {
            named.push_back(fmt::format("{} {}", (run / damage.file).string(), damage.what));
        }
    }
    const std::size_t more = found.damages.size() - named.size();
    throw IoError(fmt::format(
        "a finished stage has changed: {}{}; {}{}", fmt::join(named, ", "),
        more > 0 ? fmt::format(" and {} more", more) : "", found.is_of_other_case ? advice_on_case(run) : "",
        advice_for(found.to_remove)
    ));
}

std::string require_whole_run(const fs::path& run, const std::string& sample) {
    require_same_inputs(run);
    return require_whole_stages(run, sample);
}

void require_same_imports(const casefile::Case& what, const fs::path& run, const std::string& sample) {
    std::map<std::string, std::string> known; // samples may share a packing
    for (const Sample& each : list_samples(what, "", sample)) {
        for (const casefile::Stage& stage : each.variant->stages) {
            const auto* import = std::get_if<casefile::ImportSpec>(&stage.spec);
            const fs::path file = stage_folder(run, *each.variant, stage) / "stage.json";
            if (import == nullptr || !fs::exists(file)) {
                continue;
            }
            const Sums sums = take_from(file, [&] { return read_json(file).value(imported_files_key, Sums{}); });
            for (const auto& [name, sum] : sums) {
                const std::string& path = name == "packing" ? import->path : import->contacts;
                if (!known.contains(path)) {
                    known[path] = checksum_of(path);
                }
                if (known[path] != sum) {
                    throw CaseError(fmt::format(
                        "{}: holds a run of another case: {} has changed since it was imported; restore it, or give -o "
                        "another folder",
                        run.string(), path
                    ));
                }
            }
        }
    }
}

} // namespace suffuse::record
