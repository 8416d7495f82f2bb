#include "suffuse/stability/filter_ratio.hpp"

#include "suffuse/grains/grading.hpp"
#include "suffuse/stability/criterion_guide.hpp"
#include "suffuse/stability/curve.hpp"

#include <fmt/format.h>

#include <vector>

namespace suffuse::stability {

using grains::Grading;

namespace {

// 15 % of the coarse part and 15 % of the fine part: together 15 % of the soil, wherever the split is.
constexpr double between = 0.15;

std::string worst_of_all(const FilterRatio& ratio) {
    return fmt::format(
        "worst of all splits: D15c {:.3g} mm, d85f {:.3g} mm, split at F = {:.3g} %", 1e3 * ratio.coarse,
        1e3 * ratio.fine, 100 * ratio.split
    );
}

Criterion on_filter_ratio(std::string_view id, const FilterRatio& ratio) {
    Criterion criterion = define(id);
    criterion.value = ratio.value;
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

FilterRatio worst_filter_ratio(const Grading& grading, double most_fines) {
    FilterRatio worst;
    const auto look = [&worst](double fine, double coarse, double finer) {
        if (coarse / fine > worst.value) {
            worst = {coarse / fine, coarse, fine, finer / (1 - between)};
        }
    };
    // log D15c - log d85f is linear in the split except where one of the two meets a point of the curve.
    const double first = least_part * (1 - between), last = most_fines * (1 - between);
    std::vector<double> below{first, last}; // d85f
    for (const double passing : grading.passing) {
        below.push_back(passing);
        below.push_back(passing - between);
    }
    for (const double passing : below) {
        if (passing >= first && passing <= last) {
            look(grains::size_at(grading, passing), coarse_end_at(grading, passing + between), passing);
        }
    }
    return worst;
}

Criterion kezdi(const Grading& grading) {
    const FilterRatio worst = worst_filter_ratio(grading);
    Criterion criterion = on_filter_ratio("kezdi-1979", worst);
    criterion.remark = worst_of_all(worst);
    return criterion;
}

Criterion sherard(const Grading& grading, const std::optional<FineFraction>& fines) {
    const FilterRatio ratio = fines ? filter_ratio(grading, fines->finer_than) : worst_filter_ratio(grading);
    Criterion criterion = on_filter_ratio("sherard-1979", ratio);
    criterion.remark = fines ? fmt::format(
                                   "D15c {:.3g} mm, d85f {:.3g} mm, split at F = {:.3g} %", 1e3 * ratio.coarse,
                                   1e3 * ratio.fine, 100 * ratio.split
                               )
                             : worst_of_all(ratio);
    return criterion;
}

} // namespace suffuse::stability
