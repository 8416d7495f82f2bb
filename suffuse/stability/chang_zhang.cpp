#include "suffuse/stability/chang_zhang.hpp"

#include "suffuse/grains/grading.hpp"
#include "suffuse/stability/criterion_guide.hpp"
#include "suffuse/stability/curve.hpp"
#include "suffuse/stability/kenney_lau.hpp"

#include <fmt/format.h>

namespace suffuse::stability {

using grains::Grading;

namespace {

constexpr double fines_size = 0.063e-3; // [m]

void judge_gap(const Gap& gap, double percent, Criterion& criterion) {
    criterion.measure = "gap ratio Gr";
    criterion.value = gap.coarse_end / gap.fine_end;
    criterion.sense = Sense::AtMost;
    criterion.diameter = gap.fine_end;
    criterion.remark = fmt::format(
        "gap {:.3g} to {:.3g} mm, {:.3g} % finer than 0.063 mm", 1e3 * gap.fine_end, 1e3 * gap.coarse_end, percent
    );
    if (percent > 35) {
        criterion.verdict = Verdict::Stable;
        criterion.remark += ", more than 35 %: stable with any gap";
        return;
    }
    criterion.limit = percent < 10 ? 3.0 : 0.3 * percent;
    criterion.verified = percent < 10;
    criterion.verdict = *criterion.value < *criterion.limit ? Verdict::Stable : Verdict::Unstable;
}

void judge_shape(const LeastRatio& least, double percent, Criterion& criterion) {
    criterion.measure = shape_ratio_measure;
    criterion.value = least.value;
    criterion.diameter = least.at.diameter;
    criterion.remark = fmt::format("no gap, {:.3g} % finer than 0.063 mm{}", percent, trace_text(least));
    if (percent >= 20) { // there the limit of H/F has come down to 0
        criterion.verdict = Verdict::Stable;
        criterion.remark += ", 20 % or more: stable with any H/F";
        return;
    }
    criterion.limit = percent < 5 ? 1.0 : 4.0 / 3 - percent / 15;
    criterion.verified = percent < 5;
    criterion.verdict = *criterion.value > *criterion.limit ? Verdict::Stable : Verdict::Unstable;
}

} // namespace

Criterion chang_zhang(const Grading& grading, double limit) {
    Criterion criterion = define("chang-zhang-2013");
    criterion.strict = true;
    const double percent = 100 * grains::passing(grading, fines_size);
    if (const auto gap = find_gap(grading)) {
        judge_gap(*gap, percent, criterion);
    } else {
        judge_shape(least_shape_ratio(grading, limit), percent, criterion);
    }
    return criterion;
}

} // namespace suffuse::stability
