#include "suffuse/gradings/number_shares.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::gradings {

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
    const auto mean_mass = [](double fine, double coarse) { return std::pow(fine * coarse, 1.5); };
    std::vector<double> masses{0};
    for (std::size_t k = 1; k < rising.size(); ++k) {
        const GradingPoint &fine = *rising[k - 1], &coarse = *rising[k];
        masses.push_back(masses.back() + (coarse.passing - fine.passing) * mean_mass(fine.diameter, coarse.diameter));
    }
    const double last = rising.back()->diameter, ratio = last / rising[rising.size() - 2]->diameter;
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
