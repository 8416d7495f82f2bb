#include "suffuse/answer/headlines.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/study/passes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::answer {

namespace {

using erosion::ErosionResult;
using erosion::PassResult;

void add_passes(const ErosionResult& erosion, std::vector<Headline>& headlines) {
    const auto& passes = erosion.passes;
    double eroded = 0;
    for (const PassResult& pass : passes) {
        eroded += pass.eroded_mass_percent_of_initial;
    }
    const std::string turns = fmt::format("in {} {}", passes.size(), passes.size() == 1 ? "pass" : "passes");
    const bool probed = !passes.front().probe.id.empty() && !erosion::is_forced(erosion);
    headlines.push_back(
        {short_number(eroded) + " %", "of the mass eroded",
         probed ? fmt::format("{} at i = {}", turns, passes.front().probe.gradient) : turns}
    );
    const double before = passes.front().permeability_before, after = passes.back().permeability_after;
    if (before > 0 && after > 0) {
        headlines.push_back(
            {"× " + short_number(after / before), "permeability",
             fmt::format("{} to {} m²", short_number(before, 2), short_number(after, 2))}
        );
    }
    const auto worst = std::max_element(passes.begin(), passes.end(), [](const PassResult& a, const PassResult& b) {
        return erosion::stress_loss(a) < erosion::stress_loss(b);
    });
    if (const std::optional<double> loss = erosion::stress_loss(*worst)) {
        const double change = -100 * *loss;
        headlines.push_back(
            {is_noise(change) ? "unchanged" : short_number(change, 2) + " %", "mean stress at constant volume",
             is_noise(change) ? "to 0.01 %, in all passes"
                              : fmt::format("after pass {}, the largest loss", worst->pass)}
        );
    }
}

} // namespace

std::vector<Headline> erosion_headlines(const ErosionResult& erosion) {
    std::vector<Headline> headlines;
    if (!erosion.passes.empty()) {
        add_passes(erosion, headlines);
    }
    return headlines;
}

std::optional<Headline> findings_headline(const std::vector<study::Finding>& findings) {
    if (findings.empty()) {
        return std::nullopt;
    }
    const auto met =
        std::count_if(findings.begin(), findings.end(), [](const study::Finding& f) { return f.met == true; });
    const std::string all = study::count_standings(findings);
    const std::size_t more = all.find_first_of(",;");
    return Headline{
        fmt::format("{} of {}", met, findings.size()), "findings of the paper met",
        more == std::string::npos ? "" : all.substr(more + 2)};
}

std::vector<Headline> fines_headlines(const std::vector<study::ContentThreshold>& thresholds) {
    std::vector<Headline> headlines;
    for (const study::ContentThreshold& each : thresholds) {
        if (each.at.seeds == 0 || each.kind == study::ThresholdKind::LowestBetween) {
            continue;
        }
        const std::string scatter =
            each.at.seeds > 1 ? fmt::format(" ± {}", short_number(100 * each.at.standard_deviation, 2)) : "";
        const std::string how = each.is_lowest() ? ", by a parabola" : "";
        headlines.push_back(
            {fmt::format("{:.0f}{} %", 100 * each.at.mean, scatter), each.name(),
             each.from() + how + study::seeds_that_have(each.at)}
        );
    }
    return headlines;
}

} // namespace suffuse::answer
