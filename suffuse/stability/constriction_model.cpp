#include "suffuse/stability/constriction_model.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/stability/criterion_guide.hpp"
#include "suffuse/stability/curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::stability {

using grains::Grading;

namespace {

constexpr double controlling = 0.35; // share of constrictions below the controlling one

/// Angle between the sides a and b of a triangle whose third side is c.
double angle_between(double a, double b, double c) {
    return std::acos(std::clamp((a * a + b * b - c * c) / (2 * a * b), -1.0, 1.0));
}

/// Four circles of radius r, each touching the next, in the shape that the distance from the first to the third gives.
struct Ring {
    std::array<double, 4> r{};

    [[nodiscard]] double side(std::size_t k) const { return r[k] + r[(k + 1) % 4]; }

    /// Area between the circles: the quadrilateral of their centers less their sectors.
    [[nodiscard]] double void_area(double diagonal) const {
        const double first = angle_between(side(0), diagonal, side(1)),
                     other_first = angle_between(side(3), diagonal, side(2));
        const double second = angle_between(side(0), side(1), diagonal),
                     fourth = angle_between(side(3), side(2), diagonal);
        const double at_first = first + other_first, at_third = 2 * pi - second - fourth - at_first;
        const double quadrilateral = (side(0) * side(1) * std::sin(second) + side(2) * side(3) * std::sin(fourth)) / 2;
        return quadrilateral -
               (r[0] * r[0] * at_first + r[1] * r[1] * second + r[2] * r[2] * at_third + r[3] * r[3] * fourth) / 2;
    }

    /// Change of the void area with the diagonal, from the change of each angle of the quadrilateral.
    [[nodiscard]] double area_change(double x) const {
        const double a = side(0), b = side(1), c = side(2), d = side(3);
        const double cos_second = (a * a + b * b - x * x) / (2 * a * b),
                     cos_fourth = (c * c + d * d - x * x) / (2 * c * d);
        const double sin_second = sine_of(cos_second), sin_fourth = sine_of(cos_fourth);
        const double second = x / (a * b * sin_second), fourth = x / (c * d * sin_fourth);
        const double first = -(x * x - a * a + b * b) / (2 * a * b * x * sin_second) -
                             (x * x - d * d + c * c) / (2 * c * d * x * sin_fourth);
        const double third = -second - fourth - first;
        const double quadrilateral = (a * b * cos_second * second + c * d * cos_fourth * fourth) / 2;
        return quadrilateral -
               (r[0] * r[0] * first + r[1] * r[1] * second + r[2] * r[2] * third + r[3] * r[3] * fourth) / 2;
    }

    static double sine_of(double cosine) { return std::sqrt(std::max(1 - cosine * cosine, 1e-30)); }

    /// Where the void area is largest between two diagonals: it rises to its one maximum and falls.
    /// Regula falsi on its change, with the end that stays put weighed less each time (Illinois).
    [[nodiscard]] double widest_diagonal(double low, double high) const {
        double at_low = area_change(low), at_high = area_change(high);
        if (!(at_low > 0)) {
            return low;
        }
        if (!(at_high < 0)) {
            return high;
        }
        constexpr int most = 40;
        constexpr double close = 1e-5; // the error of the area goes with its square
        for (int k = 0; k < most && high - low > close * high; ++k) {
            const double x = (low * at_high - high * at_low) / (at_high - at_low), change = area_change(x);
            if (std::abs(x - low) < close * high || std::abs(high - x) < close * high || !(std::abs(change) > 0)) {
                return x;
            }
            if (change > 0) {
                low = x, at_low = change, at_high /= 2;
            } else {
                high = x, at_high = change, at_low /= 2;
            }
        }
        return (low + high) / 2;
    }

    /// The diagonal when the second and fourth touch.
    [[nodiscard]] double longest_diagonal() const {
        const double across = r[1] + r[3];
        const double at_second = angle_between(side(0), across, side(3)) + angle_between(side(1), across, side(2));
        return std::sqrt(side(0) * side(0) + side(1) * side(1) - 2 * side(0) * side(1) * std::cos(at_second));
    }
};

/// Grain sizes that stand for equal shares of the surface area.
std::vector<double> representatives(const Grading& grading, std::size_t count) {
    std::vector<double> sizes;
    for (std::size_t k = 0; k < count; ++k) {
        sizes.push_back(size_by_surface(grading, (static_cast<double>(k) + 0.5) / static_cast<double>(count)));
    }
    return sizes;
}

/// All triples, each as often as its grains can be drawn in different order.
SizeDistribution densest(const std::vector<double>& d) {
    std::vector<std::pair<double, double>> all;
    for (std::size_t i = 0; i < d.size(); ++i) {
        for (std::size_t j = i; j < d.size(); ++j) {
            for (std::size_t k = j; k < d.size(); ++k) {
                const double orders = i == j && j == k ? 1 : i == j || j == k ? 3 : 6;
                all.emplace_back(dense_constriction(d[i], d[j], d[k]), orders);
            }
        }
    }
    return SizeDistribution(std::move(all));
}

/// All rings of four. Of the 24 orders of four grains eight are the same ring, turned or mirrored: so it is enough to
/// draw the second before the fourth, and the first before the third, with their weights.
SizeDistribution loosest(const std::vector<double>& d) {
    std::vector<std::pair<double, double>> all;
    for (std::size_t i = 0; i < d.size(); ++i) {
        for (std::size_t k = i; k < d.size(); ++k) {
            for (std::size_t j = 0; j < d.size(); ++j) {
                for (std::size_t l = j; l < d.size(); ++l) {
                    const double orders = (i == k ? 1 : 2) * (j == l ? 1 : 2);
                    // Turned by one, the ring (i j k l) is the ring (j k l i): count it once.
                    if (std::pair(i, k) <= std::pair(j, l)) {
                        const double turned = i == j && k == l ? 1 : 2;
                        all.emplace_back(loose_constriction(d[i], d[j], d[k], d[l]), orders * turned);
                    }
                }
            }
        }
    }
    return SizeDistribution(std::move(all));
}

} // namespace

double dense_constriction(double d1, double d2, double d3) {
    const double a = 1 / d1, b = 1 / d2, c = 1 / d3;
    return 1 / (a + b + c + 2 * std::sqrt(a * b + b * c + c * a));
}

double loose_constriction(double d1, double d2, double d3, double d4) {
    const Ring ring{{d1 / 2, d2 / 2, d3 / 2, d4 / 2}};
    const double diagonal = ring.widest_diagonal(ring.r[0] + ring.r[2], ring.longest_diagonal());
    return std::sqrt(4 * ring.void_area(diagonal) / pi);
}

SizeDistribution::SizeDistribution(std::vector<std::pair<double, double>> sizes_and_shares) {
    std::ranges::sort(sizes_and_shares);
    // Sizes that differ by rounding alone are one: in which order they come must not shift a percentile.
    constexpr double same = 1e-7;
    double total = 0;
    for (auto next = sizes_and_shares.begin(); next != sizes_and_shares.end();) {
        const double size = next->first;
        double share = 0;
        for (; next != sizes_and_shares.end() && next->first <= size * (1 + same); ++next) {
            share += next->second;
        }
        size_.push_back(size);
        share_.push_back(total + share / 2);
        total += share;
    }
    for (double& share : share_) {
        share /= total;
    }
}

double SizeDistribution::at(double share) const {
    const auto above = static_cast<std::size_t>(std::ranges::lower_bound(share_, share) - share_.begin());
    if (above == 0) {
        return size_.front();
    }
    if (above == size_.size()) {
        return size_.back();
    }
    const double step = (share - share_[above - 1]) / (share_[above] - share_[above - 1]);
    return std::lerp(size_[above - 1], size_[above], step);
}

double ConstrictionSizes::at(double share, double relative_density) const {
    const double dense = densest.at(share);
    return dense + share * (1 - relative_density) * (loosest.at(share) - dense);
}

ConstrictionSizes model_constrictions(const Grading& grading) {
    // Enough for Dc35 within a hundredth, in some hundredths of a second.
    constexpr std::size_t for_triples = 40, for_rings = 12;
    return {densest(representatives(grading, for_triples)), loosest(representatives(grading, for_rings))};
}

FinesAgainstConstrictions
compare_with_constrictions(const Grading& grading, const std::optional<FineFraction>& fines, double otherwise) {
    FinesAgainstConstrictions sizes;
    sizes.split = fines ? fines->finer_than : otherwise;
    const Grading fine = fine_part(grading, sizes.split);
    const ConstrictionSizes constrictions = model_constrictions(coarse_part(grading, sizes.split));
    sizes.densest_d35 = constrictions.at(controlling, 1);
    sizes.loosest_d35 = constrictions.at(controlling, 0);
    sizes.fines_d85 = size_by_surface(fine, 0.85);
    sizes.densest_passes = grains::passing(fine, sizes.densest_d35);
    sizes.loosest_passes = grains::passing(fine, sizes.loosest_d35);
    return sizes;
}

Criterion indraratna(const FinesAgainstConstrictions& sizes, std::optional<double> relative_density) {
    Criterion criterion = define("indraratna-2011");
    criterion.diameter = sizes.split;
    const double dense = sizes.densest_d35 / sizes.fines_d85, loose = sizes.loosest_d35 / sizes.fines_d85;
    if (relative_density) {
        criterion.value = std::lerp(loose, dense, *relative_density);
        criterion.verdict = judge(criterion);
        criterion.remark = fmt::format("relative density {:.0f} %", 100 * *relative_density);
        return criterion;
    }
    criterion.value = loose;
    criterion.verdict = judge(criterion);
    criterion.remark = fmt::format("{:.3g} at relative density 100 %, {:.3g} at 0 %", dense, loose);
    if (criterion.verdict == Verdict::Unstable && dense <= 1) {
        criterion.verdict = Verdict::CannotSay;
        criterion.remark += fmt::format(
            "; stable above {:.0f} %, and no relative density was given", 100 * (loose - 1) / (loose - dense)
        );
    }
    return criterion;
}

} // namespace suffuse::stability
