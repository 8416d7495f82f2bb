#include "suffuse/io/read_grading.hpp"

#include "suffuse/base/read_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::io {

namespace {

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
                    "the grading is not monotonic: {} stands beside {}", in_mm(point.diameter), in_mm(below.diameter)
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
    if (points.front().diameter >= stones) {
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
    if (points.front().passing != 0) {
        problems.error(
            "E504", points.front().passing_place,
            fmt::format(
                "the curve starts at {} passing {}", in_percent(points.front().passing), in_mm(points.front().diameter)
            ),
            "add the size that nothing passes (0 %): the smallest grains that you want to model"
        );
        return false;
    }
    if (points.back().passing != 1) {
        problems.error(
            "E504", points.back().passing_place,
            fmt::format(
                "the curve ends at {} passing {}", in_percent(points.back().passing), in_mm(points.back().diameter)
            ),
            "add the size that everything passes (100 %)"
        );
        return false;
    }
    return true;
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
    if (!check_values(points, problems)) {
        return std::nullopt;
    }
    // Sieve tables often start with the coarsest.
    if (points.front().diameter > points.back().diameter) {
        std::reverse(points.begin(), points.end());
    }
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

std::optional<grains::Grading>
parse_grading(const std::shared_ptr<const Source>& source, Problems& problems, CurveEnds ends) {
    const Place whole{source, 0, 0, 1};
    if (!check_encoding(source, problems)) {
        return std::nullopt;
    }
    auto points = read_grading_points(source, problems);
    if (!points) {
        return std::nullopt;
    }
    return make_grading(std::move(*points), source->name, whole, problems, ends);
}

grains::Grading read_grading(const std::string& path, CurveEnds ends) {
    Problems problems;
    const auto grading = parse_grading(std::make_shared<Source>(Source{path, read_whole_file(path)}), problems, ends);
    if (!grading) {
        throw CaseProblems(problems.sorted());
    }
    return *grading;
}

} // namespace suffuse::io
