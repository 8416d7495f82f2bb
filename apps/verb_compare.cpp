// compare: what differs between two runs, or from the paper.

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/base/units.hpp"
#include "suffuse/job/calibration_folder.hpp"
#include "suffuse/job/compare_calibrations.hpp"
#include "suffuse/record/checksums.hpp"
#include "suffuse/record/compare_runs.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/stored.hpp"
#include "suffuse/study/finding.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/shared_options.hpp"
#include "apps/typed_value.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <vector>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

struct CompareVerb final : Verb {
    CompareVerb()
        : Verb(
              "compare", "show the differences between two runs, or from the paper's findings",
              "suffuse compare runs/dyke-0001 runs/dyke-0002 --tolerance 1%"
          ) {}

    std::string first, second; ///< folders of runs
    std::string tolerance;
    bool with_paper = false;

    void add_to(Options& options) override {
        options.argument("DIR", first, folder_text).required();
        options.argument("OTHER", second, "the folder of another run");
        options.value("--tolerance", tolerance, "up to which two numbers count as equal, as in 1%; by default 0")
            .type("SHARE");
        options.flag("--paper", with_paper, "with the paper's findings, instead of another run");
    }

    [[nodiscard]] int act(const CommandLine&, const Console& console) const override;
};

constexpr std::ptrdiff_t most_shown = 20; // without --verbose

/// The number with as many digits as distinguish the two, and two more.
std::string distinct_digits(const std::string& number, double relative) {
    const double digits = 2 + std::ceil(-std::log10(std::min(relative, 1.0)));
    return fmt::format(
        "{:.{}g}", std::strtod(number.c_str(), nullptr), static_cast<int>(std::clamp(digits, 4.0, 17.0))
    );
}

/// "number   2.900 and 3.100   6 %"
std::string row_of(const record::Difference& difference) {
    if (!difference.is_number) {
        return fmt::format("  {}   {} and {}\n", difference.where, difference.first, difference.second);
    }
    return fmt::format(
        "  {}   {} and {}   {:.3g} %\n", difference.where, distinct_digits(difference.first, difference.relative),
        distinct_digits(difference.second, difference.relative), 100 * difference.relative
    );
}

const char* heading_of(record::Relevance about) {
    switch (about) {
    case record::Relevance::Presence:
        return "in one of the runs only:";
    case record::Relevance::Result:
        return "results of stages:";
    case record::Relevance::Figure:
        return "numbers behind figures:";
    case record::Relevance::Computation:
        break;
    }
    return "how it was computed (not a result):";
}

std::string table_of(const std::vector<record::Difference>& differences, bool all) {
    const std::ptrdiff_t shown = all ? std::ssize(differences) : std::min(most_shown, std::ssize(differences));
    std::string text;
    for (std::ptrdiff_t k = 0; k < shown; ++k) {
        const record::Difference& difference = differences[static_cast<std::size_t>(k)];
        if (k == 0 || differences[static_cast<std::size_t>(k - 1)].about != difference.about) {
            text += fmt::format("{}\n", heading_of(difference.about));
        }
        text += row_of(difference);
    }
    if (shown < std::ssize(differences)) {
        text += fmt::format("  and {} more; -v lists them\n", std::ssize(differences) - shown);
    }
    return text;
}

/// The sentence of a comparison, before its table: whether the runs differ, in what, and by how much.
std::string verdict_on(const record::Comparison& found, double tolerance) {
    const std::string beyond = tolerance > 0 ? " beyond the tolerance" : "";
    const std::string states = fmt::format(
        "{} in both, {} with the same bits; {} compared", plural(found.stages, "stage"), found.same_states,
        plural(found.numbers, "number")
    );
    if (found.differences.empty()) {
        return fmt::format("no difference{}: {}", beyond, states);
    }
    const auto of_computation = std::ranges::count_if(found.differences, [](const record::Difference& difference) {
        return difference.about == record::Relevance::Computation;
    });
    const auto of_results = std::ssize(found.differences) - of_computation;
    if (of_results == 0) {
        return fmt::format(
            "the same results{}, with {} in how they were computed: {}", beyond, plural(of_computation, "difference"),
            states
        );
    }
    const record::Difference& first = found.differences.front();
    const auto largest = std::ranges::find_if(found.differences, [](const record::Difference& difference) {
        return difference.is_number && difference.about != record::Relevance::Computation;
    });
    return fmt::format(
        "the runs differ{} in {}, {}: {}", beyond, plural(of_results, "result"),
        largest != found.differences.end()
            ? fmt::format("by up to {:.3g} % ({})", 100 * largest->relative, largest->where)
            : fmt::format("the first is {}", first.where),
        states
    );
}

/// What is in each of two runs that share no stage: there is nothing else to say of them.
std::string nothing_shared(const CompareVerb& verb, const record::Comparison& found) {
    const auto list = [](const std::string& folder, const std::vector<std::string>& stages) {
        return fmt::format(
            "  {} has {}", folder, stages.empty() ? "no finished stage" : fmt::format("{}", fmt::join(stages, ", "))
        );
    };
    return fmt::format(
        "nothing to compare: no stage of the same study, sample and name is in both\n{}\n{}\nstages are compared by "
        "name, as in runs of one case with other values (--set)",
        list(verb.first, found.only_first), list(verb.second, found.only_second)
    );
}

double tolerance_of(const CompareVerb& verb) {
    const double tolerance =
        verb.tolerance.empty() ? 0 : quantity_of(verb.tolerance, dimension::none, "--tolerance", true);
    if (!(tolerance >= 0 && tolerance < 1)) {
        throw UsageError(fmt::format("--tolerance {}: from 0 to below 1, or as in 2%", shown(verb.tolerance)));
    }
    return tolerance;
}

int compare_two_calibrations(const CompareVerb& verb, const Console& console) {
    if (!job::is_calibration(verb.first) || !job::is_calibration(verb.second)) {
        throw UsageError("compare: one folder holds a calibration, the other a run; name two of a kind");
    }
    const record::Comparison found = job::compare_calibrations(verb.first, verb.second, tolerance_of(verb));
    console.result(fmt::format(
        "the calibrations differ in {} of {}", std::ssize(found.differences), plural(found.numbers, "number")
    ));
    for (const std::string& circumstance : found.circumstances) {
        console.result("  " + circumstance);
    }
    if (!found.differences.empty()) {
        console.result(table_of(found.differences, console.is_verbose()));
    }
    console.document(json_text(found));
    return found.differences.empty() ? Done : Differs;
}

int compare_two(const CompareVerb& verb, const Console& console) {
    const double tolerance = tolerance_of(verb);
    const record::Comparison found = record::compare_runs(verb.first, verb.second, tolerance);
    if (found.stages == 0) {
        console.result(nothing_shared(verb, found));
        console.document(json_text(found));
        return Differs;
    }
    console.result(verdict_on(found, tolerance));
    for (const std::string& circumstance : found.circumstances) {
        console.result("  " + circumstance);
    }
    console.result(table_of(found.differences, console.is_verbose()));
    console.document(json_text(found));
    return found.differences.empty() ? Done : Differs;
}

/// The lines of a finding: its verdict, the paper's words, our criterion and number, and why.
std::string finding_text(const nlohmann::json& finding) {
    const auto text = [&](const char* key) { return finding.value(key, std::string{}); };
    const nlohmann::json& met = finding.at("met");
    const std::string by_met = met.is_null() ? "cannot tell" : met.get<bool>() ? "met" : "not met";
    std::string out = fmt::format(
        "{:4}{}\n    paper      {}\n    criterion  {}", text("id"), finding.value("verdict", by_met), text("paper"),
        text("claim")
    );
    if (const auto ours = finding.value("our_numbers", std::vector<std::string>{}); !ours.empty()) {
        out += fmt::format("\n    our number {}", fmt::join(ours, ", "));
    }
    out += "\n    here       " + text("ours");
    return out + (text("why").empty() ? "" : "\n    why        " + text("why"));
}

int print_findings(const nlohmann::json& findings, const Console& console) {
    bool all_met = true; // as far as the run can tell; agreement by noise is none
    for (const nlohmann::json& finding : findings) {
        const bool by_noise = finding.value("verdict", "") == study::name_of(study::Standing::MetByNoise);
        all_met = all_met && finding.at("met") != false && !by_noise;
        console.result(finding_text(finding));
    }
    if (findings.empty()) {
        console.result("the run has no results that the paper has findings about");
    }
    console.document(json_text({{"findings", findings}}));
    return all_met ? Done : Differs;
}

int compare_with_paper(const CompareVerb& verb, const Console& console) {
    const fs::path summary = fs::path(verb.first) / "summary.json";
    if (!fs::exists(summary)) {
        throw IoError(
            fmt::format("{}: has no summary.json: the run has not ended; continue it with suffuse resume", verb.first)
        );
    }
    record::require_same_result(verb.first, "summary.json");
    const nlohmann::json stored = record::read_json(summary);
    return record::take_from(summary, [&] { return print_findings(stored.at("findings"), console); });
}

int CompareVerb::act(const CommandLine&, const Console& console) const {
    if (with_paper == !second.empty()) {
        throw UsageError("compare: two folders of runs, or one and --paper");
    }
    for (const std::string& run : {first, second}) {
        look_at_run(run, io::Purpose::Read, console);
    }
    if (!with_paper && (job::is_calibration(first) || job::is_calibration(second))) {
        return compare_two_calibrations(*this, console);
    }
    return with_paper ? compare_with_paper(*this, console) : compare_two(*this, console);
}

} // namespace

MadeVerb make_compare_verb() {
    return std::make_unique<CompareVerb>();
}

} // namespace suffuse::apps
