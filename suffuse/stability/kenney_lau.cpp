#include "suffuse/stability/kenney_lau.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/stability/criterion_guide.hpp"
#include "suffuse/stability/filter_ratio.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::stability {

using grains::Grading;

namespace {

constexpr double secant = 0.15; // Kezdi's mass between d and 4d [-]

/// The least H/min(F, cap) with 0 < F <= `limit`, where F and F(4d) are known. Between two points of the curve, and up
/// to F = cap, the ratio is monotonic: the least is at a point.
std::optional<LeastRatio> least_ratio(const Grading& grading, double limit, double cap) {
    const double from = grading.passing.front(), end = std::min(limit, grading.passing.back());
    std::optional<LeastRatio> least;
    const auto look = [&](double low, double high) {
        if (low > high) {
            return;
        }
        for (const ShapePoint& point : shape_curve(grading, low, high)) {
            const bool is_known = grading.passing.back() >= 1 || 4 * point.diameter <= grading.diameter.back();
            const double ratio = point.increment / std::min(point.finer, cap);
            if (is_known && point.finer > 0 && (!least || ratio < least->value)) {
                least = {ratio, point};
            }
        }
    };
    look(from, std::min(cap, end));
    look(std::max(from, cap), end);
    return least;
}

Criterion on_shape_ratio(std::string_view id, const Grading& grading, double limit_of_finer) {
    const LeastRatio least = least_shape_ratio(grading, limit_of_finer);
    Criterion criterion = define(id);
    criterion.value = least.value;
    criterion.remark = place_of(least, limit_of_finer);
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
    const std::optional<LeastRatio> least = least_ratio(grading, limit, 1);
    expects(least.has_value(), "a grading that rises from 0 to 1 passes each limit");
    return *least;
}

std::optional<LeastRatio> least_measured_ratio(const Grading& measured, double limit, const std::string& measure) {
    if (measure != shape_ratio_measure && measure != secant_ratio_measure) {
        return std::nullopt;
    }
    return least_ratio(measured, limit, measure == shape_ratio_measure ? 1 : secant);
}

std::string place_of(const LeastRatio& least, double limit) {
    return fmt::format(
        "at d = {:.3g} mm, F = {:.3g} % (F up to {:.0f} %){}", 1e3 * least.at.diameter, 100 * least.at.finer,
        100 * limit, trace_text(least)
    );
}

std::string trace_text(const LeastRatio& least) {
    return least.at.finer < least_part
               ? fmt::format("; a trace: only this {:.2g} % of the mass could leave", 100 * least.at.finer)
               : "";
}

Criterion kenney_lau_1985(const Grading& grading, double limit) {
    return on_shape_ratio("kenney-lau-1985", grading, limit);
}

Criterion kenney_lau_1986(const Grading& grading, double limit) {
    return on_shape_ratio("kenney-lau-1986", grading, limit);
}

Criterion li_fannin(const Grading& grading, double limit) {
    const LeastRatio least = *least_ratio(grading, limit, secant);
    Criterion criterion = define("li-fannin-2008");
    criterion.value = least.value;
    criterion.remark = place_of(least, limit);
    criterion.diameter = least.at.diameter;
    criterion.verdict = judge(criterion);
    return criterion;
}

} // namespace suffuse::stability
