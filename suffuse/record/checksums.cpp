#include "suffuse/record/checksums.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/checkpoint.hpp"
#include "suffuse/record/documents.hpp"
#include "suffuse/record/finished_stages.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/missing_stages.hpp"
#include "suffuse/record/refine.hpp"
#include "suffuse/record/stage_sums.hpp"
#include "suffuse/record/stored.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <set>
#include <string_view>

namespace suffuse::record {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> changing = {
    "events.jsonl", "progress.json", "plan.json", "report.pdf", partial_file};

/// What says what to compute, and by what it was computed.
constexpr std::array<std::string_view, 5> inputs = {
    "case.toml", resolved_case_file, options_file, refinement_file, provenance_file};

/// Of a run folder: what runs, reports and `suffuse sweep` write there.
constexpr std::array<std::string_view, 10> results_of_run = {
    "case.toml",      resolved_case_file, options_file,  refinement_file, provenance_file,
    "own_rules.json", "summary.json",     "report.html", "tasks.txt",     "submit.sh"};

/// Of the folder of a sample, next to those of its stages.
constexpr std::array<std::string_view, 3> results_of_sample = {"grains.pvd", "view.py", provenance_file};

/// Files below the folder, by name, that may be results or the user's.
std::set<std::string> list_results(const fs::path& run) {
    std::set<std::string> names;
    for (auto entry = fs::recursive_directory_iterator(run); entry != fs::recursive_directory_iterator(); ++entry) {
        const std::string name = entry->path().filename();
        const bool is_result = name.front() != '.' && !io::is_partial(name) && std::ranges::count(changing, name) == 0;
        if (entry->is_directory() && (!is_result || entry->path() == run / tasks_folder)) {
            entry.disable_recursion_pending();
        } else if (entry->is_regular_file() && is_result) {
            names.insert(entry->path().lexically_relative(run).string());
        }
    }
    names.erase(checksums_file);
    return names;
}

/// Whether the program wrote the file, one of list_results. @param figures of the report
bool is_own(const fs::path& run, const fs::path& name, const std::vector<std::string>& figures) {
    const std::string file = name.filename(), stem = name.stem();
    const fs::path folder = name.parent_path();
    if (folder.empty()) {
        return std::ranges::count(results_of_run, file) > 0 || stem == "sweep" || stem.starts_with("sweep-") ||
               stem == "gather";
    }
    if (folder == "figures") {
        return std::ranges::count(figures, file) > 0;
    }
    const bool is_of_stage = fs::exists(run / folder / "stage.json") || file == failure_file;
    return *folder.begin() == "studies" && (is_of_stage || std::ranges::count(results_of_sample, file) > 0);
}

/// Of a finished stage: its own checksum of the file, or the run's earlier one; nothing where there is neither.
std::optional<std::string> sum_from_stage(
    const std::string& name, const fs::path& file, const std::optional<Sums>& of_stage, const Sums& earlier
) {
    const Sums& sums = of_stage ? *of_stage : earlier;
    const auto found = sums.find(of_stage ? file.filename().string() : name);
    return found == sums.end() ? std::nullopt : std::optional(found->second);
}

/// The checksums with which the run ended. @throws IoError that says why there are none
Sums sums_of_ended(const fs::path& run) {
    if (fs::exists(run / checksums_file)) {
        return read_run_sums(run);
    }
    check_is_run(run);
    const std::string missing = describe_missing(find_missing_stages(load_run(run), run));
    throw IoError(
        missing.empty() ? fmt::format(
                              "{0}: has no {1}: an earlier version made it, or it was stopped in its last moment; "
                              "suffuse report {2} writes them, once the stages are found whole",
                              run.string(), checksums_file, shell_word(run.string())
                          )
                        : fmt::format(
                              "{0}: the run has not ended: {1}; suffuse resume {2} continues it, and suffuse watch {2} "
                              "shows whether it still runs",
                              run.string(), missing, shell_word(run.string())
                          )
    );
}

/// The state says of itself what stage.json says of it.
void check_state(const fs::path& run, const std::string& numbers_file, Verification& found) {
    const fs::path folder = (run / numbers_file).parent_path();
    const nlohmann::json numbers = read_json(run / numbers_file);
    if (!numbers.contains("state_hash") || !fs::exists(folder / "state.h5")) {
        return;
    }
    const std::string recorded =
        take_from(run / numbers_file, [&] { return numbers.at("state_hash").get<std::string>(); });
    const std::string hash = fmt::format("{:016x}", dem::state_hash(io::load_world(folder / "state.h5").world));
    ++found.states;
    if (hash != recorded) {
        found.damages.push_back(
            {numbers_file, fmt::format("records the state {}, but state.h5 holds {}", recorded, hash)}
        );
    }
}

/// That a run which was stopped, and has no checksums yet, still has the case that its log says it began with.
/// @throws IoError where it was changed
void require_case_of_beginning(const fs::path& run) {
    std::ifstream log(run / "events.jsonl");
    for (std::string line; std::getline(log, line);) {
        const nlohmann::json event = parse_json(line);
        if (!event.is_object() || !event.contains("case_sha256") || !event.at("case_sha256").is_string()) {
            continue;
        }
        const std::string what = describe_damage(run / resolved_case_file, event.at("case_sha256"));
        if (!what.empty()) {
            const std::string began_with = case_that_began(run);
            throw IoError(fmt::format(
                "{} {} since the run began{}: restore it, or begin a run in another folder",
                (run / resolved_case_file).string(), what, began_with.empty() ? "" : " with " + began_with
            ));
        }
        return;
    }
}

/// A file of the run that no stage left. @throws IoError
void check_own(const fs::path& run, const std::string& name, const std::string& sum) {
    const std::string what = describe_damage(run / name, sum);
    if (what.empty()) {
        return;
    }
    const std::string advice =
        std::ranges::count(inputs, name) == 0
            ? fmt::format("suffuse report {} writes it anew", shell_word(run.string()))
            : fmt::format(
                  "restore it, or, if the change is yours, remove its line from {}", (run / checksums_file).string()
              );
    throw IoError(fmt::format("{} {} since the run ended; {}", (run / name).string(), what, advice));
}

/// What the stages say about their files. The run says the same, unless somebody wrote its checksums anew.
void check_against_stages(const fs::path& run, const casefile::Case* what, const ChecksumOf& now, Verification& found) {
    const StagesCheck stages = check_stages(run, what, "", now);
    found.stages = stages.stages;
    found.without_checksums = stages.without;
    found.unverified = stages.unverified;
    for (const Damage& damage : stages.damages) {
        const bool is_known =
            std::ranges::any_of(found.damages, [&](const Damage& known) { return known.file == damage.file; });
        if (!is_known) {
            found.damages.push_back({damage.file, damage.what + " since its stage ended"});
        }
    }
}

} // namespace

Sums read_run_sums(const fs::path& run) {
    if (!fs::exists(run / checksums_file)) {
        return {};
    }
    try {
        return read_sums(run / checksums_file);
    } catch (const IoError& error) {
        throw IoError(fmt::format(
            "{}; restore it, or remove it, and suffuse report {} writes it anew; the stages are checked "
            "regardless",
            error.what(), shell_word(run.string())
        ));
    }
}

void write_run_sums(const fs::path& run, const std::vector<std::string>& figures, const Sums& earlier) {
    Sums sums;
    std::map<fs::path, std::optional<Sums>> stages;
    for (const std::string& name : list_results(run)) {
        const fs::path file = run / name, folder = file.parent_path();
        if (!is_own(run, name, figures)) {
            continue;
        }
        if (file.filename() == checksums_file || !fs::exists(folder / "stage.json")) {
            sums[name] = checksum_of(file);
            continue;
        }
        const auto [stage, is_new] = stages.try_emplace(folder);
        if (is_new) {
            stage->second = read_stage_sums(folder);
        }
        if (auto sum = sum_from_stage(name, file, stage->second, earlier)) {
            sums[name] = std::move(*sum);
        }
    }
    io::write_file(run / checksums_file, sums_text(sums));
}

void require_same_inputs(const fs::path& run) {
    const Sums sums = read_run_sums(run);
    if (sums.empty() && fs::exists(run / resolved_case_file)) {
        require_case_of_beginning(run);
    }
    for (const std::string_view input : inputs) {
        const std::string name(input);
        const auto found = sums.find(name);
        const bool is_made_anew = name == provenance_file && !fs::exists(run / name);
        if (found != sums.end() && !is_made_anew) {
            check_own(run, name, found->second);
        }
    }
}

void require_same_result(const fs::path& run, const std::string& name) {
    const Sums sums = read_run_sums(run);
    if (const auto found = sums.find(name); found != sums.end()) {
        check_own(run, name, found->second);
    }
}

void require_same_figures(
    const fs::path& run, const std::vector<std::string>& ids, const std::vector<std::string>& endings
) {
    for (const auto& [name, sum] : read_run_sums(run)) {
        const fs::path file = name;
        const std::string own = file.filename(), id = own.substr(0, own.find('.'));
        const bool is_requested = ids.empty() || std::ranges::count(ids, id) > 0;
        const bool is_read = std::ranges::count(endings, own.substr(id.size())) > 0;
        if (file.parent_path() == "figures" && is_requested && is_read) {
            check_own(run, name, sum);
        }
    }
}

bool has_same_results(const fs::path& run) {
    const Sums sums = read_run_sums(run);
    return std::ranges::all_of(sums, [&](const auto& each) {
        const fs::path file = run / each.first;
        return fs::exists(file.parent_path() / "stage.json") || describe_damage(file, each.second).empty();
    });
}

Verification verify_run(const fs::path& run) {
    Verification found;
    std::map<fs::path, std::string> known; // no file is read twice
    const ChecksumOf now = [&](const fs::path& file) {
        const auto [place, is_new] = known.try_emplace(file);
        if (is_new) {
            place->second = checksum_of(file);
        }
        return place->second;
    };
    const Sums sums = sums_of_ended(run);
    for (const auto& [name, sum] : sums) {
        ++found.files;
        if (std::string what = describe_damage(run / name, sum, now); !what.empty()) {
            found.damages.push_back({name, std::move(what)});
        }
    }
    const bool has_case = std::ranges::none_of(found.damages, [](const Damage& damage) {
        return damage.file == resolved_case_file || damage.file == refinement_file;
    });
    const std::optional<casefile::Case> what = has_case ? std::optional(load_run(run)) : std::nullopt;
    check_against_stages(run, what ? &*what : nullptr, now, found);
    std::set<std::string> broken;
    for (const Damage& damage : found.damages) {
        broken.insert(damage.file);
    }
    for (const std::string& name : list_results(run)) {
        if (!sums.contains(name)) {
            found.more.push_back(name);
        }
    }
    if (what) {
        found.missing = find_missing_stages(*what, run);
    }
    if (const fs::path summary = run / "summary.json"; !broken.contains("summary.json") && fs::exists(summary)) {
        take_from(summary, [&, kept = read_json(summary)] {
            const auto until = kept.find("until");
            found.until = until == kept.end() || until->is_null() ? "" : until->get<std::string>();
        });
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
    json = {{"files", found.files},           {"states", found.states},
            {"stages", found.stages},         {"without_checksums", found.without_checksums},
            {"unverified", found.unverified}, {"damages", damages},
            {"came_later", found.more},       {"missing_stages", found.missing.names}};
}

} // namespace suffuse::record
