#include "suffuse/stability/filter_ratio.hpp"

#include "suffuse/grains/grading.hpp"
#include "suffuse/stability/curve.hpp"

#include <fmt/format.h>

namespace suffuse::stability {

using grains::Grading;

namespace {

// 15 % of the coarse part and 15 % of the fine part: together 15 % of the soil, wherever the split is.
constexpr double between = 0.15;

/// Where no split inside the curve is worse than those toward one of its ends, there is no split to name.
std::string worst_of_all(const FilterRatio& ratio) {
    const double coarse = 1e3 * ratio.coarse, fine = 1e3 * ratio.fine;
    if (!(ratio.split > 0)) {
        return fmt::format(
            "worst toward the finest grains, where no split is left: D15 {:.3g} mm of the soil, smallest grain {:.3g} "
            "mm",
            coarse, fine
        );
    }
    if (!(ratio.split < 1)) {
        return fmt::format(
            "worst toward the coarsest grains, where no split is left: largest grain {:.3g} mm, d85 {:.3g} mm of the "
            "soil",
            coarse, fine
        );
    }
    return fmt::format(
        "worst of all splits: D15c {:.3g} mm, d85f {:.3g} mm, split at F = {:.3g} %", coarse, fine, 100 * ratio.split
    );
}

Criterion on_filter_ratio(const FilterRatio& ratio, double limit) {
    Criterion criterion;
    criterion.measure = "D15c/d85f";
    criterion.value = ratio.value;
    criterion.limit = limit;
    criterion.sense = Sense::AtMost;
    criterion.diameter = ratio.fine;
    criterion.verdict = judge(criterion);
    return criterion;
}

} // namespace

FilterRatio filter_ratio(const Grading& grading, double split) {
    const double coarse = grains::size_at(coarse_part(grading, split), between);
    const double fine = grains::size_at(fine_part(grading, split), 1 - between);
    return {coarse / fine, coarse, fine, grains::passing(grading, split)};
}

FilterRatio worst_filter_ratio(const Grading& grading) {
    FilterRatio worst;
    const auto look = [&worst](double fine, double coarse, double finer) {
        if (coarse / fine > worst.value) {
            worst = {coarse / fine, coarse, fine, finer / (1 - between)};
        }
    };
    // log D15c - log d85f is linear in the split except where one of the two meets a point of the curve.
    for (const double passing : grading.passing) {
        if (passing <= 1 - between) {
            look(grains::size_at(grading, passing), coarse_end_at(grading, passing + between), passing);
        }
        if (passing >= between) {
            look(grains::size_at(grading, passing - between), coarse_end_at(grading, passing), passing - between);
        }
    }
    return worst;
}

Criterion kezdi(const Grading& grading) {
    const FilterRatio worst = worst_filter_ratio(grading);
    Criterion criterion = on_filter_ratio(worst, 4);
    criterion.id = "kezdi-1979";
    criterion.name = "Kezdi 1979";
    criterion.source = "Kezdi1979";
    criterion.remark = worst_of_all(worst);
    return criterion;
}

Criterion sherard(const Grading& grading, const std::optional<FineFraction>& fines) {
    const FilterRatio ratio = fines ? filter_ratio(grading, fines->finer_than) : worst_filter_ratio(grading);
    Criterion criterion = on_filter_ratio(ratio, 5);
    criterion.id = "sherard-1979";
    criterion.name = "Sherard 1979";
    criterion.source = "Sherard1979";
    criterion.verified = false;
    criterion.remark = fines ? fmt::format(
                                   "D15c {:.3g} mm, d85f {:.3g} mm, split at F = {:.3g} %", 1e3 * ratio.coarse,
                                   1e3 * ratio.fine, 100 * ratio.split
                               )
                             : worst_of_all(ratio);
    return criterion;
}

} // namespace suffuse::stability
