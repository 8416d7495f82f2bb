#include "suffuse/study/findings.hpp"

#include "suffuse/base/quantile.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/study/findings_reason.hpp"
#include "suffuse/study/passes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::study {

namespace {

using erosion::ErosionResult;
using erosion::PassResult;
using erosion::ProbeResult;

const ProbeResult* probe_at(double gradient, const std::vector<ProbeResult>& probes, const ErosionResult& erosion) {
    const auto fits = [gradient](const ProbeResult& probe) { return std::abs(probe.gradient - gradient) <= 1e-9; };
    const auto found = std::find_if(probes.begin(), probes.end(), fits);
    if (found != probes.end()) {
        return &*found;
    }
    const bool eroded = !erosion.passes.empty() && !erosion.passes.front().probe.id.empty();
    if (eroded && fits(erosion.passes.front().probe)) {
        return &erosion.passes.front().probe;
    }
    return nullptr;
}

const PassResult* pass_of(const ErosionResult& erosion, int number) {
    const auto found = std::find_if(erosion.passes.begin(), erosion.passes.end(), [number](const PassResult& pass) {
        return pass.pass == number;
    });
    return found == erosion.passes.end() ? nullptr : &*found;
}

Finding judge_gradients(const std::vector<ProbeResult>& probes, const ErosionResult& erosion) {
    Finding finding{
        "E1", "Detached grains: none at i = 0, some at i = 0.01",
        "none at i = 0; detachment initiates at i = 0.01 (Figure 9)", "", std::nullopt};
    Verdict none_without, some_with;
    if (const ProbeResult* still = probe_at(0, probes, erosion)) {
        const Detached detached = count_detached(*still);
        none_without = detached.yes == 0;
        finding.ours =
            fmt::format("{} of {} fines at i = 0", grouped(detached.yes), grouped(detached.yes + detached.no));
    } else {
        finding.ours = "i = 0 was not probed";
    }
    if (const ProbeResult* flowing = probe_at(0.01, probes, erosion)) {
        const Detached detached = count_detached(*flowing);
        some_with = detached.yes > 0;
        finding.ours +=
            fmt::format("; {} of {} at i = 0.01", grouped(detached.yes), grouped(detached.yes + detached.no));
    } else {
        finding.ours += "; i = 0.01 was not probed";
    }
    // The paper probed nothing between the two, and without a fluid's force no rule detaches a grain.
    for (const ProbeResult& probe : probes) {
        if (probe.gradient > 0 && probe.gradient < 0.01) {
            finding.ours +=
                fmt::format("; {} already at i = {}", grouped(count_detached(probe).yes), short_number(probe.gradient));
        }
    }
    finding.met = both(none_without, some_with);
    if (!finding.met) {
        finding.why = "Add a `detach` stage with `gradients = [0, 0.01, 0.05, 0.1]`.";
    } else if (!*finding.met) {
        finding.why =
            none_without == false
                ? "The rule takes grains without any seepage force."
                : "At i = 0.01 no grain meets the rule: it requires more speed than the water gives within the watch.";
    }
    return finding;
}

/// Median speeds [m/s] of the detachable and of the other fines at one sample of the watch.
std::pair<double, double> median_speeds(const ProbeResult& probe, std::size_t sample) {
    std::vector<double> detachable, others;
    for (std::size_t g = 0; g < probe.id.size(); ++g) {
        (probe.by_velocity[g] != 0 ? detachable : others).push_back(probe.speed[g][sample]);
    }
    return {quantile(std::move(detachable), 0.5), quantile(std::move(others), 0.5)};
}

Finding judge_separation(const std::vector<ProbeResult>& probes, const ErosionResult& erosion) {
    constexpr double paper_watch = 1000; // iterations
    constexpr double apart = 10;
    Finding finding{
        "E2", "At i = 0.05 the median speeds of the two groups differ at least ten times within 1,000 iterations",
        "two groups, easily distinguished after 1,000 iterations (Figure 9)", "", std::nullopt};
    finding.our_numbers = {"at least ten times"};
    const ProbeResult* probe = probe_at(0.05, probes, erosion);
    if (probe == nullptr) {
        finding.ours = "i = 0.05 was not probed";
        finding.why = "Add a `detach` or `erode` stage at i = 0.05.";
        return finding;
    }
    const Detached detached = count_detached(*probe);
    if (detached.yes == 0 || detached.no == 0) {
        finding.ours = fmt::format(
            "one group only: {} detachable, {} others at i = 0.05", grouped(detached.yes), grouped(detached.no)
        );
        finding.why = detached.yes == 0 ? "The rule takes no grain." : "The rule takes every grain.";
        return finding;
    }
    const double spacing = static_cast<double>(probe->watch) / erosion::probe_samples;
    const double last = std::clamp(std::floor(paper_watch / spacing * (1 + 1e-12)), 0.0, 1.0 * erosion::probe_samples);
    const auto [fast, slow] = median_speeds(*probe, static_cast<std::size_t>(last));
    const bool separated = fast >= apart * slow && fast > 0;
    finding.ours = fmt::format(
        "{} against {} m/s after {} iterations at full force: {}", short_number(fast), short_number(slow),
        grouped(std::llround(last * spacing)),
        !(slow > 0)          ? "the others do not move"
        : fast < 1000 * slow ? short_number(fast / slow) + " times"
                             : grouped(std::llround(fast / slow)) + " times"
    );
    // A watch that ends early, or was first read later than the paper's, shows a separation but cannot deny it.
    const bool watched = probe->watch >= static_cast<std::int64_t>(paper_watch) && last > 0;
    finding.met = separated ? Verdict(true) : watched ? Verdict(false) : std::nullopt;
    finding.in_words = fast > slow;
    if (!separated) {
        finding.why = watched ? fmt::format(
                                    "The slow group moves because of the residual unbalanced forces ({}); with further "
                                    "relaxation the groups differ more.",
                                    short_number(probe->unbalanced_force, 2)
                                )
                              : "The watch ends before 1,000 iterations, or was first read after them.";
    }
    return finding;
}

std::string share_of(std::int64_t part, std::int64_t all) {
    return fmt::format(
        "{} of {} ({} %)", grouped(part), grouped(all),
        short_number(100.0 * static_cast<double>(part) / static_cast<double>(all))
    );
}

Finding judge_rattlers(const ErosionResult& erosion) {
    Finding finding{
        "E3", "Pass 1: fewer than 10 % of the removed grains have more than 2 contacts",
        "very few have more than 2; most are rattlers (Figure 12)", "no grain was removed in pass 1", std::nullopt};
    finding.our_numbers = {"10 %"};
    const PassResult* pass = pass_of(erosion, 1);
    if (pass == nullptr || pass->removed == 0) {
        finding.ours = pass == nullptr ? "there was no pass 1" : finding.ours;
        finding.why = "Nothing was eroded.";
        return finding;
    }
    const std::int64_t removed = left_with_at_least(*pass, 0), held = left_with_at_least(*pass, 3);
    finding.ours = share_of(held, removed);
    finding.met = 10 * held < removed;
    finding.in_words = 2 * held < removed;
    const std::string noise = describe_noise(pass);
    finding.is_noise = *finding.met && !noise.empty();
    if (finding.is_noise || !*finding.met) {
        finding.why = noise.empty() ? "The rule takes grains that carry load." : noise;
    }
    return finding;
}

Finding judge_active(const ErosionResult& erosion) {
    Finding finding{
        "E4", "Pass 2: more than 50 % of the removed grains have at least 2 contacts", "most are active (Figure 12)",
        "no grain was removed in pass 2", std::nullopt};
    const PassResult* pass = pass_of(erosion, 2);
    finding.why = describe_few_active(erosion, pass);
    if (pass == nullptr || pass->removed == 0) {
        finding.ours = pass == nullptr ? "there was no pass 2" : finding.ours;
        return finding;
    }
    const std::int64_t removed = left_with_at_least(*pass, 0), active = left_with_at_least(*pass, 2);
    finding.ours = share_of(active, removed);
    finding.met = 2 * active > removed;
    if (*finding.met) {
        finding.why = describe_noise(pass);
        finding.is_noise = !finding.why.empty();
    }
    return finding;
}

/// Why a claim on both passes is not met, or is met by the noise of the second.
void give_reason(const ErosionResult& erosion, Verdict first, Verdict second, Finding& finding) {
    const PassResult* pass_2 = pass_of(erosion, 2);
    if (finding.met == true) {
        finding.why = describe_noise(pass_2);
        finding.is_noise = !finding.why.empty();
        return;
    }
    const std::string in_words =
        finding.met == false && finding.in_words == true
            ? fmt::format("The paper's words hold, our numbers ({}) do not. ", list_our_numbers(finding))
            : "";
    const std::string of_first = first == false ? describe_active_in_first(pass_of(erosion, 1)) : "";
    const std::string of_second = second != true ? describe_few_active(erosion, pass_2) : "";
    finding.why = in_words + of_first + (of_first.empty() || of_second.empty() ? "" : " ") + of_second;
}

/// Whether pass 2 stands beyond a bound that pass 1 keeps within, whichever of the two bounds it is.
Verdict differ_in_words(std::optional<double> first, std::optional<double> second, double least, double most) {
    if (!first || !second) {
        return std::nullopt;
    }
    return (*first<least&& * second> least) || (*first<most&& * second> most);
}

/// Of a pass that cannot show what removal does.
std::string took_nothing(const PassResult* pass, int number) {
    return pass == nullptr ? fmt::format("there was no pass {}", number) : fmt::format("pass {} took no grain", number);
}

Finding judge_strain(const ErosionResult& erosion) {
    Finding finding{
        "E5", "Contraction below 0.01 % in pass 1, above 0.1 % in pass 2",
        "almost negligible in pass 1, important in pass 2 (Figure 13)", "", std::nullopt};
    finding.our_numbers = {"0.01 %", "0.1 %"};
    constexpr double least = 1e-4, most = 1e-3;
    Verdict negligible, important;
    std::optional<double> first, second;
    const auto describe = [&](int number, std::optional<double>& strain, Verdict& verdict, auto&& judge) {
        const PassResult* pass = pass_of(erosion, number);
        if (pass == nullptr || pass->removed == 0) {
            return took_nothing(pass, number);
        }
        strain = pass->volumetric_strain;
        verdict = judge(*strain);
        const double percent = 100 * pass->volumetric_strain;
        return fmt::format("{} in pass {}", is_noise(percent) ? "below 0.01 %" : short_number(percent) + " %", number);
    };
    finding.ours = describe(1, first, negligible, [](double strain) { return std::abs(strain) < least; });
    finding.ours += "; " + describe(2, second, important, [](double strain) { return strain > most; });
    finding.met = both(negligible, important);
    finding.in_words = differ_in_words(first ? std::optional(std::abs(*first)) : first, second, least, most);
    give_reason(erosion, negligible, important, finding);
    return finding;
}

Finding judge_porosity(const ErosionResult& erosion) {
    Finding finding{
        "E6", "Porosity rises with the eroded mass, and falls on resettling in pass 2; changes up to 0.00001 are none",
        "rises with each erosion; the fall is negligible in pass 1, clear in pass 2 (Figure 14)", "", std::nullopt};
    finding.our_numbers = {"0.00001"};
    constexpr int most_reported = 4; // passes
    Verdict rises, falls;
    int more = 0, more_rose = 0;
    for (const PassResult& pass : erosion.passes) {
        if (pass.removed == 0) {
            continue;
        }
        const bool rose = pass.porosity_after_removal - pass.porosity_before > porosity_resolution;
        rises = rises.value_or(true) && rose;
        if (pass.pass > most_reported) {
            ++more, more_rose += rose ? 1 : 0;
            continue;
        }
        finding.ours += fmt::format(
            "{}pass {}: {:.5f} to {:.5f} on removal, {:.5f} resettled", finding.ours.empty() ? "" : "; ", pass.pass,
            pass.porosity_before, pass.porosity_after_removal, pass.porosity_after
        );
        if (pass.pass == 2) {
            const double fall = pass.porosity_after_removal - pass.porosity_after;
            falls = fall > porosity_resolution;
            if (std::abs(fall) <= porosity_resolution) {
                finding.ours += " (no change that could be resolved)";
            }
        }
    }
    if (more > 0) {
        finding.ours += fmt::format("; it rises in {} of {} more passes", more_rose, more);
    }
    if (finding.ours.empty()) {
        finding.ours = "no grain was removed";
    }
    finding.met = both(rises, falls);
    give_reason(erosion, std::nullopt, falls, finding);
    if (rises == false) {
        finding.why = "A pass took less than the porosity resolves." + (finding.why.empty() ? "" : " " + finding.why);
    }
    return finding;
}

Finding judge_stress(const ErosionResult& erosion) {
    Finding finding{
        "E7", "Mean stress at constant volume falls by less than 1 % after pass 1, by more than 10 % after pass 2",
        "a slight change after pass 1, an important one after pass 2 (Figure 13)", "", std::nullopt};
    finding.our_numbers = {"less than 1 %", "more than 10 %"};
    constexpr double least = 0.01, most = 0.10;
    std::optional<double> first, second;
    const auto loss = [&](int number, std::optional<double>& share, Verdict& verdict, auto&& judge) {
        const PassResult* pass = pass_of(erosion, number);
        if (pass == nullptr || pass->removed == 0) {
            return took_nothing(pass, number);
        }
        const double before = dem::mean_stress(pass->stress_before);
        if (!(before > 0)) {
            return fmt::format("pass {} has no stress to compare", number);
        }
        const double after = dem::mean_stress(pass->stress_constant_volume), percent = 100 * (after - before) / before;
        share = -0.01 * percent;
        verdict = judge(*share);
        return fmt::format(
            "pass {}: {} to {} kPa ({})", number, short_number(before / 1e3, 4), short_number(after / 1e3, 4),
            is_noise(percent) ? "unchanged" : short_number(percent) + " %"
        );
    };
    Verdict slight, important;
    finding.ours = loss(1, first, slight, [](double share) { return share < least; });
    finding.ours += "; " + loss(2, second, important, [](double share) { return share > most; });
    finding.met = both(slight, important);
    finding.in_words = differ_in_words(first, second, least, most);
    give_reason(erosion, slight, important, finding);
    return finding;
}

} // namespace

Detached count_detached(const ProbeResult& probe) {
    Detached detached;
    detached.yes = std::count_if(probe.by_velocity.begin(), probe.by_velocity.end(), [](auto is) { return is != 0; });
    detached.no = static_cast<std::int64_t>(probe.by_velocity.size()) - detached.yes;
    return detached;
}

std::vector<Finding> judge_erosion(const std::vector<ProbeResult>& probes, const ErosionResult& erosion) {
    return {
        judge_gradients(probes, erosion),
        judge_separation(probes, erosion),
        judge_rattlers(erosion),
        judge_active(erosion),
        judge_strain(erosion),
        judge_porosity(erosion),
        judge_stress(erosion)};
}

} // namespace suffuse::study
