#include "apps/run_ending.hpp"

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/plan/plan_record.hpp"
#include "suffuse/report/warnings.hpp"
#include "suffuse/study/finding.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/exit_code.hpp"
#include "apps/failures.hpp"
#include "apps/json_text.hpp"
#include "apps/stop_signal.hpp"
#include "apps/wording.hpp"
#include <algorithm>
#include <optional>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

/// "paper's findings: 3 of 7 met; met by noise: E6; not met by our number: E5; not met: E4, E7".
std::string findings_text(const nlohmann::json& findings) {
    std::vector<std::pair<std::string, std::vector<std::string>>> by_verdict;
    std::size_t met = 0;
    for (const nlohmann::json& finding : findings) {
        const std::string verdict = finding.at("verdict");
        if (verdict == study::name_of(study::Standing::Met)) {
            ++met;
            continue;
        }
        auto same = std::ranges::find(by_verdict, verdict, &decltype(by_verdict)::value_type::first);
        if (same == by_verdict.end()) {
            same = by_verdict.insert(same, {verdict, {}});
        }
        same->second.push_back(finding.at("id"));
    }
    std::string text = fmt::format("paper's findings: {} of {} met", met, findings.size());
    for (const auto& [verdict, ids] : by_verdict) {
        text += fmt::format("; {}: {}", verdict, fmt::join(ids, ", "));
    }
    return text + (by_verdict.empty() ? "" : "; suffuse compare RUN --paper says why");
}

std::string report_text(const fs::path& report) {
    std::error_code error;
    const auto bytes = fs::file_size(report, error);
    if (error) {
        return "no report";
    }
    return fmt::format("{}   ({}, opens offline)", report.string(), size_text(static_cast<double>(bytes)));
}

/// Of stages one after the other; samples side by side end sooner, as the plan at the start says.
std::string plan_error_text(const plan::PlanError& error) {
    return fmt::format(
        "Planned {}, took {}, all stages together.", duration_range_text(error.planned_seconds),
        duration_text(error.seconds)
    );
}

std::string plan_errors_in_full(const plan::PlanError& error) {
    return fmt::format(
        "The total differed by {:.0f} % from the middle of its range; {}, in the median, by {:.0f} %, and by {:.0f} % "
        "in steps",
        100 * error.of_all_seconds, plural(error.stages, "stage"), 100 * error.of_seconds, 100 * error.of_steps
    );
}

} // namespace

void print_results(const job::RunReport& report, const std::string& headline, const Console& console) {
    const std::vector<std::string> warnings = report::merged_warnings(report.warnings); // as the page has them
    for (const std::string& warning : warnings) {
        console.detail("warning: " + warning);
    }
    for (const std::string& flaw : report.flaws) {
        console.talk("flaw: " + flaw);
    }
    console.result(fmt::format("{}   {}", headline, report_text(report.report)));
    if (!warnings.empty()) {
        console.talk(fmt::format("{}, listed in the report", plural(std::ssize(warnings), "warning")));
    }
    if (!report.findings.empty()) {
        console.result(findings_text(report.findings));
    }
}

int exit_code_of(const job::RunReport& report) {
    switch (report.outcome) {
    case record::Outcome::Done:
        return Done;
    case record::Outcome::DoneWithFlaws:
        return Flawed;
    case record::Outcome::SomeFailed:
        return code_of(report.failures);
    case record::Outcome::Stopped:
        return signal_exit_code();
    case record::Outcome::TimeLimit:
        return OutOfTime;
    }
    throw Bug("an outcome without an exit code");
}

int report_end(const EndedRun& ended, const job::RunReport& report, const Console& console) {
    const std::string word(record::word_of(report.outcome));
    const bool has_failed = report.outcome == record::Outcome::SomeFailed;
    const int code = exit_code_of(report);
    if (!ended.sample.empty() && !record::is_resumable(report.outcome)) {
        console.result(fmt::format(
            "{}: {} in {}; suffuse sweep --collect {} gathers", ended.sample, word, duration_text(ended.seconds),
            shell_word(ended.folder.string())
        ));
    } else if (has_failed || code == Done || code == Flawed) {
        const std::string headline = fmt::format("{} in {}", word, duration_text(ended.seconds));
        print_results(report, ended.was_done ? word + " before; written again" : headline, console);
    } else {
        console.talk(fmt::format("{} after {}", word, duration_text(ended.seconds)));
        const std::string sample = ended.sample.empty() ? "" : " --sample " + shell_word(ended.sample);
        console.result(fmt::format("resume with: suffuse resume {}{}", shell_word(ended.folder.string()), sample));
    }
    const std::optional<plan::PlanError> plan_error =
        ended.sample.empty() ? plan::record_outcome(ended.folder) : std::nullopt;
    if (plan_error && !ended.was_done && !record::is_resumable(report.outcome)) {
        console.talk(plan_error_text(*plan_error));
        console.detail(plan_errors_in_full(*plan_error));
    }
    if (!report.failures.empty()) {
        print_failures(report.failures, ended.samples, ended.folder, console);
    }
    console.document(json_text(
        {{"outcome", word},
         {"exit_code", code},
         {"folder", ended.folder.string()},
         {"report", report.report.string()},
         {"wall_seconds", ended.seconds},
         {"warnings", report.warnings},
         {"flaws", report.flaws},
         {"failures", report.failures},
         {"findings", report.findings}}
    ));
    return code;
}

} // namespace suffuse::apps
