#include "suffuse/answer/strength_words.hpp"

#include "suffuse/answer/plain_numbers.hpp"
#include "suffuse/base/constants.hpp"
#include "suffuse/base/student.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/study/trace_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace suffuse::answer {
namespace {
using study::with_scatter;

constexpr std::size_t most_reported = 3; ///< changes, each in a sentence of its own
constexpr int few_samples = 3;
constexpr double notable_chance = 0.05;
constexpr double kilo = 1e3, percent = 100, degree = radians(1);

const char* const title_of_table = "Strength before and after";

/// "+5 %", "−21 ± 3 %".
std::string change_in_percent(const study::BeforeAfter& value) {
    const double mean = percent * value.change.mean;
    const std::string sign = mean > 0 ? "+" : "";
    if (value.change.seeds < 2) {
        return sign + short_number(mean, 2) + " %";
    }
    return fmt::format(
        "{}{} ± {} %", sign, short_number(mean, 2), short_number(percent * value.change.standard_deviation, 2)
    );
}

/// "322.8 to 256 kPa".
std::string from_to(const study::BeforeAfter& value, double unit, int digits, const char* name) {
    return fmt::format(
        "{} to {}{}", short_number(value.before.mean / unit, digits), short_number(value.after.mean / unit, digits),
        name
    );
}

std::string values_of(const study::StrengthChange& change) {
    const std::string name = study::values_name(*change.study, *change.variant);
    return name.empty() ? "" : ", " + name;
}

std::string tests_of(const study::StrengthChange& change) {
    return fmt::format("“{}” against “{}”{}", change.after->name, change.before->name, values_of(change));
}

std::string verdict_of(const study::StrengthChange& change) {
    const std::optional<bool> weaker = change.is_weaker();
    if (weaker) {
        return *weaker ? "is weaker" : "is not weaker but stronger";
    }
    const int samples = change.borne().change.seeds;
    return samples == 0   ? "cannot be compared"
           : samples == 1 ? "shows no change of strength beyond what samples usually differ by"
                          : "shows no change of strength beyond the scatter of samples";
}

std::string remarks_of(const study::StrengthChange& change, const char* between) {
    std::string text;
    for (const std::string& remark : change.remarks) {
        text += (text.empty() ? "" : between) + remark;
    }
    return text;
}

double end_strain(const study::StrengthChange& change) {
    return std::get<triaxial::TriaxialSpec>(change.after->spec).strain;
}

/// Probability that as many samples of a soil that does not change differ as clearly.
double by_chance(const study::Scatter& change) {
    const double t = std::abs(change.mean) * std::sqrt(change.seeds) / change.standard_deviation;
    return 1 - student_within(t, static_cast<std::size_t>(change.seeds - 1));
}

/// How many samples a verdict rests on, and what that is worth.
std::string how_sure(const study::StrengthChange& change) {
    const int samples = change.borne().change.seeds;
    if (samples < 2) {
        return samples == 0              ? ""
               : change.holds_deviator() ? " One sample: in others it may differ by about 50 %."
                                         : " One sample: the strengths of others may differ by about 10 %.";
    }
    std::string text = fmt::format(" Means of {} samples, ± one standard deviation", samples);
    if (change.is_weaker() && samples <= few_samples && by_chance(change.borne().change) > notable_chance) {
        text += fmt::format(
            "; with so few samples, scatter alone gives as clear a change in {} % of the cases",
            short_number(percent * by_chance(change.borne().change), 2)
        );
    }
    return text + ".";
}

/// "dilates by 9 %", "contracts by 3 %".
std::string volume_in_words(double strain) {
    const double value = percent * strain;
    return is_noise(value)
               ? "keeps its volume"
               : fmt::format("{} by {} %", value < 0 ? "dilates" : "contracts", short_number(std::abs(value), 2));
}

/// The stress at a strain, and what is left in the critical state.
std::string describe_beyond_peak(const study::StrengthChange& change) {
    std::string text;
    if (change.deviator_at_strain.change.seeds > 0) {
        text += fmt::format(
            ", the deviator stress at {} % axial strain from {} ({})", short_number(percent * change.reading_strain, 3),
            from_to(change.deviator_at_strain, kilo, 4, " kPa"), change_in_percent(change.deviator_at_strain)
        );
    }
    if (change.residual_deviator.change.seeds > 0) {
        text += fmt::format(
            ", and the critical-state strength, near {} %, from {} ({})", short_number(percent * end_strain(change), 3),
            from_to(change.residual_deviator, kilo, 4, " kPa"), change_in_percent(change.residual_deviator)
        );
    }
    return text;
}

std::string describe_change(const study::StrengthChange& change) {
    std::string text = fmt::format(
        "Strength, {}: the soil without {} % of its mass {}", tests_of(change),
        with_scatter(change.removed_mass, percent, 3), verdict_of(change)
    );
    if (change.peak_deviator.change.seeds > 0) {
        text += fmt::format(
            ". Its highest deviator stress goes from {} ({})", from_to(change.peak_deviator, kilo, 4, " kPa"),
            change_in_percent(change.peak_deviator)
        );
    }
    if (change.pore_pressure.change.seeds > 0) {
        text += fmt::format(
            ". With the deviator stress held, the excess pore pressure that it bears goes from {} ({})",
            from_to(change.pore_pressure, kilo, 3, " kPa"), change_in_percent(change.pore_pressure)
        );
    }
    if (change.friction_angle.change.seeds > 0) {
        text += ", the friction angle there from " + from_to(change.friction_angle, degree, 3, "°");
    }
    text += describe_beyond_peak(change);
    text += fmt::format(
        "{} from {}.", change.borne().change.seeds > 0 ? ", the void ratio" : "; the void ratio goes",
        from_to(change.void_ratio, 1, 3, "")
    );
    if (change.volume_change.change.seeds > 0) {
        text += fmt::format(
            " Sheared to the end, the sample {} before and {} after.",
            volume_in_words(change.volume_change.before.mean), volume_in_words(change.volume_change.after.mean)
        );
    }
    if (const std::string remarks = remarks_of(change, "; "); !remarks.empty()) {
        text += " " + as_sentence(remarks) + ".";
    }
    return text + how_sure(change);
}

/// "; WHAT changes by −30 to +5 %"; empty where no two tests give it.
std::string range_of(
    const std::vector<study::StrengthChange>& changes, study::BeforeAfter study::StrengthChange::*value,
    const char* what
) {
    double least = INFINITY, most = -INFINITY;
    for (const study::StrengthChange& change : changes) {
        if (const study::Scatter& by = (change.*value).change; by.seeds > 0) {
            least = std::min(least, by.mean), most = std::max(most, by.mean);
        }
    }
    return least > most ? ""
                        : fmt::format(
                              "; {} changes by {}{} to {}{} %", what, least > 0 ? "+" : "",
                              short_number(percent * least, 2), most > 0 ? "+" : "", short_number(percent * most, 2)
                          );
}

/// Of many: how many fared how.
std::string describe_all(const std::vector<study::StrengthChange>& changes) {
    std::size_t weaker = 0, stronger = 0, unknown = 0;
    for (const study::StrengthChange& change : changes) {
        unknown += change.borne().change.seeds == 0 ? 1 : 0;
        weaker += change.is_weaker() == true ? 1 : 0;
        stronger += change.is_weaker() == false ? 1 : 0;
    }
    const std::string text = fmt::format(
        "Of {} comparisons of a test before and after the loss of fines (table “{}”), {} find the soil weaker, {} "
        "stronger, and {} no change beyond the scatter of samples{}",
        changes.size(), title_of_table, weaker, stronger, changes.size() - weaker - stronger - unknown,
        unknown > 0 ? fmt::format("; {} cannot be compared", unknown) : ""
    );
    return text + range_of(changes, &study::StrengthChange::peak_deviator, "the highest deviator stress") +
           range_of(changes, &study::StrengthChange::pore_pressure, "the excess pore pressure borne") + ".";
}

/// A column of the table of changes.
struct Column {
    std::string header;
    std::function<std::string(const study::StrengthChange&)> cell;
    bool is_numeric = true;
};

std::string tests_in_table(const study::StrengthChange& change) {
    return fmt::format("{}{}: {}, {}", change.study->name, values_of(change), change.before->name, change.after->name);
}

std::string strain_in_table(const study::StrengthChange& change) {
    return change.deviator_at_strain.before.seeds > 0 ? " at " + short_number(percent * change.reading_strain, 3) + " %"
                                                      : "";
}

/// Those that some test has something to say in.
std::vector<Column> columns_of(const std::vector<study::StrengthChange>& changes) {
    using study::StrengthChange;
    std::vector<Column> columns = {
        {"tests", tests_in_table, false},
        {"samples", [](const StrengthChange& c) { return std::to_string(c.borne().change.seeds); }},
        {"mass gone [%]", [](const StrengthChange& c) { return with_scatter(c.removed_mass, percent, 3); }}};
    const auto pair = [&](const char* header, study::BeforeAfter StrengthChange::*value, double unit, int digits) {
        columns.push_back({header, [=](const StrengthChange& c) {
                               const auto& [before, after, change] = c.*value;
                               return before.seeds > 0 ? fmt::format(
                                                             "{} → {}", short_number(before.mean / unit, digits),
                                                             short_number(after.mean / unit, digits)
                                                         )
                                                       : std::string("–");
                           }});
    };
    const auto change = [&](study::BeforeAfter StrengthChange::*value) {
        columns.push_back({"change [%]", [=](const StrengthChange& c) {
                               return with_scatter((c.*value).change, percent, 2);
                           }});
    };
    pair("void ratio e [-]", &StrengthChange::void_ratio, 1, 3);
    if (!std::ranges::all_of(changes, &StrengthChange::holds_deviator)) {
        pair("highest q [kPa]", &StrengthChange::peak_deviator, kilo, 4);
        change(&StrengthChange::peak_deviator);
        pair("friction angle φ there [°]", &StrengthChange::friction_angle, degree, 3);
        pair("q at a strain [kPa]", &StrengthChange::deviator_at_strain, kilo, 4);
        columns.back().cell = [cell = columns.back().cell](const StrengthChange& c) {
            return cell(c) + strain_in_table(c);
        };
        change(&StrengthChange::deviator_at_strain);
        if (std::ranges::any_of(changes, [](const auto& c) { return c.residual_deviator.before.seeds > 0; })) {
            pair("q left in the critical state [kPa]", &StrengthChange::residual_deviator, kilo, 4);
            change(&StrengthChange::residual_deviator);
        }
        pair("εᵥ at the end [%]", &StrengthChange::volume_change, 1 / percent, 2);
    }
    if (std::ranges::any_of(changes, &StrengthChange::holds_deviator)) {
        pair("excess pore pressure borne [kPa]", &StrengthChange::pore_pressure, kilo, 3);
        change(&StrengthChange::pore_pressure);
    }
    if (changes.size() > most_reported) { // of few, a sentence each describes them
        columns.push_back(
            {"remarks", [](const StrengthChange& c) { return c.remarks.empty() ? "–" : remarks_of(c, "; "); }, false}
        );
    }
    return columns;
}

} // namespace

std::vector<std::string> strength_sentences(const std::vector<study::StrengthChange>& changes) {
    if (changes.size() > most_reported) {
        return {describe_all(changes)};
    }
    std::vector<std::string> sentences;
    sentences.reserve(changes.size());
    for (const study::StrengthChange& change : changes) {
        sentences.push_back(describe_change(change));
    }
    return sentences;
}

std::optional<Headline> strength_headline(const std::vector<study::StrengthChange>& changes) {
    const auto reported =
        std::ranges::find_if(changes, [](const study::StrengthChange& c) { return c.borne().change.seeds > 0; });
    if (reported == changes.end() || changes.size() > most_reported) {
        return std::nullopt;
    }
    const study::BeforeAfter& borne = reported->borne();
    Headline headline{
        change_text(borne.change.mean), reported->holds_deviator() ? "Pore pressure borne" : "Peak strength",
        fmt::format("{} to {} kPa", fixed(borne.before.mean / kilo, 0), fixed(borne.after.mean / kilo, 0)),
        spread_text(borne.change, percent, std::min(1, decimals_for(percent * borne.change.mean, 2)))};
    if (borne.change.seeds < 2) {
        headline.detail += fmt::format("; samples differ by some {} %", reported->holds_deviator() ? 50 : 10);
    }
    return with_certainty(std::move(headline), borne.change);
}

std::optional<figures::PageTable> tabulate_strength(const std::vector<study::StrengthChange>& changes) {
    if (changes.empty()) {
        return std::nullopt;
    }
    figures::PageTable table;
    table.section = "Tests";
    table.title = title_of_table;
    table.note = "The same test on the same sample, before and after the loss of fines; changes are those of each "
                 "sample, ± one standard deviation over the samples. Void ratio: before the loss, and at the start of "
                 "the second test. Critical state: over the last 10 % of axial strain neither volume nor stress "
                 "changes further. Contraction positive. Laboratories found eroded soil more contractive than before "
                 "(Chen, Zhang and Chang 2016) and slightly more dilative (hal-02608716).";
    table.rows.resize(changes.size());
    for (const Column& column : columns_of(changes)) {
        table.header.push_back(column.header);
        table.numeric.push_back(column.is_numeric);
        for (std::size_t k = 0; k < changes.size(); ++k) {
            table.rows[k].push_back(column.cell(changes[k]));
        }
    }
    return table;
}

} // namespace suffuse::answer
