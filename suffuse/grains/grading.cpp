#include "suffuse/grains/grading.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::grains {
namespace {

// Messages speak of sizes and masses as laboratories do.
constexpr double to_mm = 1e3;
constexpr double to_percent = 100;

constexpr double finest = 1e-10, coarsest = 1e3; // an atom, a mountain [m]

std::string name_of(const Grading& grading) {
    return grading.origin.empty() ? std::string("grading curve") : "grading curve " + grading.origin;
}

std::string point(const Grading& grading, std::size_t k) {
    return fmt::format(
        "point {} ({:.6g} mm: {:.6g} %)", k + 1, grading.diameter[k] * to_mm, grading.passing[k] * to_percent
    );
}

/// Linear in log d between points k and k + 1.
double share_between(const Grading& grading, std::size_t k, double diameter) {
    return std::log(diameter / grading.diameter[k]) / std::log(grading.diameter[k + 1] / grading.diameter[k]);
}

/// H - F = F(4d) - 2 F(d): positive where the soil is stable by Kenney and Lau.
double margin(const Grading& grading, double diameter) {
    return passing(grading, 4 * diameter) - 2 * passing(grading, diameter);
}

/// Sizes between which `margin` is linear in log d: the points of the curve, and a quarter of them.
std::vector<double> breakpoints(const Grading& grading) {
    std::vector<double> sizes = grading.diameter;
    for (const double d : grading.diameter) {
        sizes.push_back(d / 4);
    }
    std::ranges::sort(sizes);
    return sizes;
}

} // namespace

void check(const Grading& grading) {
    const std::string name = name_of(grading);
    const std::size_t points = grading.diameter.size();
    if (points < 2 || grading.passing.size() != points) {
        throw CaseError(
            fmt::format("{}: {} points found, expected at least two pairs of size and percent passing", name, points),
            grading.origin
        );
    }
    for (std::size_t k = 0; k < points; ++k) {
        const double d = grading.diameter[k], f = grading.passing[k];
        if (!(std::isfinite(d) && d > 0)) {
            throw CaseError(fmt::format("{}: {}: a size must be positive", name, point(grading, k)), grading.origin);
        }
        if (d < finest || d > coarsest) {
            throw CaseError(
                fmt::format(
                    "{}: {}: expected a size from {:.0e} to {:.0e} mm; check the unit of the column", name,
                    point(grading, k), finest * to_mm, coarsest * to_mm
                ),
                grading.origin
            );
        }
        if (!(f >= 0 && f <= 1)) {
            throw CaseError(
                fmt::format("{}: {}: expected between 0 and 100 % passing", name, point(grading, k)), grading.origin
            );
        }
        if (k > 0 && !(d > grading.diameter[k - 1] && f >= grading.passing[k - 1])) {
            throw CaseError(
                fmt::format(
                    "{}: {} follows {}: sizes must increase and percent passing must not fall; sort the points or "
                    "correct the value",
                    name, point(grading, k), point(grading, k - 1)
                ),
                grading.origin
            );
        }
    }
    if (grading.passing.front() != 0 || grading.passing.back() != 1) {
        throw CaseError(
            fmt::format(
                "{}: it runs from {:.6g} to {:.6g} %, expected from 0 to 100 %; add the smallest size with 0 % and the "
                "largest with 100 %",
                name, grading.passing.front() * to_percent, grading.passing.back() * to_percent
            ),
            grading.origin
        );
    }
}

double passing(const Grading& grading, double diameter) {
    const auto& d = grading.diameter;
    if (diameter <= d.front()) {
        return grading.passing.front();
    }
    if (diameter >= d.back()) {
        return grading.passing.back();
    }
    const auto k = static_cast<std::size_t>(std::ranges::upper_bound(d, diameter) - d.begin()) - 1;
    return std::lerp(grading.passing[k], grading.passing[k + 1], share_between(grading, k, diameter));
}

double size_at(const Grading& grading, double fraction) {
    const auto& f = grading.passing;
    const auto above = std::ranges::lower_bound(f, fraction);
    if (above == f.begin()) { // the fine end itself, past points that all have no passing
        const auto last = static_cast<std::size_t>(std::ranges::upper_bound(f, f.front()) - f.begin()) - 1;
        return grading.diameter[last];
    }
    if (above == f.end()) {
        return grading.diameter.back();
    }
    const auto k = static_cast<std::size_t>(above - f.begin()) - 1;
    const double share = (fraction - f[k]) / (f[k + 1] - f[k]);
    return grading.diameter[k] * std::pow(grading.diameter[k + 1] / grading.diameter[k], share);
}

double uniformity(const Grading& grading) {
    return size_at(grading, 0.60) / size_at(grading, 0.10);
}

double kenney_lau_increment(const Grading& grading, double diameter) {
    return passing(grading, 4 * diameter) - passing(grading, diameter);
}

std::optional<double> kenney_lau_split(const Grading& grading) {
    constexpr double wide = 3.0; // D60/D10 above which the primary fabric counts as widely graded
    const double limit = uniformity(grading) > wide ? 0.20 : 0.30;
    const std::vector<double> sizes = breakpoints(grading);
    std::optional<double> begin;
    for (std::size_t k = 0; k + 1 < sizes.size(); ++k) {
        const double m0 = margin(grading, sizes[k]), m1 = margin(grading, sizes[k + 1]);
        const bool falls = m0 >= 0 && m1 < 0, rises = m0 < 0 && m1 >= 0;
        if (!falls && !rises) {
            continue;
        }
        const double crossing = sizes[k] * std::pow(sizes[k + 1] / sizes[k], m0 / (m0 - m1));
        if (falls && !begin && passing(grading, crossing) <= limit) {
            begin = crossing;
        }
        if (rises && begin) {
            return crossing;
        }
    }
    return begin;
}

Grading part_between(const Grading& grading, double finest, double coarsest) {
    const double below = passing(grading, finest), up_to = passing(grading, coarsest);
    expects(up_to > below, "a part of a grading has mass");
    Grading part;
    part.origin = grading.origin;
    part.diameter.push_back(finest);
    part.passing.push_back(0);
    for (std::size_t k = 0; k < grading.diameter.size(); ++k) {
        if (grading.diameter[k] > finest && grading.diameter[k] < coarsest) {
            part.diameter.push_back(grading.diameter[k]);
            part.passing.push_back((grading.passing[k] - below) / (up_to - below));
        }
    }
    part.diameter.push_back(coarsest);
    part.passing.push_back(1);
    return part;
}

Grading mixture(const Grading& coarse, const Grading& fines, double fines_content) {
    Grading mixed;
    mixed.diameter = coarse.diameter;
    mixed.diameter.insert(mixed.diameter.end(), fines.diameter.begin(), fines.diameter.end());
    std::ranges::sort(mixed.diameter);
    mixed.diameter.erase(std::unique(mixed.diameter.begin(), mixed.diameter.end()), mixed.diameter.end());
    for (const double d : mixed.diameter) {
        mixed.passing.push_back(std::lerp(passing(coarse, d), passing(fines, d), fines_content));
    }
    const bool both = !coarse.origin.empty() && !fines.origin.empty();
    mixed.origin = coarse.origin + (both ? " and " : "") + fines.origin;
    return mixed;
}

} // namespace suffuse::grains
