#include "suffuse/study/finding.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace suffuse::study {
namespace {

using OneBySeed = std::vector<const Finding*>;

std::size_t count(const OneBySeed& seeds, Verdict wanted) {
    return static_cast<std::size_t>(std::ranges::count_if(seeds, [&](const Finding* f) { return f->met == wanted; }));
}

/// The first reason of those that meet, or do not meet, the criterion; of the latter, of one that does not even by the
/// paper's words.
std::string first_reason(const OneBySeed& seeds, Verdict met) {
    const auto any = [&](auto&& is_it) {
        const auto found = std::ranges::find_if(seeds, [&](const Finding* f) {
            return f->met == met && !f->why.empty() && is_it(*f);
        });
        return found == seeds.end() ? std::string() : (*found)->why;
    };
    std::string why = met == false ? any([](const Finding& f) { return f.in_words != true; }) : "";
    return why.empty() ? any([](const Finding&) { return true; }) : why;
}

/// Why the seeds together say what they do.
std::string reason_of(const Finding& all, const OneBySeed& seeds) {
    const auto by_noise = static_cast<std::size_t>(std::ranges::count_if(seeds, [](const Finding* f) {
        return f->met == true && f->is_noise;
    }));
    std::string noise;
    if (by_noise > 0) {
        noise = fmt::format("Noise meets it in {} of {} seeds. {}", by_noise, seeds.size(), first_reason(seeds, true));
    }
    if (!all.seeds_disagree) {
        return noise.empty() ? first_reason(seeds, all.met) : noise;
    }
    const std::string text = fmt::format(
        "{} {} of {}{}",
        all.in_words == true ? "The paper's words hold in all seeds, our number in" : "The seeds disagree:",
        count(seeds, true), seeds.size(), all.in_words == true ? ". " : " meet it. "
    );
    return text + (noise.empty() ? "Where it is not: " + first_reason(seeds, false) : noise);
}

} // namespace

Standing standing_of(const Finding& finding) {
    if (finding.seeds_disagree) { // where the words hold in all of them, they disagree on our number alone
        return finding.in_words == true ? Standing::NotMetByOurNumber : Standing::SeedsDisagree;
    }
    if (!finding.met) {
        return Standing::Undecided;
    }
    if (*finding.met) {
        return finding.is_noise ? Standing::MetByNoise : Standing::Met;
    }
    return finding.in_words == true ? Standing::NotMetByOurNumber : Standing::NotMet;
}

Verdict agreement_of(const Finding& finding) {
    return standing_of(finding) == Standing::MetByNoise ? std::nullopt : finding.met;
}

std::string_view name_of(Standing standing) {
    switch (standing) {
    case Standing::Met:
        return "met";
    case Standing::MetByNoise:
        return "met by noise";
    case Standing::NotMet:
        return "not met";
    case Standing::NotMetByOurNumber:
        return "not met by our number";
    case Standing::SeedsDisagree:
        return "seeds disagree";
    case Standing::Undecided:
        return "cannot tell";
    }
    throw Bug("a standing without a name");
}

std::string list_our_numbers(const Finding& finding) {
    return fmt::format("{}", fmt::join(finding.our_numbers, ", "));
}

std::string count_standings(const std::vector<Finding>& findings) {
    const auto count_of = [&](Standing standing) {
        return std::ranges::count(findings, standing, [](const Finding& finding) { return standing_of(finding); });
    };
    std::string text = fmt::format("{} of {} met", count_of(Standing::Met), findings.size());
    for (const Standing standing :
         {Standing::MetByNoise, Standing::NotMetByOurNumber, Standing::NotMet, Standing::SeedsDisagree,
          Standing::Undecided}) {
        if (const auto there = count_of(standing); there > 0) {
            const char* const which = standing == Standing::SeedsDisagree ? "on which " : "";
            text += fmt::format("; {} {}{}", there, which, name_of(standing));
        }
    }
    return text;
}

std::string reason_in_table(const std::vector<Finding>& findings, std::size_t at) {
    const std::string& why = findings[at].why;
    for (std::size_t before = 0; before < at && !why.empty(); ++before) {
        if (findings[before].why == why) {
            return "As " + findings[before].id + ".";
        }
    }
    return why;
}

std::vector<Finding> combine_seeds(const std::vector<std::vector<Finding>>& by_seed) {
    if (by_seed.empty()) {
        return {};
    }
    std::vector<Finding> combined = by_seed.front();
    for (std::size_t f = 0; f < combined.size() && by_seed.size() > 1; ++f) {
        OneBySeed seeds;
        for (const std::vector<Finding>& findings : by_seed) {
            expects(findings.size() == combined.size(), "every seed is judged by the same findings");
            seeds.push_back(&findings[f]);
        }
        const std::size_t met = count(seeds, true), not_met = count(seeds, false);
        Finding& all = combined[f];
        all.met = met == seeds.size() ? Verdict(true) : not_met == seeds.size() ? Verdict(false) : std::nullopt;
        all.seeds_disagree = met > 0 && not_met > 0;
        const auto holds = [](const Finding* finding) { return finding->met == true || finding->in_words == true; };
        all.in_words = std::ranges::all_of(seeds, holds) ? Verdict(true) : Verdict(false);
        all.is_noise = std::ranges::any_of(seeds, [](const Finding* finding) { return finding->is_noise; });
        all.why = reason_of(all, seeds);
        all.ours =
            fmt::format("met by {} of {} seeds, not met by {}; first seed: {}", met, seeds.size(), not_met, all.ours);
    }
    return combined;
}

} // namespace suffuse::study
