// compare and verify: what differs between two runs, from the paper, or from what a run was when it ended.

#include "suffuse/base/shell_word.hpp"
#include "suffuse/run/checksums.hpp"
#include "suffuse/run/compare_runs.hpp"
#include "suffuse/run/folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/exit_code.hpp"
#include "apps/verbs.hpp"
#include "apps/wording.hpp"
#include <algorithm>
#include <filesystem>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

constexpr std::ptrdiff_t most_shown = 20; // without --verbose

/// "number 3.1 was 2.9 (6 %)": the largest first.
std::string row_of(const run::Difference& difference) {
    const std::string off = difference.relative < 1 ? fmt::format("   {:.3g} %", 100 * difference.relative) : "";
    return fmt::format("  {}   {} and {}{}\n", difference.where, difference.first, difference.second, off);
}

std::string table_of(std::vector<run::Difference> differences, bool all) {
    std::stable_sort(differences.begin(), differences.end(), [](const auto& a, const auto& b) {
        return a.relative > b.relative;
    });
    const std::ptrdiff_t shown = all ? std::ssize(differences) : std::min(most_shown, std::ssize(differences));
    std::string text;
    for (std::ptrdiff_t k = 0; k < shown; ++k) {
        text += row_of(differences[static_cast<std::size_t>(k)]);
    }
    if (shown < std::ssize(differences)) {
        text += fmt::format("  and {} more; -v lists them\n", std::ssize(differences) - shown);
    }
    return text;
}

/// The sentence of a comparison, before its table.
std::string verdict_on(const run::Comparison& found, double tolerance) {
    const std::string states = fmt::format(
        "{} in both, {} with the same bits; {} compared", plural(found.stages, "stage"), found.same_states,
        plural(found.numbers, "number")
    );
    if (found.differences.empty()) {
        return fmt::format("no difference{}: {}", tolerance > 0 ? " beyond the tolerance" : "", states);
    }
    return fmt::format("{}: {}", plural(std::ssize(found.differences), "difference"), states);
}

/// What is in each of two runs that share no stage: there is nothing else to say of them.
std::string nothing_shared(const CommandLine& line, const run::Comparison& found) {
    const auto list = [](const std::string& folder, const std::vector<std::string>& stages) {
        return fmt::format(
            "  {} has {}", folder, stages.empty() ? "no finished stage" : fmt::format("{}", fmt::join(stages, ", "))
        );
    };
    return fmt::format(
        "nothing to compare: no stage, by its study, sample and name, is in both\n{}\n{}\nstages are "
        "compared that have one name in both runs, as runs of one case have with other values (--set)",
        list(line.subject, found.only_first), list(line.other, found.only_second)
    );
}

int compare_two(const CommandLine& line, const Console& console) {
    const double tolerance =
        line.tolerance.empty() ? 0 : quantity_of(line.tolerance, dimension::none, "--tolerance", true);
    if (!(tolerance >= 0 && tolerance < 1)) {
        throw UsageError(fmt::format("--tolerance {}: from 0 to below 1, or as in 2%", shown(line.tolerance)));
    }
    const run::Comparison found = run::compare_runs(line.subject, line.other, tolerance);
    if (found.stages == 0) {
        console.result(nothing_shared(line, found));
        console.document(json_text(found));
        return Differs;
    }
    for (const std::string& circumstance : found.circumstances) {
        console.result("  " + circumstance);
    }
    console.result(verdict_on(found, tolerance));
    console.result(table_of(found.differences, console.is_verbose()));
    console.document(json_text(found));
    return found.differences.empty() ? Done : Differs;
}

/// Each finding of the paper: its number, ours, and whether it is met.
int compare_with_paper(const CommandLine& line, const Console& console) {
    const fs::path summary = fs::path(line.subject) / "summary.json";
    if (!fs::exists(summary)) {
        throw IoError(
            fmt::format("{}: has no summary.json: the run has not ended; suffuse resume goes on", line.subject)
        );
    }
    const nlohmann::json findings = run::read_json(summary).at("findings");
    bool all_met = true;
    for (const nlohmann::json& finding : findings) {
        const nlohmann::json& met = finding.at("met");
        const bool is_known = met.is_boolean();
        all_met = all_met && (!is_known || met.get<bool>());
        console.result(fmt::format(
            "{:4}{:12}{}\n{:16}paper: {}\n{:16}here:  {}", finding.at("id").get<std::string>(),
            !is_known         ? "cannot tell"
            : met.get<bool>() ? "met"
                              : "not met",
            finding.at("claim").get<std::string>(), "", finding.at("paper").get<std::string>(), "",
            finding.at("ours").get<std::string>()
        ));
    }
    if (findings.empty()) {
        console.result("the run holds nothing that the paper found something about");
    }
    console.document(json_text({{"findings", findings}}));
    return all_met ? Done : Differs;
}

} // namespace

int compare_verb(const CommandLine& line, const Console& console) {
    if (line.paper == !line.other.empty()) {
        throw UsageError("compare: two folders of runs, or one and --paper");
    }
    return line.paper ? compare_with_paper(line, console) : compare_two(line, console);
}

int verify_verb(const CommandLine& line, const Console& console) {
    const run::Verification found = run::verify_run(line.subject);
    for (const run::Damage& damage : found.damages) {
        console.result(fmt::format("  {} {}", damage.file, damage.what));
    }
    const bool is_complete = found.missing.empty();
    console.result(fmt::format(
        "{}: {} against their checksums, {} against what their stages tell",
        !found.damages.empty() ? plural(std::ssize(found.damages), "difference")
        : is_complete          ? "whole and unchanged"
                               : "unchanged, but not complete",
        plural(found.files, "file"), plural(found.states, "state")
    ));
    if (!is_complete) {
        console.result(fmt::format("{}; suffuse resume {} goes on", found.missing, shell_word(line.subject)));
    }
    for (const std::string& name : found.more) {
        console.detail("came later: " + name);
    }
    if (!found.more.empty()) {
        console.talk(fmt::format("{} came after the checksums; -v lists them", plural(std::ssize(found.more), "file")));
    }
    console.document(json_text(found));
    return found.damages.empty() && is_complete ? Done : Differs;
}

} // namespace suffuse::apps
