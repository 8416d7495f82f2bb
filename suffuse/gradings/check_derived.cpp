// What a curve says of the values that were read off it. Between two sieves the curve may take any way: a value is
// compared with all that lie between its neighbors, so that no way of interpolation is judged.

#include "suffuse/gradings/derived_values.hpp"
#include "suffuse/gradings/grading_columns.hpp"
#include "suffuse/grains/grading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::gradings {

namespace {

using Kind = DerivedValue::Kind;
using grains::Grading;

struct Range {
    double least = 0, most = 0;
};

constexpr double endless = std::numeric_limits<double>::infinity();

/// Shares are written to whole percents, sizes and ratios to two digits.
constexpr double share_rounding = 0.0051, digit_rounding = 0.05;

Range passing_range(const Grading& curve, double size) {
    const auto above = std::ranges::lower_bound(curve.diameter, size * (1 - 1e-6));
    if (above == curve.diameter.end()) {
        return {curve.passing.back(), 1};
    }
    const auto k = static_cast<std::size_t>(above - curve.diameter.begin());
    if (std::abs(*above - size) <= 1e-6 * size) {
        return {curve.passing[k], curve.passing[k]};
    }
    return {k == 0 ? 0 : curve.passing[k - 1], curve.passing[k]};
}

/// Sizes that a share can pass: between the last point below it and the first above it. Where a point is that share, no
/// further than its rounding goes.
Range size_range(const Grading& curve, double share) {
    const double first = curve.passing.front(), last = curve.passing.back();
    const bool is_point = std::ranges::any_of(curve.passing, [share](double passing) {
        return std::abs(passing - share) <= share_rounding;
    });
    if (is_point) {
        const double above = std::min(last, share + 2 * share_rounding);
        return {
            grains::size_at(curve, std::max(first, share - 2 * share_rounding)),
            above >= last ? curve.diameter.back() : grains::size_at(curve, above)};
    }
    Range range{0, endless};
    for (std::size_t k = 0; k < curve.diameter.size(); ++k) {
        range.least = curve.passing[k] < share ? curve.diameter[k] : range.least;
        if (curve.passing[k] > share) {
            range.most = curve.diameter[k];
            break;
        }
    }
    return range;
}

Range over(const Range& a, const Range& b) {
    return {b.most < endless ? a.least / b.most : 0, b.least > 0 ? a.most / b.least : endless};
}

Range minus(const Range& a, const Range& b) {
    return {std::max(0.0, a.least - b.most), std::max(0.0, a.most - b.least)};
}

/// Limits of classes of size [m], of ASTM D2487 and of ISO 14688-1.
struct Classes {
    double cobbles, gravel, sand, silt;
};

constexpr Classes astm{75e-3, 4.75e-3, 0.075e-3, 0.005e-3}, iso{63e-3, 2e-3, 0.063e-3, 0.002e-3};

Range share_range(const Grading& curve, Kind kind, const Classes& limits) {
    const Range all{1, 1}, cobbles = passing_range(curve, limits.cobbles), gravel = passing_range(curve, limits.gravel),
                           sand = passing_range(curve, limits.sand), silt = passing_range(curve, limits.silt);
    switch (kind) {
    case Kind::Cobbles:
        return minus(all, cobbles);
    case Kind::Gravel: // with what is coarser, where no line is given to it
        return {minus(cobbles, gravel).least, minus(all, gravel).most};
    case Kind::Sand:
        return minus(gravel, sand);
    case Kind::Fines:
        return sand;
    case Kind::Silt:
        return minus(sand, silt);
    default:
        return silt;
    }
}

bool is_within(double value, const Range& range, double absolute, double relative) {
    return value >= range.least * (1 - relative) - absolute && value <= range.most * (1 + relative) + absolute;
}

std::string in_words(const Range& range, double unit, const char* name) {
    if (range.most == endless) {
        return fmt::format("{:.3g}{} or more", range.least / unit, name);
    }
    const double tiny = 1e-9 * range.most;
    return range.most - range.least <= tiny
               ? fmt::format("{:.3g}{}", range.most / unit, name)
               : fmt::format("{:.3g} to {:.3g}{}", range.least / unit, range.most / unit, name);
}

/// What the curve has in place of a value; empty where they agree.
struct Comparison {
    std::string given, found;
};

Comparison compare_size(const DerivedValue& value, const Grading& curve) {
    const Range range = value.kind == Kind::Largest ? Range{size_range(curve, 1 - 2 * share_rounding).least, endless}
                                                    : size_range(curve, value.at);
    const bool agree = is_within(*value.value, range, 0, digit_rounding);
    return agree ? Comparison{}
                 : Comparison{fmt::format("{:.3g} mm", 1e3 * *value.value), in_words(range, 1e-3, " mm")};
}

Comparison compare_ratio(const DerivedValue& value, const Grading& curve) {
    const Range d10 = size_range(curve, 0.1), d30 = size_range(curve, 0.3), d60 = size_range(curve, 0.6);
    const Range range = value.kind == Kind::Uniformity
                            ? over(d60, d10)
                            : over(over({d30.least * d30.least, d30.most * d30.most}, d60), d10);
    const bool agree = is_within(*value.value, range, 0, digit_rounding);
    return agree ? Comparison{} : Comparison{fmt::format("{:.3g}", *value.value), in_words(range, 1, "")};
}

Comparison compare_share(const DerivedValue& value, const Grading& curve) {
    constexpr double rounding = 0.011; // of a difference of two shares in whole percents
    const Range by_astm =
        value.kind == Kind::Passing ? passing_range(curve, value.at) : share_range(curve, value.kind, astm);
    const Range by_iso = value.kind == Kind::Passing ? by_astm : share_range(curve, value.kind, iso);
    const double share = *value.value;
    const bool is_fraction = share <= 0.01 && is_within(100 * share, by_astm, rounding, 0);
    if (is_within(share, by_astm, rounding, 0) || is_within(share, by_iso, rounding, 0) || is_fraction) {
        return {};
    }
    const std::string astm_words = in_words(by_astm, 0.01, " %"), iso_words = in_words(by_iso, 0.01, " %");
    return {
        fmt::format("{:.3g} %", 100 * share),
        value.kind == Kind::Passing ? astm_words
                                    : fmt::format("{} by ASTM D2487 and {} by ISO 14688", astm_words, iso_words)};
}

} // namespace

void check_derived(
    const std::vector<DerivedValue>& values, const Grading& grading, const std::string& soil, Problems& problems
) {
    for (const DerivedValue& value : values) {
        const bool is_mass = value.kind == Kind::Fines && !value.unit.empty() && value.unit != "%";
        if (!value.value || is_mass || value.kind == Kind::Other || value.kind == Kind::Loss) {
            continue;
        }
        const bool is_size = value.kind == Kind::SizeAt || value.kind == Kind::Largest;
        const bool is_ratio = value.kind == Kind::Uniformity || value.kind == Kind::Curvature;
        const Comparison comparison = is_size    ? compare_size(value, grading)
                                      : is_ratio ? compare_ratio(value, grading)
                                                 : compare_share(value, grading);
        if (!comparison.given.empty()) {
            problems.warning(
                sheet_remark, value.place,
                fmt::format(
                    "{}{}{} is given as {}, and the curve has {}: the curve is taken", soil, soil.empty() ? "" : ": ",
                    value.name, comparison.given, comparison.found
                ),
                "is it of another sample, or a sieve misread?"
            );
        }
    }
}

} // namespace suffuse::gradings
