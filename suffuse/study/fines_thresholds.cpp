#include "suffuse/study/fines_thresholds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace suffuse::study {
namespace {

constexpr double rising_part = 0.9; // of the highest value: beyond, a curve bends over into its plateau
constexpr double flat_part = 0.25;  // of the rise: one that has made more of it before the break began earlier
constexpr double uneven = 3;        // gaps to the two neighbors: beyond, the far point alone would place the vertex

/// The points of one seed that are there.
struct Points {
    std::vector<double> x, y;
};

Points points_of(const ContentCurve& curve, std::size_t seed) {
    Points points;
    for (std::size_t k = 0; k < curve.content.size(); ++k) {
        if (std::isfinite(curve.value[seed][k])) {
            points.x.push_back(curve.content[k]);
            points.y.push_back(curve.value[seed][k]);
        }
    }
    return points;
}

/// Of the parabola through three points, the middle one being an extreme of them.
double vertex_of(const std::array<double, 3>& x, const std::array<double, 3>& y) {
    const double left = (y[1] - y[0]) / (x[1] - x[0]), right = (y[2] - y[1]) / (x[2] - x[1]);
    const double curvature = (right - left) / (x[2] - x[0]);
    return curvature == 0 ? x[1] : 0.5 * (x[0] + x[1] - left / curvature);
}

struct Fit {
    double misfit = 0; ///< sum of squares
    double slope = 0;  ///< before the break
    double bend = 0;   ///< slope after the break less that before
};

/// y = a + b x + c max(0, x - x0), least squares: b and c from the columns made orthogonal one after the other.
Fit fit_two_lines(const Points& points, double x0) {
    const std::size_t n = points.x.size();
    const auto without_mean = [n](std::vector<double> v) {
        double mean = 0;
        for (const double each : v) {
            mean += each / static_cast<double>(n);
        }
        for (double& each : v) {
            each -= mean;
        }
        return v;
    };
    const auto dot = [n](const std::vector<double>& u, const std::vector<double>& v) {
        double sum = 0;
        for (std::size_t k = 0; k < n; ++k) {
            sum += u[k] * v[k];
        }
        return sum;
    };
    const auto less = [n](std::vector<double> v, double factor, const std::vector<double>& u) {
        for (std::size_t k = 0; k < n; ++k) {
            v[k] -= factor * u[k];
        }
        return v;
    };
    std::vector<double> hinge(n);
    for (std::size_t k = 0; k < n; ++k) {
        hinge[k] = std::max(0.0, points.x[k] - x0);
    }
    const std::vector<double> x = without_mean(points.x);
    hinge = without_mean(hinge);
    const double hinge_slope = dot(hinge, x) / dot(x, x);
    hinge = less(hinge, hinge_slope, x);
    std::vector<double> rest = without_mean(points.y);
    const double rest_slope = dot(rest, x) / dot(x, x);
    rest = less(rest, rest_slope, x);
    const double length = dot(hinge, hinge);
    Fit fit;
    fit.bend = length > 0 ? dot(rest, hinge) / length : 0;
    fit.slope = rest_slope - fit.bend * hinge_slope;
    rest = less(rest, fit.bend, hinge);
    fit.misfit = dot(rest, rest);
    return fit;
}

bool is_far(double gap, double other) {
    return gap > uneven * other * (1 + same_content);
}

/// Whether the line after a break has two points, and the second is so far that the break may as well lie between them.
bool depends_on_far_point(const Points& points, double at) {
    const auto after = std::ranges::upper_bound(points.x, at);
    return std::distance(after, points.x.end()) == 2 && is_far(after[1] - after[0], after[0] - after[-1]);
}

Points rising(Points points) {
    const double highest = *std::max_element(points.y.begin(), points.y.end());
    const double lowest = *std::min_element(points.y.begin(), points.y.end());
    std::size_t count = 0;
    while (count < points.y.size() && points.y[count] < lowest + rising_part * (highest - lowest)) {
        ++count;
    }
    count = std::min(count + 1, points.y.size()); // the first point beyond belongs to the rise
    points.x.resize(count);
    points.y.resize(count);
    return points;
}

/// Of every seed by `find`, which takes a curve and a seed; not a number where it finds nothing.
template <class Find>
Scatter by_seed(const ContentCurve& curve, const Find& find) {
    std::vector<double> of_seed;
    for (std::size_t seed = 0; seed < curve.value.size(); ++seed) {
        of_seed.push_back(find(curve, seed).value_or(std::nan("")));
    }
    return scatter_of(std::move(of_seed));
}

} // namespace

ContentCurve content_curve(const StageCurve& stage, const std::string& number) {
    ContentCurve curve;
    for (const SweepPoint& point : stage.points) {
        curve.content.push_back(point.value.front());
        for (const std::uint64_t seed : point.seed) {
            if (std::find(curve.seed.begin(), curve.seed.end(), seed) == curve.seed.end()) {
                curve.seed.push_back(seed);
            }
        }
    }
    curve.value.assign(curve.seed.size(), std::vector<double>(curve.content.size(), std::nan("")));
    for (std::size_t k = 0; k < stage.points.size(); ++k) {
        const SweepPoint& point = stage.points[k];
        const auto found = point.number.find(number);
        if (found == point.number.end()) {
            continue;
        }
        for (std::size_t s = 0; s < point.seed.size(); ++s) {
            const auto row = std::find(curve.seed.begin(), curve.seed.end(), point.seed[s]) - curve.seed.begin();
            curve.value[static_cast<std::size_t>(row)][k] = found->second.of_seed.at(s);
        }
    }
    return curve;
}

ContentCurve blend(const ContentCurve& a, const ContentCurve& b, double share) {
    ContentCurve curve = a;
    for (std::size_t s = 0; s < a.seed.size(); ++s) {
        const auto row = std::find(b.seed.begin(), b.seed.end(), a.seed[s]) - b.seed.begin();
        for (std::size_t k = 0; k < a.content.size(); ++k) {
            const std::optional<double> other =
                row < std::ssize(b.seed) ? value_at(b, static_cast<std::size_t>(row), a.content[k]) : std::nullopt;
            curve.value[s][k] = (1 - share) * a.value[s][k] + share * other.value_or(std::nan(""));
        }
    }
    return curve;
}

std::optional<double> value_at(const ContentCurve& curve, std::size_t seed, double content) {
    for (std::size_t k = 0; k < curve.content.size(); ++k) {
        const double value = curve.value[seed][k];
        if (std::abs(curve.content[k] - content) <= same_content && std::isfinite(value)) {
            return value;
        }
    }
    return std::nullopt;
}

bool Extreme::has_parabola() const {
    return !is_end && !is_far(at - least, most - at) && !is_far(most - at, at - least);
}

std::optional<Extreme> find_extreme(const ContentCurve& curve, std::size_t seed, Which which) {
    const Points points = points_of(curve, seed);
    if (points.x.size() < 3) {
        return std::nullopt;
    }
    const auto place = which == Which::Lowest ? std::min_element(points.y.begin(), points.y.end())
                                              : std::max_element(points.y.begin(), points.y.end());
    const auto k = static_cast<std::size_t>(place - points.y.begin());
    Extreme extreme;
    extreme.at = extreme.vertex = points.x[k];
    extreme.is_end = k == 0 || k + 1 == points.x.size();
    extreme.least = points.x[k == 0 ? 0 : k - 1];
    extreme.most = points.x[std::min(k + 1, points.x.size() - 1)];
    if (!extreme.is_end) {
        extreme.vertex =
            vertex_of({points.x[k - 1], points.x[k], points.x[k + 1]}, {points.y[k - 1], points.y[k], points.y[k + 1]});
    }
    return extreme;
}

std::optional<double> find_onset(const ContentCurve& curve, std::size_t seed) {
    constexpr std::size_t least_points = 4; // two lines have three parameters and their break
    constexpr int trials = 400;
    Points points = points_of(curve, seed);
    if (points.x.size() < least_points) {
        return std::nullopt;
    }
    points = rising(std::move(points));
    if (points.x.size() < least_points) {
        return std::nullopt;
    }
    // At least two points on each side, so that each line is a line. Where the best break is at the second or the last
    // but one of them, any break beyond it fits as well: a line has one point to go through there.
    const double first = points.x[1], last = points.x[points.x.size() - 2];
    double at = first;
    Fit best;
    best.misfit = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= trials; ++k) {
        const double x0 = k == trials ? last : first + (last - first) * k / trials;
        const Fit fit = fit_two_lines(points, x0);
        if (fit.misfit < best.misfit) {
            best = fit, at = x0;
        }
    }
    const bool is_well_placed = at > first && at < last && !depends_on_far_point(points, at);
    const auto [lowest, highest] = std::ranges::minmax(points.y);
    const bool is_flat_before = best.slope * (at - points.x.front()) <= flat_part * (highest - lowest);
    return is_well_placed && best.bend > 0 && is_flat_before ? std::optional(at) : std::nullopt;
}

std::vector<ContentThreshold> find_thresholds(const StageCurve& loose, const StageCurve* dense) {
    const auto lowest = [](const ContentCurve& curve, std::size_t seed) -> std::optional<double> {
        const std::optional<Extreme> found = find_extreme(curve, seed, Which::Lowest);
        return found && found->has_parabola() ? std::optional(found->vertex) : std::nullopt;
    };
    const ContentCurve e = content_curve(loose, "void_ratio");
    std::vector<ContentThreshold> thresholds{{ThresholdKind::LowestLoose, by_seed(e, lowest)}};
    if (dense != nullptr) {
        const ContentCurve e_min = content_curve(*dense, "void_ratio");
        for (const double density : {0.25, 0.5, 0.75}) {
            thresholds.push_back({ThresholdKind::LowestBetween, by_seed(blend(e, e_min, density), lowest), density});
        }
        thresholds.push_back({ThresholdKind::LowestDense, by_seed(e_min, lowest)});
    }
    thresholds.push_back(
        {ThresholdKind::ActiveFines, by_seed(content_curve(loose, "active_fines_fraction"), find_onset)}
    );
    thresholds.push_back(
        {ThresholdKind::StrongContacts, by_seed(content_curve(loose, "strong_contact_share.LS"), find_onset)}
    );
    return thresholds;
}

std::string ContentThreshold::from() const {
    switch (kind) {
    case ThresholdKind::LowestLoose:
        return "lowest void ratio, loose";
    case ThresholdKind::LowestBetween:
        return fmt::format("lowest void ratio at {:g} % of the way to dense", 100 * density);
    case ThresholdKind::LowestDense:
        return "lowest void ratio, dense (e_min)";
    case ThresholdKind::ActiveFines:
        return "active fines b begin to rise";
    case ThresholdKind::StrongContacts:
        break;
    }
    return "strong LS contacts begin to rise";
}

const ContentThreshold* find_threshold(const std::vector<ContentThreshold>& thresholds, ThresholdKind kind) {
    const auto found = std::ranges::find(thresholds, kind, &ContentThreshold::kind);
    return found == thresholds.end() ? nullptr : &*found;
}

} // namespace suffuse::study
