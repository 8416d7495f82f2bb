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

constexpr std::size_t most_named = 3, most_rows = 60;
constexpr double one_look = 1.5; // of `still_for`

double left_share(const FinishedStage& stage) {
    return share_of_own(migration_of(stage)) * last_hold(stage).eroded_mass_share;
}

double highest_gradient(const MigrationResult& result) {
    return std::ranges::max_element(result.holds, {}, &MigrationHold::gradient)->gradient;
}

double seconds_of(const MigrationResult& result) {
    return result.rows.empty() ? 0 : result.rows.back().time;
}

/// "12 % still move at the end", "motion ended". The first look sees what moved at all since the hold began.
std::string motion_text(const FinishedStage& stage) {
    const MigrationHold& last = last_hold(stage);
    const auto* spec = std::get_if<erosion::MigrateSpec>(&stage.stage->spec);
    const bool is_one_look = spec != nullptr && last.held_for < one_look * spec->still_for;
    return last.ended ? "motion ended"
                      : percent_text(share_of_own(migration_of(stage)) * last.moving_mass_share) +
                            (is_one_look ? " moved, in a hold too short to see motion end" : " still move at the end");
}

/// "water up to i = 0.6 carries out 14 % of the fines in 3 s; 12 % still move at the end."
std::string what_left(const FinishedStage& stage) {
    const double left = left_share(stage);
    return fmt::format(
        "water up to i = {} carries out {} of the fines in {} s; {}.",
        short_number(highest_gradient(migration_of(stage))), left > 0 ? percent_text(left) : "none",
        short_number(seconds_of(migration_of(stage)), 2), motion_text(stage)
    );
}

/// The way of one grain, of which the ledger and the view in 3D have more; empty where none passed a throat.
std::string story_text(const FinishedStage& stage) {
    constexpr std::size_t most_holders = 6;
    const erosion::GrainStory& story = migration_of(stage).story;
    if (story.throats == 0) {
        return {};
    }
    const std::size_t named = std::min(story.holders.size(), most_holders);
    const std::string end =
        story.left >= 0 ? fmt::format("It left after {} s", short_number(story.left))
        : story.moves   ? "It still moved at the end"
        : named == 0
            ? "It lies free"
            : fmt::format(
                  "It came to rest at {} {}{}", named == 1 ? "grain" : "grains",
                  fmt::join(story.holders.begin(), story.holders.begin() + static_cast<std::ptrdiff_t>(named), ", "),
                  named < story.holders.size() ? " and others" : ""
              );
    return fmt::format(
        "The farthest way through {}: grain {}, {} mm wide, left its place under i = {} after {} s. It passed {} {}, "
        "the "
        "narrowest {} mm wide, and went {} mm. {}.",
        stage.name(), story.id, short_number(1e3 * story.diameter), short_number(story.gradient),
        short_number(story.departed), story.throats, story.throats == 1 ? "throat" : "throats",
        short_number(1e3 * story.narrowest), short_number(1e3 * story.way), end
    );
}

/// "hold_at_most=8 s": the key of the limit that cut the last hold, four times as large.
std::string longer_limit(const erosion::MigrateSpec& spec, const MigrationResult& result) {
    constexpr int longer = 4;
    const MigrationHold& last = result.holds.back();
    const std::string_view key = name_of(last.ended_by);
    switch (last.ended_by) {
    case erosion::HoldEnd::TimeLimit:
        return fmt::format("{}={:.2g} s", key, longer * spec.time_at_most.value());
    case erosion::HoldEnd::StepLimit:
        return fmt::format("{}={}", key, longer * spec.steps_at_most.value());
    default:
        return fmt::format("hold_at_most={:.2g} s", longer * last.held_for);
    }
}

} // namespace

FinishedStages migration_stages(const std::vector<FinishedStage>& stages) {
    FinishedStages found;
    for (const FinishedStage& stage : stages) {
        const auto& migration = stage.findings.migration;
        if (migration && migration->filter.filter_d15 == 0 && !migration->holds.empty()) {
            found.push_back(&stage);
        }
    }
    return found;
}

std::vector<std::string> migration_verdict(const FinishedStages& stages) {
    if (stages.size() > most_named) {
        const auto [least, most] = std::ranges::minmax(stages, {}, [](auto* stage) { return left_share(*stage); });
        const auto moving = std::ranges::count_if(stages, [](auto* stage) { return !last_hold(*stage).ended; });
        return {
            fmt::format(
                "Water carries out {} to {} of the fines in {} simulations.", percent_text(left_share(*least)),
                percent_text(left_share(*most)), stages.size()
            ),
            moving == 0 ? "Motion ended in all of them."
                        : fmt::format("In {} of them fines still moved at the end.", moving)};
    }
    std::vector<std::string> sentences;
    for (const FinishedStage* stage : stages) {
        const std::string answer = what_left(*stage);
        sentences.push_back(stages.size() == 1 ? as_sentence(answer) : fmt::format("{}: {}", stage->name(), answer));
    }
    return sentences;
}

std::vector<std::string> migration_doubts(const FinishedStages& stages) {
    std::vector<Doubt> doubts;
    doubt_end(stages, doubts);
    doubt_overlap(stages, "A smaller `softness` mends that.", doubts);
    return largest_of(std::move(doubts));
}

std::vector<Headline> migration_headlines(const FinishedStages& stages) {
    std::vector<Headline> cards;
    for (const FinishedStage* stage : stages) {
        if (cards.size() == most_named) {
            break;
        }
        const double left = left_share(*stage);
        Headline card{
            left > 0 ? percent_text(left) : "none",
            fmt::format("Of the fines leave up to i = {}", short_number(highest_gradient(migration_of(*stage)))),
            fmt::format(
                "“{}”, in {} s; permeability × {}", stage->name(), short_number(seconds_of(migration_of(*stage)), 2),
                short_number(permeability_change(*stage))
            )};
        card.lead = last_hold(*stage).ended || left == 0 ? "" : "at least";
        card.caution = last_hold(*stage).ended ? "" : motion_text(*stage) + ".";
        cards.push_back(std::move(card));
    }
    return cards;
}

std::optional<figures::PageTable> tabulate_migrations(const std::vector<FinishedStage>& stages) {
    const FinishedStages found = migration_stages(stages);
    if (found.empty()) {
        return std::nullopt;
    }
    figures::PageTable table;
    table.section = "Erosion";
    table.title = "Fines that leave";
    table.note = "Shares are of the mass of the fines that were there before, with what the water brought. A hold that "
                 "was cut bounds what leaves from below.";
    if (const std::string story = story_text(*found.front()); !story.empty()) {
        table.note += " " + story;
    }
    table.header = {"sample", "gradient [-]", "held [s]", "left", "still moving", "permeability [m²]", "motion"};
    table.numeric.assign(table.header.size(), true);
    table.numeric.front() = table.numeric.back() = false;
    for (const FinishedStage* stage : found) {
        const double own = share_of_own(migration_of(*stage));
        for (const MigrationHold& hold : migration_of(*stage).holds) {
            if (table.rows.size() < most_rows) {
                table.rows.push_back(
                    {stage->name(), short_number(hold.gradient), short_number(hold.held_for, 2),
                     percent_text(own * hold.eroded_mass_share), percent_text(own * hold.moving_mass_share),
                     short_number(hold.permeability), hold.ended ? "ended" : "cut"}
                );
            }
        }
    }
    return table;
}

const MigrationResult& migration_of(const FinishedStage& stage) {
    return *stage.findings.migration;
}

const MigrationHold& last_hold(const FinishedStage& stage) {
    return migration_of(stage).holds.back();
}

double permeability_change(const FinishedStage& stage) {
    return stage.numbers.at("permeability_after").get<double>() / stage.numbers.at("permeability_before").get<double>();
}

void doubt_end(const FinishedStages& stages, std::vector<Doubt>& doubts) {
    // At the last gradient: an earlier hold that was cut bounds its own number alone.
    const auto cut = std::ranges::find_if(stages, [](const FinishedStage* stage) { return !last_hold(*stage).ended; });
    if (cut == stages.end()) {
        return;
    }
    const casefile::Stage& stage = *(*cut)->stage;
    doubts.push_back(
        {10, fmt::format(
                 "Motion had not ended after {} s: what left is a lower bound. To hold longer: `--set "
                 "'study.{}.stage.{}.{}'`.",
                 short_number(last_hold(**cut).held_for, 2), (*cut)->study->name, stage.name,
                 longer_limit(std::get<erosion::MigrateSpec>(stage.spec), migration_of(**cut))
             )}
    );
}

void doubt_overlap(const FinishedStages& stages, const std::string& remedy, std::vector<Doubt>& doubts) {
    constexpr double wide = 0.05;
    double overlap = 0;
    for (const FinishedStage* stage : stages) {
        overlap = std::max(overlap, stage->numbers.at("largest_overlap").get<double>());
    }
    if (overlap > wide) {
        doubts.push_back(
            {overlap / wide,
             fmt::format("Grains that moved overlapped by up to {} of a radius. {}", percent_text(overlap), remedy)}
        );
    }
}

} // namespace suffuse::answer
