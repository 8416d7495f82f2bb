#include "suffuse/stability/curve.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/grains/grading.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::stability {

using grains::Grading;

namespace {

constexpr double flat = 0.10;       // of the mass per tenfold size: flatter is a gap
constexpr double least_ratio = 1.5; // a narrower flat is no gap
constexpr double populated = 0.05;  // mass on either side of a gap
constexpr double taper = 2;         // tenfold sizes that grains below the finest measured size may have: open_curve.cpp

bool is_flat(const Grading& grading, std::size_t k) {
    const double rise = grading.passing[k + 1] - grading.passing[k];
    return rise < flat * std::log10(grading.diameter[k + 1] / grading.diameter[k]);
}

/// A gap has a steeper part below it. What was not measured is steeper if it is so even where it tapers off; else the
/// flat part may be the tail of the curve.
bool is_steeper_below(const Grading& grading, std::size_t first) {
    return first > 0 || grading.passing.front() > flat * taper;
}

/// Mass over diameter, summed over the segment k up to `diameter`: its surface area but for a factor [1/m].
double surface_up_to(const Grading& grading, std::size_t k, double diameter) {
    const double width = std::log(grading.diameter[k + 1] / grading.diameter[k]);
    const double rise = grading.passing[k + 1] - grading.passing[k];
    return rise / width * (1 / grading.diameter[k] - 1 / diameter);
}

double width_of(const Gap& gap) {
    return gap.coarse_end / gap.fine_end;
}

void expect_both_sides(const Grading& grading, double split) {
    const double below = grains::passing(grading, split);
    expects(below > 0 && below < 1, "a split of a grading has mass on both sides");
}

/// The finest first.
std::vector<Gap> find_gaps(const Grading& grading) {
    std::vector<Gap> gaps;
    const std::size_t segments = grading.diameter.size() - 1;
    for (std::size_t first = 0; first < segments; ++first) {
        if (!is_flat(grading, first)) {
            continue;
        }
        std::size_t end = first;
        while (end < segments && is_flat(grading, end)) {
            ++end;
        }
        const Gap gap{grading.diameter[first], grading.diameter[end], grading.passing[first]};
        if (is_steeper_below(grading, first) && width_of(gap) >= least_ratio && gap.finer >= populated &&
            grading.passing[end] <= 1 - populated) {
            gaps.push_back(gap);
        }
        first = end;
    }
    return gaps;
}

} // namespace

std::vector<ShapePoint> shape_curve(const Grading& grading, double from, double to) {
    // By size, not by F: the F of a size that was looked up by its F may come back a rounding beyond it.
    const double first = grains::size_at(grading, from), last = coarse_end_at(grading, to);
    std::vector<double> sizes{first, last};
    for (const double d : grading.diameter) {
        for (const double size : {d, d / 4}) {
            if (size > first && size < last) {
                sizes.push_back(size);
            }
        }
    }
    std::ranges::sort(sizes);
    sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
    std::vector<ShapePoint> points;
    points.reserve(sizes.size());
    for (const double d : sizes) {
        points.push_back({d, grains::passing(grading, d), grains::kenney_lau_increment(grading, d)});
    }
    return points;
}

std::optional<Gap> find_gap(const Grading& grading) {
    const std::vector<Gap> gaps = find_gaps(grading);
    const auto widest = std::ranges::max_element(gaps, {}, width_of);
    return widest == gaps.end() ? std::nullopt : std::optional(*widest);
}

std::optional<Gap> find_finest_gap(const Grading& grading) {
    const std::vector<Gap> gaps = find_gaps(grading);
    return gaps.empty() ? std::nullopt : std::optional(gaps.front());
}

double coarse_end_at(const Grading& grading, double fraction) {
    const auto above = std::ranges::upper_bound(grading.passing, fraction);
    if (above == grading.passing.end()) {
        // 100 %: the first size that everything passes.
        return grains::size_at(grading, fraction);
    }
    if (above != grading.passing.begin() && *(above - 1) == fraction) {
        return grading.diameter[static_cast<std::size_t>(above - grading.passing.begin()) - 1];
    }
    return grains::size_at(grading, fraction);
}

Grading fine_part(const Grading& grading, double split) {
    expect_both_sides(grading, split);
    return grains::part_between(grading, grading.diameter.front(), split);
}

Grading coarse_part(const Grading& grading, double split) {
    expect_both_sides(grading, split);
    return grains::part_between(grading, split, grading.diameter.back());
}

double size_by_surface(const Grading& grading, double share) {
    const std::size_t segments = grading.diameter.size() - 1;
    double total = 0;
    for (std::size_t k = 0; k < segments; ++k) {
        total += surface_up_to(grading, k, grading.diameter[k + 1]);
    }
    double left = share * total;
    for (std::size_t k = 0; k < segments; ++k) {
        const double here = surface_up_to(grading, k, grading.diameter[k + 1]);
        if (here > 0 && left <= here) {
            const double rise = grading.passing[k + 1] - grading.passing[k];
            const double width = std::log(grading.diameter[k + 1] / grading.diameter[k]);
            return 1 / (1 / grading.diameter[k] - left * width / rise);
        }
        left -= here;
    }
    return grains::size_at(grading, 1);
}

} // namespace suffuse::stability
