#include "suffuse/stability/filter_between.hpp"

#include "suffuse/grains/grading.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::stability {

using grains::Grading;

namespace {

constexpr double fines_size = 0.075e-3, gravel_size = 4.75e-3; // No. 200 and No. 4 [m]

/// A size where the curve was measured.
std::optional<double> size_within(const Grading& grading, double share) {
    const bool is_measured = share >= grading.passing.front() && share <= grading.passing.back();
    return is_measured ? std::optional(grains::size_at(grading, share)) : std::nullopt;
}

std::optional<double> share_within(const Grading& grading, double size) {
    if (size < grading.diameter.front()) {
        return grading.passing.front() > 0 ? std::nullopt : std::optional(0.0);
    }
    if (size > grading.diameter.back()) {
        return grading.passing.back() < 1 ? std::nullopt : std::optional(1.0);
    }
    return grains::passing(grading, size);
}

/// The curve of what passes 4.75 mm.
Grading without_gravel(const Grading& measured, double passing) {
    Grading regraded;
    regraded.origin = measured.origin;
    for (std::size_t k = 0; k < measured.diameter.size() && measured.diameter[k] < gravel_size; ++k) {
        regraded.diameter.push_back(measured.diameter[k]);
        regraded.passing.push_back(measured.passing[k] / passing);
    }
    regraded.diameter.push_back(gravel_size);
    regraded.passing.push_back(1);
    return regraded;
}

Criterion begin(const char* id, const char* name, const char* measure, const char* source) {
    Criterion criterion;
    criterion.id = id;
    criterion.name = name;
    criterion.measure = measure;
    criterion.source = source;
    return criterion;
}

/// A ratio of two sizes that were measured, or why there is none.
void judge_ratio(
    const std::optional<double>& over, const std::optional<double>& under, double limit, Sense sense,
    const std::string& remark, Criterion& criterion
) {
    criterion.limit = limit;
    criterion.sense = sense;
    if (!over || !under) {
        criterion.remark = fmt::format("{} was not measured", over ? "the size of the base" : "D15 of the filter");
        return;
    }
    criterion.value = *over / *under;
    criterion.verdict = judge(criterion);
    criterion.remark = remark;
}

std::string mm(const std::optional<double>& size) {
    return size ? fmt::format("{:.3g} mm", 1e3 * *size) : "unknown";
}

} // namespace

BaseSoil characterize_base(const Grading& measured) {
    BaseSoil base;
    base.d15 = size_within(measured, 0.15);
    const auto below = share_within(measured, gravel_size);
    base.is_regraded = below && *below < 1 && *below > measured.passing.front();
    const Grading regraded = base.is_regraded ? without_gravel(measured, *below) : measured;
    base.fines = share_within(regraded, fines_size);
    base.d85 = size_within(regraded, 0.85);
    base.d95 = size_within(regraded, 0.95);
    if (base.fines) {
        base.category = *base.fines > 0.85 ? 1 : *base.fines >= 0.40 ? 2 : *base.fines >= 0.15 ? 3 : 4;
    }
    return base;
}

std::optional<LargestFilter> largest_filter(const BaseSoil& base) {
    constexpr double least_of_silts = 0.2e-3, of_silty_sands = 0.7e-3; // [m]
    if (base.category == 2) {
        return LargestFilter{of_silty_sands, "0.7 mm"};
    }
    if (base.category == 0 || !base.d85) {
        return std::nullopt;
    }
    if (base.category == 1) {
        return LargestFilter{std::max(9 * *base.d85, least_of_silts), "9 d85, at least 0.2 mm"};
    }
    if (base.category == 4) {
        return LargestFilter{4 * *base.d85, "4 d85"};
    }
    const double rise = std::max(4 * *base.d85 - of_silty_sands, 0.0);
    return LargestFilter{
        (0.40 - *base.fines) / 0.25 * rise + of_silty_sands, "from 0.7 mm at 40 % of fines to 4 d85 at 15 %"};
}

std::vector<Criterion> filter_criteria(const Grading& measured, const Grading& filter) {
    const BaseSoil base = characterize_base(measured);
    const auto d15 = size_within(filter, 0.15);
    const std::string regraded = base.is_regraded ? ", base regraded on 4.75 mm" : "";

    Criterion terzaghi = begin("terzaghi-filter", "Terzaghi and Peck", "D15F/d85B", "TerzaghiPeck1948");
    judge_ratio(
        d15, size_within(measured, 0.85), 4, Sense::AtMost,
        fmt::format("D15F {}, d85B {}", mm(d15), mm(size_within(measured, 0.85))), terzaghi
    );

    Criterion no_erosion = begin("no-erosion-filter", "No erosion (NRCS 2017)", "D15F/largest D15F", "NRCS2017");
    const auto largest = largest_filter(base);
    judge_ratio(
        d15, largest ? std::optional(largest->d15) : std::nullopt, 1, Sense::AtMost,
        largest ? fmt::format(
                      "base of category {} ({:.3g} % fines{}): at most {} = {}; not for dispersive clay", base.category,
                      100 * *base.fines, regraded, largest->rule, mm(largest->d15)
                  )
                : "",
        no_erosion
    );

    Criterion continuing =
        begin("continuing-erosion-filter", "Continuing erosion (Foster and Fell 2001)", "D15F/d95B", "FosterFell2001");
    judge_ratio(
        d15, base.d95, 9, Sense::AtMost,
        fmt::format("d95B {}{}; beyond, the filter never seals", mm(base.d95), regraded), continuing
    );

    Criterion drains = begin("permeability-filter", "Permeability (NRCS 2017)", "D15F/d15B", "NRCS2017");
    judge_ratio(
        d15, base.d15, 5, Sense::AtLeast, fmt::format("d15B {}; D15F also at least 0.1 mm", mm(base.d15)), drains
    );
    if (drains.value && *d15 < 0.1e-3) {
        drains.verdict = Verdict::Unstable;
    }
    return {terzaghi, no_erosion, continuing, drains};
}

const char* filter_word(Verdict verdict) {
    return verdict == Verdict::Stable ? "holds" : verdict == Verdict::CannotSay ? "cannot say" : "fails";
}

} // namespace suffuse::stability
