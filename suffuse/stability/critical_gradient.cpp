#include "suffuse/stability/critical_gradient.hpp"

#include "suffuse/base/factor_of_safety.hpp"
#include "suffuse/stability/criterion_guide.hpp"

#include <fmt/format.h>

namespace suffuse::stability {

namespace {

constexpr double water_density = 1000; // [kg/m3]

/// Number i, limit i_c, and what is left of it. Below the limit of vertical flow an inclined one may still move grains:
/// level flow does so at lower gradients, for which there is no formula here.
Criterion against(std::string_view id, const Seepage& seepage, double critical) {
    Criterion criterion = define(id);
    criterion.value = seepage.gradient;
    criterion.limit = critical;
    criterion.verdict = judge(criterion);
    if (criterion.verdict == Verdict::Stable && seepage.way() != upward) {
        criterion.verdict = Verdict::CannotSay;
    }
    return criterion;
}

double heave_of(const Seepage& seepage) {
    return terzaghi_gradient(seepage.porosity, seepage.grain_density);
}

/// The critical gradient over the specified one.
std::string factor_of_safety(const Criterion& criterion) {
    if (criterion.verdict == Verdict::CannotSay) {
        return "the limit is that of vertical flow; toward level flow there is none, and grains move at lower "
               "gradients: see the atlas";
    }
    return *criterion.value > 0 ? "factor of safety " + factor_text(*criterion.limit / *criterion.value)
                                : "no seepage, so no factor of safety";
}

} // namespace

double terzaghi_gradient(double porosity, double grain_density) {
    return (grain_density / water_density - 1) * (1 - porosity);
}

Criterion terzaghi(const Seepage& seepage) {
    Criterion criterion = against("terzaghi", seepage, heave_of(seepage));
    criterion.remark = factor_of_safety(criterion);
    return criterion;
}

Criterion skempton_brogan(const Seepage& seepage, Verdict by_shape) {
    const double whole = heave_of(seepage);
    const bool all_carry = by_shape == Verdict::Stable;
    const double share = seepage.stress_share.value_or(1);
    Criterion criterion = against("skempton-brogan-1994", seepage, share * whole);
    if (seepage.stress_share) {
        criterion.remark = fmt::format("alpha = {:.3g}, {}", share, factor_of_safety(criterion));
    } else if (all_carry) {
        criterion.remark = fmt::format("alpha = 1 because (H/F)min >= 1.3 (stable), {}", factor_of_safety(criterion));
    } else if (criterion.verdict == Verdict::Unstable) {
        criterion.remark = fmt::format("whatever the fines carry, {}", factor_of_safety(criterion));
    } else {
        criterion.limit.reset();
        criterion.verdict = Verdict::CannotSay;
        criterion.remark = fmt::format(
            "alpha (mean effective stress in the fines / in the soil) is unknown; the fines stay in place only if "
            "alpha >= {:.3g}",
            seepage.gradient / whole
        );
    }
    return criterion;
}

} // namespace suffuse::stability
