#include "apps/own_soil.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/grouped.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/modeled_part.hpp"
#include "suffuse/stability/kenney_lau.hpp"
#include "suffuse/stability/open_curve.hpp"

#include <fmt/format.h>

#include "apps/cut_verdicts.hpp"
#include "apps/own_surrogate.hpp"
#include <algorithm>
#include <cmath>
#include <filesystem>

namespace suffuse::apps {
namespace {

using grains::Grading;

std::string mm(double size) {
    return fmt::format("{:.4g} mm", 1e3 * size);
}

/// Where the fines end, and why there.
struct FinesLimit {
    double finer_than = 0; ///< [m]
    std::string reason;
};

const char* reason_of(stability::FinesBasis basis) {
    switch (basis) {
    case stability::FinesBasis::Given:
        return "as specified";
    case stability::FinesBasis::Gap:
        return "the fine end of the gap in the curve";
    case stability::FinesBasis::KenneyLau:
        break;
    }
    return "Kenney and Lau's split: above it the soil holds its finer part no better than H/F = 1";
}

/// The limit that `assess` finds. Where its criteria see none, or another for each way in which an open end may go on,
/// that of the curve as it was measured; and where that has none either, the size where it is nearest to unstable.
FinesLimit find_limit(const Grading& measured, std::optional<double> typed_limit) {
    stability::AssessSpec spec;
    spec.finer_than = typed_limit;
    const Grading sharp = stability::complete_ends(measured).front();
    auto fines = stability::assess_measured(measured, spec).fines;
    fines = fines ? fines : stability::find_fine_fraction(sharp, stability::find_gap(measured), std::nullopt);
    if (fines) {
        return {fines->finer_than, reason_of(fines->basis)};
    }
    const double limit = stability::finer_limit(grains::uniformity(sharp));
    const stability::LeastRatio least = stability::least_shape_ratio(sharp, limit);
    return {
        least.at.diameter,
        fmt::format(
            "{} has no gap and is stable by Kenney and Lau 1986; here it is nearest to unstable, H/F = {:.2g}",
            stability::is_open(measured) ? "with sharp ends the curve" : "the curve", least.value
        )};
}

/// A size that reads well, where the curve still has grains on both sides of it.
double rounded(const Grading& grading, double size) {
    const double unit = std::pow(10.0, std::floor(std::log10(size)) - 2);
    const double round = std::round(size / unit) * unit;
    const double content = grains::passing(grading, round);
    return content > 0 && content < 1 ? round : size;
}

/// @throws CaseError where the split is at an end of what was measured: what lies beyond cannot be modeled.
void check_both_parts(const Grading& measured, const Grading& whole, const OwnSoil& soil, const std::string& path) {
    const double below = grains::passing(whole, soil.finer_than);
    if (below > 0 && below < 1) {
        return;
    }
    const bool has_fines = below > 0;
    const std::size_t end = has_fines ? measured.passing.size() - 1 : 0;
    throw CaseError(
        fmt::format(
            "{}: the {} would all be {} than {}, where the measured curve {} at {:.3g} %: {}\n  = measure the {} part "
            "of "
            "the curve, or say with --fines D below which size grains are fines, from {} to {}",
            path, has_fines ? "coarse grains" : "fines", has_fines ? "coarser" : "finer", mm(soil.finer_than),
            has_fines ? "ends" : "begins", 100 * measured.passing[end], soil.reason, has_fines ? "coarser" : "finer",
            mm(whole.diameter.front()), mm(whole.diameter.back())
        ),
        path
    );
}

/// The ends of the measured curve, or those requested within them.
SizeRange modeled_sizes(const Grading& measured, const std::optional<SizeRange>& typed_limit, double finer_than) {
    const double finest = grains::size_at(measured, 0), coarsest = grains::size_at(measured, 1);
    if (!typed_limit) {
        return {finest, coarsest};
    }
    const double content = grains::passing(measured, finer_than);
    const SizeRange sizes{std::max(typed_limit->first, finest), std::min(typed_limit->second, coarsest)};
    if (!(grains::passing(measured, sizes.first) < content && grains::passing(measured, sizes.second) > content)) {
        throw CaseError(fmt::format(
            "--sizes: from {} to {} there are no fines or no skeleton; the curve runs from {} to {}, its fines are "
            "finer than {}: choose sizes on both sides of that",
            mm(typed_limit->first), mm(typed_limit->second), mm(finest), mm(coarsest), mm(finer_than)
        ));
    }
    return sizes;
}

/// As many digits as an estimate has: "about 850,000", "more than 300,000,000".
std::string grains_needed(double count) {
    const double unit = std::pow(10.0, std::floor(std::log10(count)));
    return count < 1e6 ? "about " + grouped(std::llround(std::ceil(10 * count / unit) * unit / 10))
                       : "more than " + grouped(std::llround(std::floor(count / unit) * unit));
}

[[noreturn]] void
refuse(const std::string& path, const Grading& grading, const OwnSoil& soil, double needed, const OwnSoilSpec& spec) {
    const std::int64_t most = spec.particles.value_or(std::llround(most_quick_grains));
    const std::string found = fmt::format(
        "{}: sizes from {} to {} are too far apart for one sample\n  = the fines (below {}) are {}: it takes "
        "{} grains, and {}",
        path, mm(grading.diameter.front()), mm(grading.diameter.back()), mm(soil.finer_than), fines_text(soil),
        grains_needed(needed),
        spec.particles ? fmt::format("--particles allows {}", grouped(most))
                       : fmt::format("a quick sample has at most {} (--particles N allows others)", grouped(most))
    );
    constexpr double out_of_reach = 2e8; // grains: beyond any computer's memory
    const std::string described =
        needed > out_of_reach ? fmt::format(
                                    "\n  = no computer holds so many: a run can model a part of this soil only, and "
                                    "its answer is of that part\n  = only suffuse assess {} can judge the whole curve",
                                    spec.words
                                )
                              : "";
    const bool has_surrogate = is_surrogate_in_reach(soil.measured, spec.finer_than, static_cast<double>(most));
    const std::string stand_in =
        has_surrogate
            ? fmt::format(
                  "\n  = help: or simulate a surrogate, two fractions with this soil's size ratio and fines content: "
                  "suffuse new --psd {}{} --surrogate",
                  spec.words, spec.finer_than ? fmt::format(" --fines {:g}mm", 1e3 * *spec.finer_than) : ""
              )
            : "";
    const auto gap = stability::find_gap(soil.measured); // what lies in it is no skeleton
    const double coarser_than = gap ? std::max(gap->coarse_end, soil.finer_than) : soil.finer_than;
    const auto part = grains::find_modeled_part(grading, {soil.finer_than, coarser_than}, static_cast<double>(most));
    if (!part) {
        throw TooWide(
            fmt::format(
                "{}{}\n  = cutting its ends does not help: the fines are too small compared with the coarse grains\n  "
                "= to "
                "apply the stability criteria: suffuse assess {}{}",
                found, described, spec.words, stand_in
            ),
            std::nullopt, has_surrogate
        );
    }
    const Grading cut = grains::part_between(grading, part->finest, part->coarsest);
    const std::string turned = turned_text(judge_cut(soil.measured, cut, soil.finer_than));
    const auto finer = [&](double size) { return grains::passing(soil.measured, size); }; // of all the soil's mass
    const double fines_kept = 1 - finer(part->finest) / finer(soil.finer_than);
    const double coarse_kept = (finer(part->coarsest) - finer(coarser_than)) / (1 - finer(coarser_than));
    throw TooWide(
        fmt::format(
            "{}{}\n  = help: cut the curve: --sizes {:.4g}mm,{:.4g}mm added to the command keeps {:.0f} % of the fines "
            "and "
            "{:.0f} % of the coarse grains{}{}",
            found, described, 1e3 * part->finest, 1e3 * part->coarsest, 100 * fines_kept, 100 * coarse_kept,
            turned.empty() ? "" : "\n  = cutting changes these verdicts (whole soil -> modeled part): " + turned,
            stand_in
        ),
        SizeRange(part->finest, part->coarsest), has_surrogate
    );
}

} // namespace

std::string soil_name(const std::string& path) {
    constexpr std::size_t most = 64;
    std::string name = std::filesystem::path(path).stem().string().substr(0, most);
    const auto is_plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    };
    for (char& c : name) {
        c = is_plain(c) ? c : '-';
    }
    name.erase(0, std::min(name.find_first_not_of('-'), name.size()));
    return name.empty() ? "soil" : name;
}

Grading measured_part(const Grading& measured, const std::string& path) {
    if (measured.passing.front() >= measured.passing.back()) {
        throw CaseError(fmt::format("{}: there is nothing between its sizes; measure more of the curve", path), path);
    }
    return grains::part_between(measured, measured.diameter.front(), measured.diameter.back());
}

std::string left_out_of(const Grading& measured, double finest, double coarsest) {
    const double fine = grains::passing(measured, finest), coarse = 1 - grains::passing(measured, coarsest);
    std::string text;
    if (fine > 0) {
        text = fmt::format("the {:.3g} % finer than {}", 100 * fine, mm(finest));
    }
    if (coarse > 0) {
        text += fmt::format("{}the {:.3g} % coarser than {}", text.empty() ? "" : " and ", 100 * coarse, mm(coarsest));
    }
    return text;
}

std::string fines_text(const OwnSoil& soil) {
    return soil.left_out.empty() ? fmt::format("{:.3g} % of the mass", 100 * soil.fines_content)
                                 : fmt::format(
                                       "{:.3g} % of the modeled part, {:.3g} % of the whole soil",
                                       100 * soil.fines_content, 100 * soil.fines_of_whole
                                   );
}

OwnSoil model_own_soil(const Grading& measured, const std::string& path, const OwnSoilSpec& spec) {
    constexpr double least_grains = 2000;
    const Grading whole = measured_part(measured, path);
    const FinesLimit limit = find_limit(measured, spec.finer_than);
    OwnSoil soil;
    soil.name = soil_name(path);
    soil.finer_than = spec.finer_than ? *spec.finer_than : rounded(whole, limit.finer_than);
    soil.reason = limit.reason;
    check_both_parts(measured, whole, soil, path);
    const auto [finest, coarsest] = modeled_sizes(whole, spec.sizes, soil.finer_than);
    soil.grading = grains::part_between(whole, finest, coarsest);
    soil.fines_content = grains::passing(soil.grading, soil.finer_than);
    soil.fines_of_whole = grains::passing(measured, soil.finer_than);
    soil.left_out = left_out_of(measured, finest, coarsest);
    soil.measured = measured;
    const double needed = grains::representative_count(soil.grading, soil.finer_than);
    if (needed > (spec.particles ? static_cast<double>(*spec.particles) : most_quick_grains)) {
        refuse(path, soil.grading, soil, needed, spec);
    }
    soil.is_size_given = spec.particles.has_value();
    soil.quick_grains = spec.particles.value_or(std::llround(std::max(least_grains, std::ceil(needed / 100) * 100)));
    return soil;
}

} // namespace suffuse::apps
