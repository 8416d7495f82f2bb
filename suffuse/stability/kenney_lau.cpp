#include "suffuse/stability/kenney_lau.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace suffuse::stability {

using grains::Grading;

namespace {

constexpr double secant = 0.15; // Kezdi's mass between d and 4d [-]

std::string place(const ShapePoint& point) {
    return fmt::format("at d = {:.3g} mm, F = {:.3g} %", 1e3 * point.diameter, 100 * point.finer);
}

Criterion on_shape_ratio(const Grading& grading, double limit_of_finer, const char* year, double limit) {
    const LeastRatio least = least_shape_ratio(grading, limit_of_finer);
    Criterion criterion;
    criterion.id = fmt::format("kenney-lau-{}", year);
    criterion.name = fmt::format("Kenney and Lau {}", year);
    criterion.measure = "(H/F)min";
    criterion.value = least.value;
    criterion.limit = limit;
    criterion.remark = fmt::format("{} (F up to {:.0f} %)", place(least.at), 100 * limit_of_finer);
    criterion.source = fmt::format("KenneyLau{}", year);
    criterion.diameter = least.at.diameter;
    criterion.verdict = judge(criterion);
    return criterion;
}

} // namespace

double finer_limit(double uniformity_of_fabric) {
    constexpr double wide = 3;
    return uniformity_of_fabric > wide ? 0.20 : 0.30;
}

LeastRatio least_shape_ratio(const Grading& grading, double limit) {
    LeastRatio least{std::numeric_limits<double>::infinity(), {}};
    for (const ShapePoint& point : shape_curve(grading, 0, limit)) {
        // Between two points of the curve H/F is monotonic: the least stands at a point.
        if (point.finer > 0 && point.increment / point.finer < least.value) {
            least = {point.increment / point.finer, point};
        }
    }
    expects(least.at.finer > 0, "a grading that rises from 0 to 1 passes each limit");
    return least;
}

Criterion kenney_lau_1985(const Grading& grading, double limit) {
    return on_shape_ratio(grading, limit, "1985", 1.3);
}

Criterion kenney_lau_1986(const Grading& grading, double limit) {
    return on_shape_ratio(grading, limit, "1986", 1.0);
}

Criterion li_fannin(const Grading& grading, double limit) {
    // Above F = 15 % the number is H/15 %, so that the curve is looked at on both sides of that point.
    const LeastRatio below = least_shape_ratio(grading, std::min(secant, limit));
    LeastRatio least = below;
    for (const ShapePoint& point : shape_curve(grading, secant, limit)) {
        if (point.increment / secant < least.value) {
            least = {point.increment / secant, point};
        }
    }
    Criterion criterion;
    criterion.id = "li-fannin-2008";
    criterion.name = "Li and Fannin 2008";
    criterion.measure = "min H/min(F, 15 %)";
    criterion.value = least.value;
    criterion.limit = 1;
    criterion.remark = fmt::format("{} (F up to {:.0f} %)", place(least.at), 100 * limit);
    criterion.source = "LiFannin2008";
    criterion.diameter = least.at.diameter;
    criterion.verdict = judge(criterion);
    return criterion;
}

} // namespace suffuse::stability
