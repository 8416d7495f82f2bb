#include "suffuse/answer/filter_words.hpp"

#include "suffuse/answer/migration_words.hpp"
#include "suffuse/answer/plain_numbers.hpp"
#include "suffuse/base/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace suffuse::answer {
namespace {

using erosion::MigrationHold;
using erosion::MigrationResult;
using record::FinishedStage;

constexpr std::size_t most_stages = 3, doubts_in_note = 2, most_listed = 60;

/// At the last gradient: an earlier hold that was cut bounds its own number alone.
bool has_ended(const MigrationResult& result) {
    return result.holds.back().ended;
}

std::string ratio_text(const FinishedStage& stage) {
    const erosion::FilterView& view = migration_of(stage).filter;
    return short_number(view.filter_d15 / view.base_d85, 2);
}

std::string millimeters(double length) {
    return short_number(1e3 * length, 2) + " mm";
}

FilterVerdict verdict_on(const FinishedStage& stage) {
    return judge_filter(migration_of(stage).filter.passed, has_ended(migration_of(stage)));
}

/// "nothing passed", "27 % passed" or, of a base with a gap, "27 % of the grains below its gap passed".
std::string passed_text(const FinishedStage& stage) {
    const erosion::FilterView& view = migration_of(stage).filter;
    return view.passed > 0
               ? fmt::format(
                     "{} {}passed", percent_text(view.passed), view.base_gap ? "of the grains below its gap " : ""
                 )
               : "nothing passed";
}

/// "the filter holds: nothing passed, the base came 1.5 mm deep, and motion ended."
std::string short_answer(const FinishedStage& stage) {
    const MigrationHold& end = last_hold(stage);
    const bool ended = has_ended(migration_of(stage));
    return fmt::format(
        "{}: {}, the base came {} deep, and {}.", words_of(verdict_on(stage)), passed_text(stage),
        millimeters(end.depth), ended ? "motion ended" : percent_text(end.moving_mass_share) + " still moves"
    );
}

/// The base is softer by the same factor as its contacts, and bears that much less.
void doubt_stress(const FinishedStages& stages, std::vector<Doubt>& doubts) {
    const FinishedStage& stage = *stages.front();
    const double base = stage.numbers.at("stack").at("base_stress"), mean = stage.numbers.at("mean_stress");
    doubts.push_back(
        {1.5, fmt::format(
                  "The base bears {} Pa, and not the {} kPa of the sample: this is a filter test without a load.",
                  short_number(base, 2), short_number(mean / 1e3, 2)
              )}
    );
}

void doubt_scatter(const FinishedStages& stages, std::vector<Doubt>& doubts) {
    const FinishedStage& stage = *stages.front();
    if (stage.study->replicates < 2) {
        doubts.push_back(
            {2, fmt::format(
                    "Each stack is one small sample. For the scatter: `--set study.{}.replicates=3`.", stage.study->name
                )}
        );
    }
}

std::string hold_text(const MigrationResult& result) {
    const double seconds = result.rows.empty() ? 0 : result.rows.back().time;
    return short_number(seconds, 2) + (has_ended(result) ? "" : ", cut");
}

} // namespace

FilterVerdict judge_filter(double lost, bool ended) {
    if (lost > most_lost) {
        return FilterVerdict::LetsPass;
    }
    if (!ended) {
        return FilterVerdict::Undecided;
    }
    return lost > 0 ? FilterVerdict::HoldsAfterLoss : FilterVerdict::Holds;
}

std::string_view words_of(FilterVerdict verdict) {
    switch (verdict) {
    case FilterVerdict::Holds:
        return "the filter holds";
    case FilterVerdict::HoldsAfterLoss:
        return "the filter holds after a loss";
    case FilterVerdict::Undecided:
        return "this run does not decide";
    case FilterVerdict::LetsPass:
        return "the filter lets the base pass";
    }
    return "";
}

FinishedStages filter_stages(const std::vector<FinishedStage>& stages) {
    FinishedStages found;
    for (const FinishedStage& stage : stages) {
        const auto& migration = stage.findings.migration;
        if (migration && migration->filter.filter_d15 > 0 && !migration->holds.empty()) {
            found.push_back(&stage);
        }
    }
    return found;
}

std::vector<std::string> filter_verdict(const FinishedStages& stages) {
    if (stages.size() > most_stages) {
        const auto count = [&](FilterVerdict verdict) {
            return std::ranges::count(stages, verdict, [](const FinishedStage* stage) { return verdict_on(*stage); });
        };
        return {
            fmt::format("The filter holds in {} of {} samples.", count(FilterVerdict::Holds), stages.size()),
            fmt::format(
                "It holds after a loss in {}, lets the base pass in {}, and {} are not decided.",
                count(FilterVerdict::HoldsAfterLoss), count(FilterVerdict::LetsPass), count(FilterVerdict::Undecided)
            )};
    }
    std::vector<std::string> sentences;
    for (const FinishedStage* stage : stages) {
        sentences.push_back(fmt::format("At D15/d85 = {} {}", ratio_text(*stage), short_answer(*stage)));
    }
    return sentences;
}

std::vector<std::string> filter_doubts(const FinishedStages& stages) {
    std::vector<Doubt> doubts;
    doubt_end(stages, doubts);
    doubt_overlap(stages, "A larger `modulus`, or a smaller `pressure` of the compaction, mends that.", doubts);
    doubt_scatter(stages, doubts);
    doubt_stress(stages, doubts);
    return largest_of(std::move(doubts));
}

std::vector<Headline> filter_headlines(const FinishedStages& stages) {
    std::vector<Headline> cards;
    for (const FinishedStage* stage : stages) {
        if (cards.size() == most_stages) {
            break;
        }
        const MigrationHold& end = last_hold(*stage);
        const erosion::FilterView& view = migration_of(*stage).filter;
        const bool ended = has_ended(migration_of(*stage));
        Headline card{
            percent_text(view.passed), fmt::format("Passed at D15/d85 = {}", ratio_text(*stage)),
            fmt::format(
                "{}{} beyond the interface, {} deep",
                view.base_gap ? "of the grains below the base's gap; of the base " : "",
                percent_text(end.entered_mass_share), millimeters(end.depth)
            )};
        card.lead = ended || view.passed == 0 ? "" : "at least";
        card.caution = ended ? "" : percent_text(end.moving_mass_share) + " of the base still moved at the end.";
        cards.push_back(std::move(card));
    }
    return cards;
}

std::optional<figures::PageTable> tabulate_filters(const std::vector<FinishedStage>& stages) {
    const FinishedStages found = filter_stages(stages);
    if (found.empty()) {
        return std::nullopt;
    }
    figures::PageTable table;
    table.section = "Filter";
    table.title = "Whether the filter holds";
    std::vector<std::string> sentences = filter_verdict(found), doubts = filter_doubts(found);
    doubts.resize(std::min(doubts.size(), doubts_in_note));
    table.note = fmt::format(
        "{} The largest doubts: {} Passed: of the mass of the base that can move, which is all but a screen where the "
        "water enters; across the exit. Up to {} of it counts as a loss after which a filter holds. Of a base with a "
        "gap, both D15/d85 and what passed are of the grains below the gap. "
        "Constriction: Kenney's, the largest sphere that finds a way through the filter.",
        fmt::join(sentences, " "), fmt::join(doubts, " "), percent_text(most_lost)
    );
    table.header = {
        "sample",
        "D15/d85 [-]",
        "gradient of the base [-]",
        "time [s]",
        "passed",
        "still moving",
        "beyond the interface",
        "depth [mm]",
        "constriction/D15 [-]",
        "largest that passed [mm]",
        "verdict"};
    table.numeric.assign(table.header.size(), true);
    table.numeric.front() = table.numeric.back() = false;
    for (const FinishedStage* stage : found) {
        if (table.rows.size() == most_listed) {
            break;
        }
        const MigrationHold& end = last_hold(*stage);
        const erosion::FilterView& view = migration_of(*stage).filter;
        table.rows.push_back(
            {stage->name(), ratio_text(*stage), short_number(end.gradient), hold_text(migration_of(*stage)),
             percent_text(view.passed), percent_text(end.moving_mass_share), percent_text(end.entered_mass_share),
             short_number(1e3 * end.depth, 2), short_number(view.constriction / view.filter_d15, 2),
             view.largest_eroded > 0 ? short_number(1e3 * view.largest_eroded, 2) : "–",
             std::string(words_of(verdict_on(*stage)))}
        );
    }
    return table;
}

} // namespace suffuse::answer
