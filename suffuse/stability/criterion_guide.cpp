#include "suffuse/stability/criterion_guide.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace suffuse::stability {
namespace {

constexpr double by_curve = 0; ///< the limit depends on the grading, or on the gradient

struct Guide {
    std::string_view id, name, measure;
    Sense sense;
    double limit; ///< [-]
    std::string_view title, measured, limit_in_words, source;
    bool verified = true;
};

constexpr std::array guides = {
    Guide{
        "kenney-lau-1985", "Kenney and Lau 1985", "(H/F)min", Sense::AtLeast, 1.3, "Kenney and Lau 1985",
        "The least H/F up to F_max, with F(d) the mass finer than d and H(d) = F(4d) - F(d): are there enough grains "
        "up to four times as large to retain those of size d? F_max is 20 % where d60/d10 > 3, else 30 %.",
        "stable where H/F >= 1.3", "KenneyLau1985"},
    Guide{
        "kenney-lau-1986", "Kenney and Lau 1986", "(H/F)min", Sense::AtLeast, 1, "Kenney and Lau 1986",
        "Like kenney-lau-1985, with the limit of their later discussion.", "stable where H/F >= 1", "KenneyLau1986"},
    Guide{
        "li-fannin-2008", "Li and Fannin 2008", "min H/min(F, 15 %)", Sense::AtLeast, 1, "Li and Fannin 2008",
        "The least H/min(F, 15 %): Kenney and Lau's criterion below F = 15 %, Kezdi's above.", "stable where >= 1",
        "LiFannin2008"},
    Guide{
        "kezdi-1979", "Kezdi 1979", "D15c/d85f", Sense::AtMost, 4, "Kezdi 1979",
        "The soil split at every size in turn: the largest D15 of the coarse part over d85 of the fine part.",
        "stable where <= 4", "Kezdi1979"},
    Guide{
        "burenkova-1993", "Burenkova 1993", "h' = d90/d60", Sense::Between, by_curve, "Burenkova 1993",
        "h' = d90/d60 against h\" = d90/d15. Cannot say for grains above 100 mm or d60/d10 above 200.",
        "stable where 0.76 log h\" + 1 <= h' <= 1.86 log h\" + 1", "Burenkova1993"},
    Guide{
        "wan-fell-logistic", "Wan and Fell (logistic)", "P(unstable)", Sense::AtMost, 0.5,
        "Wan and Fell 2008, logistic form",
        "The probability of instability from h' and h\", for sand-gravel and silt-sand-gravel. Cannot say without "
        "gravel, above 10 % clay, and where its form was not fitted.",
        "stable where P <= 50 %: that limit is ours, the authors give the probability", "WanFell2008"},
    Guide{
        "chang-zhang-2013", "Chang and Zhang 2013", "", Sense::AtLeast, by_curve, "Chang and Zhang 2013",
        "By the mass P finer than 0.063 mm: without a gap the least H/F, with a gap its width.",
        "no gap: stable where H/F > 1 below P = 5 %, from 20 % on in any case; a gap: where its ratio < 3 below P = 10 "
        "%, above 35 % in any case. Between (P in %), unverified and not counted: H/F > 4/3 - P/15, ratio < 0.3 P",
        "ChangZhang2013"},
    Guide{
        "sherard-1979", "Sherard 1979", "D15c/d85f", Sense::AtMost, 5, "Sherard 1979 (unverified)",
        "D15 of the coarse part over d85 of the fine part, at the split.",
        "stable where <= 5; the limit was not verified in the source, so it is not counted", "Sherard1979", false},
    Guide{
        "wan-fell-alternative", "Wan and Fell (slopes)", "30/log(d90/d60)", Sense::AtMost, 70,
        "Wan and Fell 2008, slopes (unverified)", "Slopes of the curve: 30/log(d90/d60) and 15/log(d20/d5).",
        "stable where the first is below 70 or the second above 22; not verified in the source, so not counted",
        "WanFell2008", false},
    Guide{
        "indraratna-2011", "Indraratna et al. 2011", "Dc35/d85f", Sense::AtMost, 1,
        "Indraratna et al. 2011 (unverified)",
        "The constriction that 35 % of those of the coarse part undercut (Dc35, from the grading and a relative "
        "density) over d85 of the fine part by surface area.",
        "stable where <= 1; not verified in the source, so not counted", "Indraratna2011", false},
    Guide{
        "terzaghi", "Terzaghi", "gradient i", Sense::AtMost, by_curve, "Terzaghi's critical gradient",
        "Upward seepage carries the weight of the whole soil at i_c = (G_s - 1)(1 - n). Needs -i.",
        "safe where i is below it", "Terzaghi1939"},
    Guide{
        "skempton-brogan-1994", "Skempton and Brogan 1994", "gradient i", Sense::AtMost, by_curve,
        "Skempton and Brogan 1994",
        "Upward seepage carries the fines alone at alpha i_c. alpha (--alpha) is the mean effective stress in the "
        "fines over that of the soil, alpha_fines of a run's stage.json (not fines_stress_share, which is FC alpha); 1 "
        "where Kenney and Lau 1985 say stable, (H/F)min >= 1.3. Needs -i.",
        "safe where i is below it", "SkemptonBrogan1994"},
};

/// Of a filter and its base.
constexpr std::array filter_guides = {
    Guide{
        "terzaghi-filter", "Terzaghi and Peck", "D15F/d85B", Sense::AtMost, 4, "Terzaghi and Peck's filter rule",
        "D15 of the filter over d85 of the base: do the voids of the filter hold it? Needs --filter.",
        "holds where <= 4", "TerzaghiPeck1948"},
    Guide{
        "no-erosion-filter", "No erosion (NRCS 2017)", "D15F/largest D15F", Sense::AtMost, 1, "No erosion, NRCS 2017",
        "D15 of the filter over the largest that lets nothing erode. That depends on the category of the base, by its "
        "share finer than 0.075 mm. Needs --filter.",
        "holds where <= 1", "NRCS2017"},
    Guide{
        "continuing-erosion-filter", "Continuing erosion (Foster and Fell 2001)", "D15F/d95B", Sense::AtMost, 9,
        "Continuing erosion, Foster and Fell 2001",
        "D15 of the filter over d95 of the base: beyond the limit erosion goes on, and the filter never seals. Needs "
        "--filter.",
        "holds where <= 9", "FosterFell2001"},
    Guide{
        "permeability-filter", "Permeability (NRCS 2017)", "D15F/d15B", Sense::AtLeast, 5,
        "Permeability of a filter, NRCS 2017",
        "D15 of the filter over d15 of the base: does the filter drain it? Needs --filter.",
        "drains where >= 5 and D15F is at least 0.1 mm", "NRCS2017"},
    Guide{
        "filter-fines", "Fines of the filter (NRCS 2017)", "F at 0.075 mm", Sense::AtMost, 0.05,
        "Fines of a filter, NRCS 2017",
        "Share of the filter finer than 0.075 mm: more of them bind it, and a crack in it stays open. Needs --filter.",
        "good where <= 5 %", "NRCS2017"},
    Guide{
        "filter-segregation", "Segregation (NRCS 2017)", "D90F/largest D90F", Sense::AtMost, 1,
        "Segregation of a filter, NRCS 2017 (unverified)",
        "D90 of the filter over the largest for its D10: wider filters segregate. Needs --filter.",
        "good where <= 1; not verified in the source, so not counted", "NRCS2017", false},
};

/// One after the other.
constexpr auto all_guides = [] {
    std::array<Guide, guides.size() + filter_guides.size()> all{};
    std::ranges::copy(filter_guides, std::ranges::copy(guides, all.begin()).out);
    return all;
}();

struct Symbol {
    std::string_view word, id; ///< a number, and how the ids of the criteria that read it begin
};

constexpr std::array symbols = {Symbol{"alpha", "skempton"},      Symbol{"h/f", "kenney"},
                                Symbol{"h/f", "chang"},           Symbol{"d15c/d85f", "kezdi"},
                                Symbol{"d15c/d85f", "sherard"},   Symbol{"dc35", "indraratna"},
                                Symbol{"dc35/d85f", "indraratna"}};

/// "wan" and "fell" and "wan-fell" mean "wan-fell-logistic"; a year alone means nothing.
bool is_meant(std::string_view id, const std::string& word) {
    const bool is_symbol = std::any_of(symbols.begin(), symbols.end(), [&](const Symbol& symbol) {
        return symbol.word == word && id.starts_with(symbol.id);
    });
    const bool has_letters = std::any_of(word.begin(), word.end(), [](char c) { return c >= 'a' && c <= 'z'; });
    return is_symbol || (has_letters && fmt::format("-{}-", id).find("-" + word + "-") != std::string::npos);
}

} // namespace

std::optional<std::string> explain_criterion(std::string_view typed_id) {
    std::string word(typed_id), text;
    std::transform(word.begin(), word.end(), word.begin(), [](char c) {
        return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    });
    for (const Guide& guide : all_guides) {
        if (is_meant(guide.id, word)) {
            text += fmt::format(
                "{}{}\n  {}\n  limit    {}\n  source   {} in docs/references.bib; docs/theory/internal-stability.md\n",
                text.empty() ? "" : "\n", guide.title, guide.measured, guide.limit_in_words, guide.source
            );
        }
    }
    return text.empty() ? std::nullopt : std::optional(text);
}

Criterion define(std::string_view id) {
    const auto* const found = std::ranges::find(all_guides, id, &Guide::id);
    expects(found != all_guides.end(), "a criterion has its row in criterion_guide.cpp");
    Criterion criterion{std::string(found->id), std::string(found->name), std::string(found->measure)};
    criterion.sense = found->sense;
    criterion.source = found->source;
    criterion.verified = found->verified;
    if (found->limit != by_curve) {
        criterion.limit = found->limit;
    }
    return criterion;
}

std::vector<std::string> criterion_ids() {
    std::vector<std::string> ids;
    ids.reserve(guides.size());
    for (const Guide& guide : guides) {
        ids.emplace_back(guide.id);
    }
    return ids;
}

} // namespace suffuse::stability
