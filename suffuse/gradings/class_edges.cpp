#include "suffuse/gradings/class_edges.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace suffuse::gradings {

namespace {

/// From shares between a size and the next finer one to those between a size and the next coarser one.
void shift_to_lower_edges(SievedSoil& soil, const BlankSize& begin) {
    const auto sieves = coarsest_first(soil);
    sieves.front()->upper = sieves.front()->diameter;
    for (std::size_t k = 0; k < sieves.size(); ++k) {
        const bool is_last = k + 1 == sieves.size();
        sieves[k]->diameter = is_last ? begin.diameter : sieves[k + 1]->diameter;
        sieves[k]->diameter_place = is_last ? begin.place : sieves[k + 1]->diameter_place;
    }
}

} // namespace

std::vector<SieveRow*> coarsest_first(SievedSoil& soil) {
    std::vector<SieveRow*> sieves;
    for (SieveRow& sieve : soil.sieves) {
        sieves.push_back(&sieve);
    }
    std::ranges::stable_sort(sieves, std::greater{}, &SieveRow::diameter);
    return sieves;
}

void settle_edges(SievedSoil& soil, Problems& problems) {
    const auto sieves = coarsest_first(soil);
    std::optional<BlankSize> begin;
    std::vector<std::string> unused;
    for (const BlankSize& blank : soil.blanks) {
        const bool has_edges = soil.meaning == ShareMeaning::OnSieve && !soil.pan && !sieves.empty();
        if (has_edges && soil.blanks.size() == 1 && blank.diameter < sieves.back()->diameter) {
            begin = blank;
            problems.warning(
                sheet_remark, blank.place,
                fmt::format(
                    "the finest size, {:.6g} mm, has no share: each share lies between its size and the next finer one",
                    1e3 * blank.diameter
                ),
                "if this sieve was not used, name the column `retained on sieve [%]`"
            );
        } else if (has_edges && soil.blanks.size() == 1 && blank.diameter > sieves.front()->diameter) {
            sieves.front()->upper = blank.diameter;
        } else {
            unused.push_back(fmt::format("{:.6g} mm", 1e3 * blank.diameter));
        }
    }
    if (!unused.empty()) {
        problems.warning(
            sheet_remark, soil.blanks.front().place,
            fmt::format("sizes without a value: {}; skipped as not used", fmt::join(unused, ", "))
        );
    }
    if (begin) {
        shift_to_lower_edges(soil, *begin);
    }
}

void close_curve(SievedSoil& soil, std::vector<GradingPoint>& points) {
    const auto sieves = coarsest_first(soil);
    const bool is_class = soil.meaning == ShareMeaning::OnSieve && !sieves.empty() && sieves.front()->upper > 0;
    if (!is_class || std::ranges::max(points, {}, &GradingPoint::passing).passing > 1 - 1e-9) {
        return;
    }
    const bool is_first = points.front().diameter >= points.back().diameter;
    GradingPoint end = is_first ? points.front() : points.back();
    end.diameter = sieves.front()->upper, end.passing = 1;
    points.insert(is_first ? points.begin() : points.end(), end);
}

bool weigh_by_size(const SievedSoil& soil, std::vector<GradingPoint>& points, Problems& problems) {
    std::vector<GradingPoint*> rising;
    for (GradingPoint& point : points) {
        rising.push_back(&point);
    }
    std::ranges::stable_sort(rising, {}, &GradingPoint::diameter);
    if (rising.size() < 2 || rising.front()->passing > 0) {
        problems.error(
            "E504", rising.empty() ? soil.end : rising.front()->passing_place,
            "shares of the number of grains need a size that none is finer than",
            "add the finest size, which 0 % of the grains pass"
        );
        return false;
    }
    const double last = rising.back()->diameter, ratio = last / rising[rising.size() - 2]->diameter;
    if (rising.back()->passing < 1 - 1e-9) {
        problems.warning(
            sheet_remark, rising.back()->passing_place,
            fmt::format(
                "{:.4g} % of the number of grains are coarser than {:.6g} mm: {:.6g} mm is assumed to bound them",
                100 * (1 - rising.back()->passing), 1e3 * last, 1e3 * last * ratio
            ),
            "add the size that all grains pass: their mass depends on it"
        );
    }
    const auto mean_mass = [](double fine, double coarse) { return std::pow(fine * coarse, 1.5); };
    std::vector<double> masses{0};
    for (std::size_t k = 1; k < rising.size(); ++k) {
        const GradingPoint &fine = *rising[k - 1], &coarse = *rising[k];
        masses.push_back(masses.back() + (coarse.passing - fine.passing) * mean_mass(fine.diameter, coarse.diameter));
    }
    const double all = masses.back() + (1 - rising.back()->passing) * mean_mass(last, last * ratio);
    for (std::size_t k = 0; k < rising.size(); ++k) {
        rising[k]->passing = all > 0 ? masses[k] / all : 0;
    }
    problems.warning(
        sheet_remark, soil.heading_place,
        "shares of the number of grains are converted to shares of mass by the mean size of each class"
    );
    return true;
}

} // namespace suffuse::gradings
