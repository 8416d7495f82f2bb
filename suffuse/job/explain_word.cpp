#include "suffuse/job/explain_word.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/casefile/explain.hpp"
#include "suffuse/figures/figure_guide.hpp"
#include "suffuse/stability/criterion_guide.hpp"
#include "suffuse/study/finding_guide.hpp"
#include "suffuse/study/findings_fines.hpp"

#include <fmt/format.h>

namespace suffuse::job {
namespace {

/// The paper's findings, as they are judged of a run that has nothing: their claims are the same.
std::vector<study::Finding> all_findings() {
    std::vector<study::Finding> findings = study::judge_erosion({}, {});
    const study::StageCurve nothing;
    for (study::Finding& finding : study::judge_fines(&nothing, &nothing, {})) {
        findings.push_back(std::move(finding));
    }
    return findings;
}

std::optional<std::string> explain_finding(const std::string& id) {
    for (const study::Finding& finding : all_findings()) {
        if (finding.id == id) {
            const std::string numbers = list_our_numbers(finding);
            return fmt::format(
                "finding {} of the paper\n  paper     {}\n  met when  {}\n  ours      {}\n  why       {}\n"
                "  judged    where a case has a `paper` line: its report, and suffuse compare RUN --paper, which say "
                "why of their run\n",
                finding.id, finding.paper, finding.claim,
                numbers.empty() ? "no number: all are the paper's words"
                                : numbers + ": our choice, because the paper gives none",
                study::background_of(finding.id)
            );
        }
    }
    return std::nullopt;
}

} // namespace

std::string explain_word(const std::string& word) {
    if (const auto text = casefile::explain(word)) {
        return *text;
    }
    if (const auto text = figures::explain_figure(word)) {
        return *text;
    }
    if (const auto text = stability::explain_criterion(word)) {
        return *text;
    }
    if (const auto text = explain_finding(word)) {
        return *text;
    }
    auto nearest = nearest_word(word, explained_words());
    if (!nearest) {
        nearest = casefile::nearest_key(word);
    }
    throw UsageError(fmt::format(
        "nothing is known about {}; {}", shown(word),
        nearest ? fmt::format("a similar word: suffuse explain {}", *nearest)
                : "suffuse schema lists all keys of a case; its tables (contact), verbs (erode), codes (E310), figures "
                  "(figure-9), findings (E4) and criteria (kezdi-1979) are known too"
    ));
}

std::vector<std::string> explained_words() {
    std::vector<std::string> words = casefile::topics();
    for (const auto& more : {figures::figure_names(), stability::criterion_ids()}) {
        words.insert(words.end(), more.begin(), more.end());
    }
    for (const study::Finding& finding : all_findings()) {
        words.push_back(finding.id);
    }
    return words;
}

} // namespace suffuse::job
