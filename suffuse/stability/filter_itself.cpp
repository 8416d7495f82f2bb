#include "suffuse/stability/filter_itself.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/stability/criterion_guide.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace suffuse::stability {

using grains::Grading;

namespace {

constexpr std::string_view own_criteria[] = {"kenney-lau-1986", "kezdi-1979"};

const Criterion& find(const Assessment& own, std::string_view id) {
    const auto found =
        std::ranges::find_if(own.criteria, [&](const Criterion& criterion) { return criterion.id == id; });
    expects(found != own.criteria.end(), "an assessment has all criteria");
    return *found;
}

/// At most 5 % finer than 0.075 mm: more of them give a filter cohesion, so that a crack in it stays open.
Criterion judge_fines(const Grading& filter) {
    Criterion criterion = define("filter-fines");
    const auto fines = share_within(filter, sieve_200);
    const double most = fines.value_or(filter.passing.front()); // finer than a larger size
    if (!fines && most > *criterion.limit) {
        criterion.remark = fmt::format("the curve ends at {:.3g} mm", 1e3 * filter.diameter.front());
        return criterion;
    }
    criterion.value = most;
    criterion.verdict = judge(criterion);
    criterion.remark = fmt::format(
        "{}{:.3g} % of the filter; more of them bind it, and a crack stays open", fines ? "" : "at most ", 100 * most
    );
    return criterion;
}

/// The largest D90 by D10 [m]. From memory of table 26-6 of [NRCS 2017].
double largest_d90(double d10) {
    struct Row {
        double d10, d90;
    };

    for (const Row& row : {Row{0.5e-3, 20e-3}, {1e-3, 25e-3}, {2e-3, 30e-3}, {5e-3, 40e-3}, {10e-3, 50e-3}}) {
        if (d10 < row.d10) {
            return row.d90;
        }
    }
    return 60e-3;
}

Criterion judge_segregation(const Grading& filter) {
    Criterion criterion = define("filter-segregation");
    const auto d10 = size_within(filter, 0.10), d90 = size_within(filter, 0.90);
    if (!d10 || !d90) {
        criterion.remark = fmt::format("{} of the filter was not measured", d10 ? "D90" : "D10");
        return criterion;
    }
    const double largest = largest_d90(*d10);
    criterion.value = *d90 / largest;
    criterion.verdict = judge(criterion);
    criterion.remark =
        fmt::format("D10F {:.3g} mm, D90F {:.3g} mm: at most {:.3g} mm", 1e3 * *d10, 1e3 * *d90, 1e3 * largest);
    return criterion;
}

} // namespace

std::vector<Criterion> judge_filter_itself(const Grading& filter, const Assessment& own) {
    std::vector<Criterion> criteria{judge_fines(filter), judge_segregation(filter)};
    for (const std::string_view id : own_criteria) {
        Criterion criterion = find(own, id);
        criterion.id = "filter-" + criterion.id;
        criterion.name = "The filter's own stability (" + criterion.name + ")";
        criteria.push_back(std::move(criterion));
    }
    return criteria;
}

std::optional<WashedOut> washed_out_d15(const Grading& filter, const Assessment& own) {
    const bool is_unstable = std::ranges::any_of(own_criteria, [&](std::string_view id) {
        return find(own, id).verdict == Verdict::Unstable;
    });
    if (!is_unstable || !own.fines) {
        return std::nullopt;
    }
    const double content = own.fines->content;
    return WashedOut{own.fines->finer_than, size_bounds(filter, content + 0.15 * (1 - content))};
}

} // namespace suffuse::stability
