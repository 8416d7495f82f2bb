#include "suffuse/study/findings_fines.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/study/fines_reason.hpp"
#include "suffuse/study/seed_verdicts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace suffuse::study {
namespace {

std::string percent(double share) {
    return short_number(100 * share, 3);
}

/// "12.3 ± 0.4 %"; the scatter only where there are seeds that have one.
std::string percent_of(const Scatter& scatter) {
    if (scatter.seeds == 0) {
        return "not found";
    }
    return with_scatter(scatter, 100, 3) + " %";
}

Scatter scatter_at(const ContentCurve& curve, double content) {
    std::vector<double> of_seed;
    for (std::size_t s = 0; s < curve.seed.size(); ++s) {
        of_seed.push_back(value_at(curve, s, content).value_or(std::nan("")));
    }
    return scatter_of(std::move(of_seed));
}

using Judge = std::function<Verdict(std::size_t)>; ///< of a seed

std::vector<Verdict> verdicts_of(const ContentCurve& curve, const Judge& judge) {
    std::vector<Verdict> of_seed;
    for (std::size_t s = 0; s < curve.seed.size(); ++s) {
        of_seed.push_back(judge(s));
    }
    return of_seed;
}

Finding judge_each_seed(Finding finding, const ContentCurve& curve, const Judge& judge, std::string ours) {
    const std::vector<Verdict> of_seed = verdicts_of(curve, judge);
    finding.met = agreed(of_seed);
    finding.seeds_disagree = has(of_seed, true) && has(of_seed, false);
    finding.ours = std::move(ours);
    if (of_seed.size() > 1) {
        const auto met = std::count(of_seed.begin(), of_seed.end(), Verdict(true));
        finding.ours += fmt::format("; met by {} of {} seeds", met, of_seed.size());
    }
    return finding;
}

/// Whether the paper's words hold without our numbers, in every seed.
void judge_words(const ContentCurve& curve, const Judge& judge, Finding& finding) {
    finding.in_words = agreed(verdicts_of(curve, judge));
}

/// Whether an extreme lies between two fines contents. Points too far apart cannot decide, nor can an end of the curve
/// that is not an end of the soil.
Verdict lies_between(const std::optional<Extreme>& found, double least, double most) {
    if (!found) {
        return std::nullopt;
    }
    const auto inside = [&](double content) {
        return content >= least - same_content && content <= most + same_content;
    };
    const bool is_soils_end = found->at <= same_content || found->at >= 1 - same_content;
    if (found->is_end && !is_soils_end) {
        return std::nullopt;
    }
    if (found->least > most || found->most < least) {
        return false; // however the curve runs between its points
    }
    if (inside(found->at) != inside(found->vertex) || found->most - found->least > 2 * (most - least) + same_content) {
        return std::nullopt;
    }
    return inside(found->at);
}

/// "lowest at FC = 40 % (parabola 38.9 ± 0.5 %)".
std::string describe_extreme(const ContentCurve& curve, Which which) {
    std::vector<double> vertices;
    std::set<double> points;
    for (std::size_t s = 0; s < curve.seed.size(); ++s) {
        const std::optional<Extreme> found = find_extreme(curve, s, which);
        vertices.push_back(found && found->has_parabola() ? found->vertex : std::nan(""));
        if (found) {
            points.insert(std::round(1e4 * found->at) / 100);
        }
    }
    if (points.empty()) {
        return "fewer than three fines contents were run";
    }
    const Scatter vertex = scatter_of(std::move(vertices));
    return fmt::format(
        "{} at FC = {} %{}", which == Which::Lowest ? "lowest" : "highest", fmt::join(points, " or "),
        vertex.seeds > 0 ? ", by a parabola through its neighbors " + percent_of(vertex) : ""
    );
}

Finding judge_extreme(Finding finding, const ContentCurve& curve, Which which, double least, double most) {
    finding.our_numbers = {fmt::format("FC {} to {} %", percent(least), percent(most))};
    return judge_each_seed(
        std::move(finding), curve,
        [&](std::size_t s) { return lies_between(find_extreme(curve, s, which), least, most); },
        describe_extreme(curve, which)
    );
}

/// Whether `holds` for all points of a seed in (after, until]; nothing unless `until`, or some point, is there.
Verdict holds_between(
    const ContentCurve& curve, std::size_t s, double after, double until, const std::function<bool(double)>& holds
) {
    Verdict verdict;
    for (std::size_t k = 0; k < curve.content.size(); ++k) {
        const double x = curve.content[k], y = curve.value[s][k];
        if (x > after + same_content && x <= until + same_content && std::isfinite(y)) {
            verdict = verdict.value_or(true) && holds(y);
        }
    }
    return verdict;
}

/// e_g or e_eq stays near its value for the sand alone up to 20 %, and is well above it at 30 %.
Verdict stays_then_rises(const ContentCurve& curve, std::size_t s) {
    const auto sand = value_at(curve, s, 0), last = value_at(curve, s, 0.2), later = value_at(curve, s, 0.3);
    Verdict stays, rises;
    if (sand) {
        const Verdict near =
            holds_between(curve, s, 0, 0.2, [&](double value) { return std::abs(value / *sand - 1) <= 0.05; });
        stays = near == false || last ? near : std::nullopt;
        rises = later ? Verdict(*later / *sand - 1 > 0.1) : std::nullopt;
    }
    return both(stays, rises);
}

/// Whether it changes less up to 20 % than from there to 30 %, where it rises.
Verdict bends_at_a_fifth(const ContentCurve& curve, std::size_t s) {
    const auto sand = value_at(curve, s, 0), last = value_at(curve, s, 0.2), later = value_at(curve, s, 0.3);
    return sand && last && later ? Verdict(*later - *last > std::abs(*last - *sand)) : std::nullopt;
}

std::string changes_of(const ContentCurve& curve) {
    std::vector<std::string> parts;
    for (const double content : {0.2, 0.3}) {
        std::vector<double> of_seed;
        for (std::size_t s = 0; s < curve.seed.size(); ++s) {
            const auto sand = value_at(curve, s, 0), here = value_at(curve, s, content);
            of_seed.push_back(sand && here ? *here / *sand - 1 : std::nan(""));
        }
        parts.push_back(fmt::format("{} at {} %", percent_of(scatter_of(std::move(of_seed))), percent(content)));
    }
    return fmt::format("{}", fmt::join(parts, ", "));
}

Finding judge_skeleton(const StageCurve& loose) {
    const ContentCurve e_g = content_curve(loose, "intergranular_void_ratio");
    const ContentCurve e_eq = content_curve(loose, "equivalent_void_ratio");
    Finding finding = judge_each_seed(
        {"M3", "e_g and e_eq within 5 % of their value at FC 0 up to FC 20 %, more than 10 % above at 30 %",
         "both almost constant up to 20 %, rising beyond (Figure 3b)", "", std::nullopt},
        e_g, [&](std::size_t s) { return both(stays_then_rises(e_g, s), stays_then_rises(e_eq, s)); },
        fmt::format("above FC 0: e_g by {}; e_eq by {}", changes_of(e_g), changes_of(e_eq))
    );
    finding.our_numbers = {"within 5 %", "more than 10 %"};
    judge_words(
        e_g, [&](std::size_t s) { return both(bends_at_a_fifth(e_g, s), bends_at_a_fifth(e_eq, s)); }, finding
    );
    return finding;
}

/// Whether b keeps within `few` up to 15 %, and is above `many` at 30 %.
Verdict becomes_active(const ContentCurve& b, std::size_t s, double few, double many) {
    const auto last = value_at(b, s, 0.15), later = value_at(b, s, 0.3);
    const Verdict kept = holds_between(b, s, 0, 0.15, [few](double value) { return value <= few; });
    return both(kept == false || last ? kept : std::nullopt, later ? Verdict(*later > many) : std::nullopt);
}

Finding judge_activity(const StageCurve& loose) {
    constexpr double few = 0.1, many = 0.3;
    const ContentCurve b = content_curve(loose, "active_fines_fraction");
    Finding finding = judge_each_seed(
        {"M4", "b at most 0.1 up to FC 15 %, above 0.3 at 30 %",
         "most fines inactive until 20 % (Figure 4; section 4 opens with 30 %)", "", std::nullopt},
        b, [&](std::size_t s) { return becomes_active(b, s, few, many); },
        fmt::format(
            "active: {} at FC 15 %, {} at 20 %, {} at 30 %", percent_of(scatter_at(b, 0.15)),
            percent_of(scatter_at(b, 0.2)), percent_of(scatter_at(b, 0.3))
        )
    );
    finding.our_numbers = {"0.1 up to FC 15 %", "0.3 at 30 %"};
    judge_words(
        b,
        [&](std::size_t s) { // beyond one of the two bounds within which it was
            const Verdict low = becomes_active(b, s, few, few), high = becomes_active(b, s, many, many);
            return low && high ? Verdict(*low || *high) : std::nullopt;
        },
        finding
    );
    return finding;
}

Finding judge_coarse_contacts(const StageCurve& loose) {
    const ContentCurve ll = content_curve(loose, "contact_share.LL");
    std::string ours;
    for (const double content : {0.4, 0.5, 0.6}) {
        const Scatter there = scatter_at(ll, content);
        if (there.seeds > 0) {
            ours += fmt::format("{}{} at FC {} %", ours.empty() ? "" : ", ", percent_of(there), percent(content));
        }
    }
    const ContentCurve ls = content_curve(loose, "contact_share.LS"), ss = content_curve(loose, "contact_share.SS");
    Finding finding = judge_each_seed(
        {"M5", "LL at most 2 % of the contacts above FC 40 %", "almost none above 40 % (Figure 5)", "", std::nullopt},
        ll,
        [&](std::size_t s) {
            const Verdict few = holds_between(ll, s, 0.4, 1, [](double share) { return share <= 0.02; });
            const Verdict near = holds_between(ll, s, 0.4, 0.5, [](double share) { return share <= 0.02; });
            return few == false || near ? few : std::nullopt; // far above 40 % it is no news
        },
        ours.empty() ? "no fines content from 40 to 60 % was run" : ours
    );
    finding.our_numbers = {"2 %"};
    judge_words(
        ll,
        [&](std::size_t s) -> Verdict { // the rarest of the three
            const auto coarse = value_at(ll, s, 0.5), mixed = value_at(ls, s, 0.5), fine = value_at(ss, s, 0.5);
            return coarse && mixed && fine ? Verdict(*coarse < std::min(*mixed, *fine)) : std::nullopt;
        },
        finding
    );
    return finding;
}

Finding judge_fine_contacts(const StageCurve& loose) {
    const ContentCurve ss = content_curve(loose, "contact_share.SS");
    const auto grows = [&](std::size_t s, double times) -> Verdict {
        const auto before = value_at(ss, s, 0.3), after = value_at(ss, s, 0.4);
        return before && after ? Verdict(*after > 0 && *after >= times * *before) : std::nullopt;
    };
    Finding finding = judge_each_seed(
        {"M7", "SS at FC 40 % at least twice that at 30 %", "increase significantly beyond 30 % (Figure 5)", "",
         std::nullopt},
        ss, [&](std::size_t s) { return grows(s, 2); },
        fmt::format("{} at FC 30 %, {} at 40 %", percent_of(scatter_at(ss, 0.3)), percent_of(scatter_at(ss, 0.4)))
    );
    finding.our_numbers = {"at least twice"};
    judge_words(
        ss, [&](std::size_t s) { return grows(s, 1); }, finding
    );
    return finding;
}

Finding judge_strong_contacts(const StageCurve& loose) {
    const ContentCurve strong = content_curve(loose, "strong_contact_share.LS");
    const auto steepens = [&](std::size_t s, double times) -> Verdict {
        const auto none = value_at(strong, s, 0), some = value_at(strong, s, 0.2), more = value_at(strong, s, 0.3);
        if (!none || !some || !more) {
            return std::nullopt;
        }
        const double before = (*some - *none) / 0.2, after = (*more - *some) / 0.1;
        return after > 0 && after >= times * before;
    };
    Finding finding = judge_each_seed(
        {"M8", "The share of LS among strong contacts rises after FC 20 % (to 30 %) at least twice as fast as before",
         "increases significantly from 20 % on (Figure 6)", "", std::nullopt},
        strong, [&](std::size_t s) { return steepens(s, 2); },
        fmt::format(
            "{} at FC 0, {} at 20 %, {} at 30 %", percent_of(scatter_at(strong, 0)),
            percent_of(scatter_at(strong, 0.2)), percent_of(scatter_at(strong, 0.3))
        )
    );
    finding.our_numbers = {"(to 30 %)", "at least twice as fast"};
    judge_words(
        strong, [&](std::size_t s) { return steepens(s, 1); }, finding
    );
    return finding;
}

} // namespace

std::vector<Finding> judge_fines(
    const StageCurve* loose, const StageCurve* dense, const std::vector<Removal>& removals,
    std::optional<double> size_ratio
) {
    std::vector<Finding> findings;
    if (loose != nullptr) {
        findings.push_back(judge_extreme(
            {"M1", "The loose void ratio is lowest at FC 35 to 45 %", "40 % (Figure 3a)", "", std::nullopt},
            content_curve(*loose, "void_ratio"), Which::Lowest, 0.35, 0.45
        ));
        findings.push_back(judge_extreme(
            {"M2", "The least void ratio is lowest at FC 20 to 30 %", "25 % (Figure 3a)", "", std::nullopt},
            dense != nullptr ? content_curve(*dense, "void_ratio") : ContentCurve{}, Which::Lowest, 0.2, 0.3
        ));
        if (dense == nullptr) {
            findings.back().ours = "no dense samples were made";
        }
        findings.push_back(judge_skeleton(*loose));
        findings.push_back(judge_activity(*loose));
        findings.push_back(judge_coarse_contacts(*loose));
        findings.push_back(judge_extreme(
            {"M6", "The share of LS contacts is highest at FC 25 to 35 %", "30 % (Figure 5)", "", std::nullopt},
            content_curve(*loose, "contact_share.LS"), Which::Highest, 0.25, 0.35
        ));
        findings.push_back(judge_fine_contacts(*loose));
        findings.push_back(judge_strong_contacts(*loose));
    }
    if (loose != nullptr || !removals.empty()) {
        findings.push_back(judge_removals(removals));
    }
    for (Finding& finding : findings) {
        give_reason(loose, size_ratio, finding);
    }
    return findings;
}

} // namespace suffuse::study
