// M9: what it costs a sample to lose its fines at once, below and above the paper's active fines content.
#include "suffuse/base/words.hpp"
#include "suffuse/study/findings_fines.hpp"
#include "suffuse/study/seed_verdicts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace suffuse::study {
namespace {

constexpr double paper_active = 0.2; // the paper's FC_active: samples at it are neither below nor above

/// Strain per removed mass of one seed's removals, above the active fines content against below.
std::optional<double> strain_ratio(const std::vector<Removal>& removals, std::uint64_t seed, bool is_isotropic) {
    double below = 0, above = 0;
    int few = 0, many = 0;
    for (const Removal& removal : removals) {
        if (removal.seed != seed || (removal.stress_ratio < isotropic_below) != is_isotropic ||
            !(removal.removed_share > 0)) {
            continue;
        }
        const double per_mass = removal.strain / removal.removed_share;
        if (removal.fines_content < paper_active - same_content) {
            below += per_mass, ++few;
        } else if (removal.fines_content > paper_active + same_content) {
            above += per_mass, ++many;
        }
    }
    if (few == 0 || many == 0 || !(below > 0)) {
        return std::nullopt;
    }
    return above / many / (below / few);
}

} // namespace

Finding judge_removals(const std::vector<Removal>& removals) {
    Finding finding{
        "M9",
        "Removing all fines costs little below FC_active and much above it: at least three times the strain per "
        "removed mass above 20 % as below, at the isotropic state and under q/p",
        "expected at FC_active = 20 % (section 4: 30 %), not simulated", "no sample lost its fines at once",
        std::nullopt};
    finding.our_numbers = {"at least three times"};
    if (removals.empty()) {
        finding.why = "Add a `remove` stage that removes all fines, below and above FC 20 %.";
        return finding;
    }
    std::set<std::uint64_t> seeds;
    for (const Removal& removal : removals) {
        seeds.insert(removal.seed);
    }
    finding.ours.clear();
    Verdict verdict = true, words = true;
    for (const bool is_isotropic : {true, false}) {
        std::vector<Verdict> of_seed, more;
        std::vector<double> ratios;
        for (const std::uint64_t seed : seeds) {
            const std::optional<double> ratio = strain_ratio(removals, seed, is_isotropic);
            of_seed.push_back(ratio ? Verdict(*ratio >= 3) : std::nullopt);
            more.push_back(ratio ? Verdict(*ratio > 1) : std::nullopt);
            ratios.push_back(ratio.value_or(std::nan("")));
        }
        verdict = both(verdict, agreed(of_seed)), words = both(words, agreed(more));
        finding.seeds_disagree = finding.seeds_disagree || (has(of_seed, true) && has(of_seed, false));
        const Scatter ratio = scatter_of(ratios);
        finding.ours += fmt::format(
            "{}{}: {} times the strain per removed mass", finding.ours.empty() ? "" : "; ",
            is_isotropic ? "isotropic" : "under q/p", ratio.seeds > 0 ? short_number(ratio.mean) : "unknown"
        );
    }
    finding.met = verdict, finding.in_words = words;
    finding.seeds_disagree = finding.seeds_disagree && !verdict;
    return finding;
}

} // namespace suffuse::study
