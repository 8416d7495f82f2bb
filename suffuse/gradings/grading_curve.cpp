#include "suffuse/gradings/grading_curve.hpp"

#include "suffuse/gradings/grading_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace suffuse::gradings {

namespace {

constexpr double noise = 1e-3;     // of a digitized curve [-]
constexpr double agreement = 0.02; // of two analyses at one size [-]

std::string in_mm(double diameter) {
    return fmt::format("{:.6g} mm", diameter * 1e3);
}

std::string in_percent(double passing) {
    return fmt::format("{:.6g} %", passing * 100);
}

bool check_values(const std::vector<GradingPoint>& points, Problems& problems) {
    bool is_good = true;
    for (const GradingPoint& point : points) {
        if (!(point.diameter > 0)) {
            problems.error(
                "E504", point.diameter_place, fmt::format("a grain size of {}", in_mm(point.diameter)),
                "sizes are above 0"
            );
            is_good = false;
        }
        if (!(point.passing >= 0 && point.passing <= 1)) {
            problems.error(
                "E504", point.passing_place, fmt::format("{} passing", in_percent(point.passing)),
                "percent passing is between 0 and 100"
            );
            is_good = false;
        }
    }
    return is_good;
}

/// Shares that leave 0 to 100 % by no more than a digitized curve does.
void clip_noise(std::vector<GradingPoint>& points, Problems& problems) {
    for (GradingPoint& point : points) {
        const double clipped = std::clamp(point.passing, 0.0, 1.0), off = std::abs(point.passing - clipped);
        if (off > 1e-9 && off <= noise) {
            problems.warning(
                sheet_remark, point.passing_place,
                fmt::format("{} passing is read as {}", in_percent(point.passing), in_percent(clipped))
            );
        }
        point.passing = off <= noise ? clipped : point.passing;
    }
}

/// Where two analyses overlap, points of the hydrometer that contradict the sieves by a few percent are left out.
void settle_overlap(const std::vector<GradingPoint>& sieves, std::vector<GradingPoint>& others, Problems& problems) {
    constexpr double most = 0.03; // of two analyses, between sieves [-]
    std::size_t count = 0;
    double largest = 0;
    Place place;
    std::erase_if(others, [&](const GradingPoint& point) {
        double below = 0, above = 1;
        for (const GradingPoint& sieve : sieves) {
            if (std::abs(sieve.diameter - point.diameter) <= 1e-9 * point.diameter) {
                return false; // joined with it
            }
            sieve.diameter < point.diameter ? void(below = std::max(below, sieve.passing))
                                            : void(above = std::min(above, sieve.passing));
        }
        const double off = std::max(below - point.passing, point.passing - above);
        if (!(off > noise && off <= most)) {
            return false;
        }
        place = count == 0 ? point.passing_place : place;
        ++count, largest = std::max(largest, off);
        return true;
    });
    if (count > 0) {
        problems.warning(
            sheet_remark, place,
            fmt::format(
                "{} of the second run contradict{} the first by up to {}: left out",
                count == 1 ? "1 point" : fmt::format("{} points", count), count == 1 ? "s" : "", in_percent(largest)
            )
        );
    }
}

/// Sizes that rise or fall in two runs: those of the sieves and those of the hydrometer.
void order_two_runs(std::vector<GradingPoint>& points, Problems& problems) {
    const auto rising = [](const GradingPoint& a, const GradingPoint& b) { return a.diameter < b.diameter; };
    const auto falling = [](const GradingPoint& a, const GradingPoint& b) { return a.diameter > b.diameter; };
    // @param shared 1 where the first run's last size is the second's finest: the hydrometer begins with it
    const auto sort_runs = [&](auto first, auto second, std::ptrdiff_t shared) {
        const auto turn = std::is_sorted_until(points.begin(), points.end(), first);
        constexpr std::ptrdiff_t least = 3; // of a run; two points out of order are a slip
        if (turn == points.end() || turn - points.begin() < least + shared || points.end() - turn < least - shared ||
            !std::is_sorted(turn - shared, points.end(), second)) {
            return false;
        }
        problems.warning(
            sheet_remark, (turn - shared)->diameter_place,
            "a second run of sizes begins here, as of a hydrometer below the sieves: both are joined into one curve"
        );
        std::vector<GradingPoint> sieves(points.begin(), turn), others(turn, points.end());
        if (sieves.front().diameter + sieves.back().diameter < others.front().diameter + others.back().diameter) {
            std::swap(sieves, others);
        }
        settle_overlap(sieves, others, problems);
        points = std::move(sieves);
        points.insert(points.end(), others.begin(), others.end());
        std::stable_sort(points.begin(), points.end(), rising);
        return true;
    };
    if (!sort_runs(rising, rising, 0) && !sort_runs(falling, falling, 0) && !sort_runs(rising, falling, 0)) {
        sort_runs(falling, rising, 1);
    }
}

/// The size at which two analyses meet, measured by both.
void join_twins(std::vector<GradingPoint>& points, Problems& problems) {
    for (std::size_t k = 1; k < points.size();) {
        GradingPoint &first = points[k - 1], &second = points[k];
        const double off = std::abs(first.passing - second.passing);
        if (std::abs(first.diameter - second.diameter) > 1e-9 * first.diameter || off > agreement) {
            ++k;
            continue;
        }
        const double mean = (first.passing + second.passing) / 2;
        problems.warning(
            sheet_remark, second.diameter_place,
            fmt::format(
                "{} occurs twice, with {} and {} passing: joined as {}", in_mm(first.diameter),
                in_percent(first.passing), in_percent(second.passing), in_percent(mean)
            )
        );
        first.passing = mean;
        points.erase(points.begin() + static_cast<std::ptrdiff_t>(k));
    }
}

/// Falls of the curve that are smaller than a digitizer's step.
void smooth_noise(std::vector<GradingPoint>& points, Problems& problems) {
    double most = 0;
    const GradingPoint* at = nullptr;
    for (std::size_t k = 1; k < points.size(); ++k) {
        const double fall = points[k - 1].passing - points[k].passing;
        if (fall > 0 && fall <= noise) {
            if (fall > most) {
                most = fall, at = &points[k];
            }
            points[k].passing = points[k - 1].passing;
        }
    }
    if (at != nullptr && most > 1e-12) {
        problems.warning(
            sheet_remark, at->passing_place,
            fmt::format("percent passing falls by up to {} as the size grows: smoothed as noise", in_percent(most))
        );
    }
}

/// Points with sizes rising.
bool check_order(const std::vector<GradingPoint>& points, Problems& problems) {
    const auto rises = [](const GradingPoint& below, const GradingPoint& point) {
        return point.passing > below.passing;
    };
    if (points.size() > 2 && std::ranges::adjacent_find(points, rises) == points.end() &&
        rises(points.back(), points.front())) {
        problems.error(
            "E503", points.front().passing_place,
            fmt::format(
                "percent passing falls throughout, from {} at {} to {} at {}", in_percent(points.front().passing),
                in_mm(points.front().diameter), in_percent(points.back().passing), in_mm(points.back().diameter)
            ),
            "name the column `cumulative retained [%]` if that is what it holds"
        );
        return false;
    }
    bool is_good = true;
    for (std::size_t k = 1; k < points.size(); ++k) {
        const GradingPoint &below = points[k - 1], &point = points[k];
        if (!(point.diameter > below.diameter)) {
            problems.error(
                "E503", point.diameter_place,
                fmt::format(
                    "the grading is not monotonic: {} is next to {}", in_mm(point.diameter), in_mm(below.diameter)
                ),
                "sizes must rise from line to line, or fall from line to line, each once"
            );
            is_good = false;
        } else if (point.passing < below.passing) {
            problems.error(
                "E503", point.passing_place,
                fmt::format(
                    "the grading is not monotonic: {} passes {}, but {} passes the smaller {}",
                    in_percent(point.passing), in_mm(point.diameter), in_percent(below.passing), in_mm(below.diameter)
                ),
                "percent passing cannot fall as the size grows"
            );
            is_good = false;
        }
    }
    return is_good;
}

/// Curves that no soil has, but one whose unit was forgotten.
bool check_units(const std::vector<GradingPoint>& points, Problems& problems) {
    constexpr double stones = 0.06, least_end = 0.02; // [m], [-]
    if (points.front().diameter >= stones && !points.front().has_unit) {
        problems.error(
            "E504", points.front().diameter_place,
            fmt::format("the smallest size is {}: a soil of stones alone", in_mm(points.front().diameter)),
            "sizes are in mm unless the header says otherwise: `d [um]` for micrometers"
        );
        return false;
    }
    if (points.back().passing <= least_end) {
        problems.error(
            "E504", points.back().passing_place,
            fmt::format(
                "the curve ends at {} passing {}", in_percent(points.back().passing), in_mm(points.back().diameter)
            ),
            "percent unless the header says otherwise: `passing [-]` for fractions"
        );
        return false;
    }
    return true;
}

/// From nothing to everything, sizes rising.
bool check_ends(const std::vector<GradingPoint>& points, Problems& problems) {
    const bool is_open_below = points.front().passing != 0;
    const GradingPoint& end = is_open_below ? points.front() : points.back();
    if (end.passing == (is_open_below ? 0 : 1)) {
        return true;
    }
    problems.error(
        "E504", end.passing_place,
        fmt::format(
            "the curve {} at {} passing {}", is_open_below ? "starts" : "ends", in_percent(end.passing),
            in_mm(end.diameter)
        ),
        is_open_below ? "add the size that nothing passes (0 %): the smallest grains that you want to model"
                      : "add the size that everything passes (100 %)"
    );
    return false;
}

} // namespace

std::optional<grains::Grading> make_grading(
    std::vector<GradingPoint> points, const std::string& origin, const Place& whole, Problems& problems, CurveEnds ends
) {
    if (points.size() < 2) {
        problems.error(
            "E505", whole,
            fmt::format(
                "a grading curve needs at least two points, and there {} {}", points.size() == 1 ? "is" : "are",
                points.size()
            ),
            "a line for each sieve: its size and the percent passing"
        );
        return std::nullopt;
    }
    clip_noise(points, problems);
    if (!check_values(points, problems)) {
        return std::nullopt;
    }
    order_two_runs(points, problems);
    // Sieve tables often start with the coarsest.
    if (points.front().diameter > points.back().diameter) {
        std::reverse(points.begin(), points.end());
    }
    join_twins(points, problems);
    smooth_noise(points, problems);
    if (!check_order(points, problems) || !check_units(points, problems)) {
        return std::nullopt;
    }
    if (ends == CurveEnds::Closed && !check_ends(points, problems)) {
        return std::nullopt;
    }
    grains::Grading grading;
    grading.origin = origin;
    for (const GradingPoint& point : points) {
        grading.diameter.push_back(point.diameter);
        grading.passing.push_back(point.passing);
    }
    return grading;
}

} // namespace suffuse::gradings
