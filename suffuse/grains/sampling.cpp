#include "suffuse/grains/sampling.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/modeled_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suffuse::grains {
namespace {

/// A grading seen by number of grains: mass is uniform in log d between points, number is mass / d^3.
class NumberCurve {
public:
    explicit NumberCurve(const Grading& grading) : grading_(grading), above_(grading.diameter.size(), 0.0) {
        for (std::size_t k = above_.size() - 1; k-- > 0;) {
            above_[k] = above_[k + 1] + density(k) * (inverse_cube(k) - inverse_cube(k + 1)) / 3.0;
        }
    }

    /// Number of grains per unit of mass, in units of [1/m3].
    [[nodiscard]] double total() const { return above_.front(); }

    /// Size above which there are `number` grains.
    [[nodiscard]] double size_above(double number) const {
        const auto smaller = std::ranges::upper_bound(above_, number, std::greater<>());
        if (smaller == above_.begin()) {
            return grading_.diameter.front();
        }
        if (smaller == above_.end()) {
            return grading_.diameter.back();
        }
        const auto k = static_cast<std::size_t>(smaller - above_.begin()) - 1;
        const double rest = 3.0 * (number - above_[k + 1]) / density(k);
        return 1.0 / std::cbrt(inverse_cube(k + 1) + rest);
    }

private:
    [[nodiscard]] double density(std::size_t k) const { // mass per unit of log d
        return (grading_.passing[k + 1] - grading_.passing[k]) /
               std::log(grading_.diameter[k + 1] / grading_.diameter[k]);
    }

    [[nodiscard]] double inverse_cube(std::size_t k) const {
        const double d = grading_.diameter[k];
        return 1.0 / (d * d * d);
    }

    const Grading& grading_;
    std::vector<double> above_; // number of grains larger than each point of the curve
};

/// One of `count` equal shares of the number of grains, counted from the coarse end.
struct Share {
    double coarse_end, fine_end; // [m]
    double mass;                 // fraction of the soil's [-]
    double diameter;             // of the grain that stands for it [m]
};

/// A size within a gap, where the curve has no grain, goes to the end of the gap that changes the grain's mass less.
double out_of_gap(const Grading& grading, double diameter) {
    const auto& d = grading.diameter;
    const auto& f = grading.passing;
    const auto above = static_cast<std::size_t>(std::ranges::upper_bound(d, diameter) - d.begin());
    if (above == 0 || above == d.size() || !(d[above - 1] < diameter) || f[above - 1] < f[above]) {
        return diameter;
    }
    std::size_t fine = above - 1, coarse = above;
    while (fine > 0 && !(f[fine - 1] < f[fine])) {
        --fine;
    }
    while (coarse + 1 < d.size() && !(f[coarse] < f[coarse + 1])) {
        ++coarse;
    }
    const auto cube = [](double size) { return size * size * size; };
    const bool is_finer = cube(diameter) - cube(d[fine]) < cube(d[coarse]) - cube(diameter);
    return is_finer ? d[fine] : d[coarse];
}

Share share_of(const Grading& grading, const NumberCurve& curve, std::size_t k, std::size_t count) {
    const double each = curve.total() / static_cast<double>(count);
    Share share{};
    share.coarse_end = curve.size_above(each * static_cast<double>(k));
    share.fine_end = curve.size_above(each * static_cast<double>(k + 1));
    share.mass = passing(grading, share.coarse_end) - passing(grading, share.fine_end);
    share.diameter = out_of_gap(grading, std::clamp(std::cbrt(share.mass / each), share.fine_end, share.coarse_end));
    return share;
}

/// Difference of percent passing that `count` grains leave, judged from the coarsest ones: they carry the most mass
/// each.
double coarse_difference(const Grading& grading, const NumberCurve& curve, std::size_t count) {
    constexpr std::size_t looked_at = 200;
    double largest = 0;
    for (std::size_t k = 0; k < std::min(count, looked_at); ++k) {
        const Share share = share_of(grading, curve, k, count);
        if (share.mass <= largest) {
            break;
        }
        const double at = passing(grading, share.diameter);
        largest = std::max({largest, passing(grading, share.coarse_end) - at, at - passing(grading, share.fine_end)});
    }
    return largest;
}

void sort_largest_first(SampledGrains& sample) {
    std::vector<std::size_t> order(sample.radius.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return sample.radius[a] > sample.radius[b]; });
    SampledGrains sorted = sample;
    for (std::size_t k = 0; k < order.size(); ++k) {
        sorted.radius[k] = sample.radius[order[k]];
        sorted.fine[k] = sample.fine[order[k]];
    }
    sample = std::move(sorted);
}

void append(SampledGrains& sample, const Grading& grading, std::size_t count, bool fine, const Pulse& pulse) {
    for (const double d : sample_diameters(grading, count, pulse)) {
        sample.radius.push_back(0.5 * d);
        sample.fine.push_back(fine ? 1 : 0);
    }
}

/// Two gradings, each with the number of grains that its share of the mass needs.
SampledGrains sample_mixture(const Soil& soil, std::size_t particles, const Pulse& pulse) {
    const double coarse_number = (1 - soil.fines_content) * NumberCurve(*soil.coarse).total();
    const double fine_number = soil.fines_content * NumberCurve(*soil.fines).total();
    const double coarse_share = coarse_number / (coarse_number + fine_number);
    const auto coarse = static_cast<std::size_t>(std::lround(coarse_share * static_cast<double>(particles)));
    SampledGrains sample;
    append(sample, *soil.coarse, coarse, false, pulse);
    append(sample, *soil.fines, particles - coarse, true, pulse);
    sort_largest_first(sample);
    return sample;
}

/// "the grading sand.csv", or "the grading" of a curve that stands in the case itself.
std::string named(const Grading& grading) {
    return grading.origin.empty() ? "the grading" : "the grading " + grading.origin;
}

double largest_size(const Grading& grading) {
    const auto whole = std::ranges::lower_bound(grading.passing, grading.passing.back()) - grading.passing.begin();
    return grading.diameter[static_cast<std::size_t>(whole)];
}

SampledGrains sample_whole(const Soil& soil, std::size_t particles, const Pulse& pulse) {
    expect_both_parts(soil);
    const Grading& grading = *soil.whole;
    const std::optional<double> limit = fines_limit(soil);
    SampledGrains sample;
    append(sample, grading, particles, false, pulse);
    for (std::size_t g = 0; g < particles; ++g) {
        sample.fine[g] = limit && 2 * sample.radius[g] < *limit ? 1 : 0;
    }
    return sample;
}

/// How `soil` could be followed: by more grains, or where its curve may be cut without losing fines or skeleton.
std::string what_to_do(const Soil& soil, const Grading& specified, int particles) {
    constexpr double out_of_reach = 1e9;
    const double needed = grains_needed(specified, soil.grading_tolerance);
    std::string text = needed < out_of_reach ? fmt::format("take about {:.0f} particles", needed)
                                             : std::string("more than a thousand million would be needed");
    text += ", allow a larger difference (grading_tolerance)";
    const double limit = soil.coarse ? 0 : fines_limit(soil).value_or(0); // 0: no part needs it
    const auto above = followed_above(specified, particles, soil.grading_tolerance);
    const auto below = followed_below(specified, particles, soil.grading_tolerance);
    std::string parts = above && (limit == 0 || *above < limit) ? fmt::format("above {:.3g} mm", *above * 1e3) : "";
    if (below && *below > limit) {
        parts += fmt::format("{}below {:.3g} mm", parts.empty() ? "" : ", or that ", *below * 1e3);
    }
    return parts.empty() ? text
                         : fmt::format("{}, or cut the curve: {} particles follow its part {}", text, particles, parts);
}

double content_of(const SampledGrains& sample) {
    double fines = 0, all = 0;
    for (std::size_t g = sample.radius.size(); g-- > 0;) { // smallest first: small terms add up before large ones
        const double r = sample.radius[g], cube = r * r * r;
        all += cube;
        fines += sample.fine[g] != 0 ? cube : 0.0;
    }
    return fines / all;
}

void check_soil(const Soil& soil, int particles) {
    if (particles < 1) {
        throw CaseError(fmt::format("{} particles specified, expected at least 1", particles));
    }
    const bool mixed = soil.coarse && soil.fines;
    if (mixed == soil.whole.has_value() || soil.coarse.has_value() != soil.fines.has_value()) {
        throw CaseError("soil: expected either one grading curve, or both a coarse and a fine one");
    }
    if (mixed && !(soil.fines_content >= 0 && soil.fines_content <= 1)) {
        throw CaseError(
            fmt::format("soil: fines content {:.6g} found, expected between 0 and 1 (0 and 100 %)", soil.fines_content)
        );
    }
    for (const std::optional<Grading>* grading : {&soil.whole, &soil.coarse, &soil.fines}) {
        if (*grading) {
            check(**grading);
        }
    }
}

} // namespace

std::vector<double> sample_diameters(const Grading& grading, std::size_t count, const Pulse& pulse) {
    constexpr std::size_t grains_a_beat = 65'536; // some tens of milliseconds
    const NumberCurve curve(grading);
    std::vector<double> diameter(count);
    for (std::size_t k = 0; k < count; ++k) {
        if (k % grains_a_beat == 0) {
            beat(pulse, "draw", static_cast<long long>(k));
        }
        diameter[k] = share_of(grading, curve, k, count).diameter;
    }
    return diameter;
}

std::vector<double> sample_curve(std::span<const double> radius, std::span<const double> diameter) {
    std::vector<double> sorted(radius.begin(), radius.end());
    std::ranges::sort(sorted);
    std::vector<double> mass(sorted.size() + 1, 0.0); // of all grains before this one
    for (std::size_t g = 0; g < sorted.size(); ++g) {
        mass[g + 1] = mass[g] + sorted[g] * sorted[g] * sorted[g];
    }
    std::vector<double> fraction;
    fraction.reserve(diameter.size());
    for (const double d : diameter) {
        const auto finer = std::ranges::lower_bound(sorted, 0.5 * d) - sorted.begin();
        fraction.push_back(mass[static_cast<std::size_t>(finer)] / mass.back());
    }
    return fraction;
}

double largest_difference(std::span<const double> radius, const Grading& grading) {
    std::vector<double> sorted(radius.begin(), radius.end());
    std::ranges::sort(sorted);
    double total = 0;
    for (const double r : sorted) {
        total += r * r * r;
    }
    // The sample is a staircase and the curve is continuous: they are furthest apart just before or just after a step.
    double largest = 0, below = 0;
    for (std::size_t g = 0; g < sorted.size();) {
        double step = 0;
        const double r = sorted[g];
        for (; g < sorted.size() && sorted[g] == r; ++g) {
            step += r * r * r / total;
        }
        const double specified = passing(grading, 2 * r);
        largest = std::max({largest, std::abs(specified - below), std::abs(specified - (below + step))});
        below += step;
    }
    return largest;
}

double grains_per_volume(const Grading& grading) {
    return 6 / pi * NumberCurve(grading).total();
}

bool can_follow(const Grading& grading, double count, double tolerance) {
    return coarse_difference(grading, NumberCurve(grading), static_cast<std::size_t>(count)) <= tolerance;
}

double grains_needed(const Grading& grading, double tolerance) {
    constexpr double most = 1e12;
    const NumberCurve curve(grading);
    const auto enough = [&](double count) {
        return coarse_difference(grading, curve, static_cast<std::size_t>(count)) <= tolerance;
    };
    double few = 1, many = 1;
    while (!enough(many) && many < most) {
        few = many;
        many *= 2;
    }
    while (many / few > 1.02) {
        const double middle = std::floor(std::sqrt(few * many));
        if (middle <= few) {
            break;
        }
        (enough(middle) ? many : few) = middle;
    }
    const double unit = std::pow(10.0, std::floor(std::log10(many)) - 1); // two digits, rounded up
    return std::ceil(1.02 * many / unit) * unit;
}

void expect_both_parts(const Soil& soil) {
    const std::optional<double> limit = fines_limit(soil);
    if (!limit || !soil.whole) {
        return;
    }
    const double least = size_at(*soil.whole, 0), largest = soil.whole->diameter.back();
    if (!(*limit > least && *limit < largest)) {
        throw CaseError(
            fmt::format(
                "fines finer than {:.6g} mm: {} runs from {:.6g} to {:.6g} mm, so this leaves no fines or no skeleton; "
                "choose a size between",
                *limit * 1e3, named(*soil.whole), least * 1e3, largest * 1e3
            ),
            soil.whole->origin
        );
    }
}

std::optional<double> fines_limit(const Soil& soil) {
    if (soil.coarse && soil.fines) {
        const double below = largest_size(*soil.fines), above = size_at(*soil.coarse, 0);
        if (below > above) {
            throw CaseError(fmt::format(
                "soil: the fines go up to {:.6g} mm and the coarse grains begin at {:.6g} mm: size alone does not "
                "separate them; give one curve and the size of the fines (finer_than), or a packing that names its "
                "fines (.vtp, .xyz)",
                below * 1e3, above * 1e3
            ));
        }
        return std::sqrt(below * above);
    }
    if (!soil.kenney_lau || !soil.whole) {
        return soil.finer_than;
    }
    const std::optional<double> split = kenney_lau_split(*soil.whole);
    if (!split) {
        throw CaseError(
            fmt::format(
                "{}: Kenney and Lau's split does not exist, because H/F stays above 1 wherever F is at most 30 % (20 % "
                "for D60/D10 above 3; here {:.3g}): the soil counts as stable; give the size of the fines instead "
                "(finer_than)",
                named(*soil.whole), uniformity(*soil.whole)
            ),
            soil.whole->origin
        );
    }
    return split;
}

Grading specified_grading(const Soil& soil) {
    return soil.whole ? *soil.whole : mixture(*soil.coarse, *soil.fines, soil.fines_content);
}

SampledGrains sample_soil(const Soil& soil, int particles, const Pulse& pulse) {
    check_soil(soil, particles);
    const auto count = static_cast<std::size_t>(particles);
    SampledGrains sample = soil.whole ? sample_whole(soil, count, pulse) : sample_mixture(soil, count, pulse);
    const Grading specified = specified_grading(soil);
    sample.fines_content = content_of(sample);
    sample.largest_difference = largest_difference(sample.radius, specified);
    if (sample.largest_difference > soil.grading_tolerance) {
        throw CaseError(
            fmt::format(
                "{} particles cannot follow {}: largest difference of percent passing {:.3g} %, allowed {:.3g} %; {}",
                particles, named(specified), sample.largest_difference * 100, soil.grading_tolerance * 100,
                what_to_do(soil, specified, particles)
            ),
            specified.origin
        );
    }
    return sample;
}

} // namespace suffuse::grains
