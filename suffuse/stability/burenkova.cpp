#include "suffuse/stability/burenkova.hpp"

#include "suffuse/grains/grading.hpp"
#include "suffuse/stability/criterion_guide.hpp"
#include "suffuse/stability/curve.hpp"

#include <fmt/format.h>

#include <cmath>

namespace suffuse::stability {

using grains::Grading;

namespace {

// Sizes that part clay, fines and sand [m]; fines by the sieve of the dams literature (No. 200).
constexpr double clay_size = 0.002e-3, silt_size = 0.075e-3, sand_size = 2e-3;

struct Slopes {
    double coarse = 0, whole = 0; ///< h' = d90/d60, h'' = d90/d15 [-]

    [[nodiscard]] double lower() const { return 0.76 * std::log10(whole) + 1; }

    [[nodiscard]] double upper() const { return 1.86 * std::log10(whole) + 1; }
};

Slopes slopes_of(const Grading& grading) {
    const double d90 = grains::size_at(grading, 0.90);
    return {d90 / grains::size_at(grading, 0.60), d90 / grains::size_at(grading, 0.15)};
}

/// Why Wan and Fell's fit does not speak of this soil; empty where it does.
std::string
outside_of_fit(const Grading& grading, const Slopes& slopes, const std::optional<FineFraction>& fines, bool has_silt) {
    if (!(grains::passing(grading, sand_size) < 1)) {
        return "valid for soils with gravel; this one has nothing coarser than 2 mm";
    }
    if (slopes.coarse > slopes.upper()) {
        return fmt::format("h' = {:.3g} is above Burenkova's band, where no soil was tested", slopes.coarse);
    }
    if (!has_silt) {
        return {};
    }
    const double clay = grains::passing(grading, clay_size);
    if (clay > 0.10) {
        return fmt::format("{:.3g} % of clay; fitted up to 10 %", 100 * clay);
    }
    if (fines && fines->content < 0.15) {
        return fmt::format("{:.3g} % of fine fraction; doubtful below 15 %", 100 * fines->content);
    }
    return {};
}

} // namespace

Criterion burenkova(const Grading& grading) {
    const Slopes slopes = slopes_of(grading);
    Criterion criterion = define("burenkova-1993");
    criterion.value = slopes.coarse;
    criterion.limit = slopes.lower();
    criterion.upper = slopes.upper();
    const double largest = grains::size_at(grading, 1), uniformity = grains::uniformity(grading);
    if (largest > 0.1) {
        criterion.remark = fmt::format("grains up to {:.3g} mm; tested up to 100 mm", 1e3 * largest);
        return criterion;
    }
    if (uniformity > 200) {
        criterion.remark = fmt::format("D60/D10 = {:.3g}; tested up to 200", uniformity);
        return criterion;
    }
    criterion.verdict = judge(criterion);
    criterion.remark = fmt::format("h'' = d90/d15 = {:.3g}", slopes.whole);
    return criterion;
}

Criterion wan_fell(const Grading& grading, const std::optional<FineFraction>& fines) {
    const Slopes slopes = slopes_of(grading);
    const bool has_silt = grains::passing(grading, silt_size) > 0.10;
    const double log_whole = std::log10(slopes.whole);
    const double z = has_silt ? 2.378 * log_whole - 3.648 * slopes.coarse + 3.701
                              : 3.875 * log_whole - 3.591 * slopes.coarse + 2.436;
    Criterion criterion = define("wan-fell-logistic");
    criterion.value = 1 / (1 + std::exp(-z));
    criterion.remark = outside_of_fit(grading, slopes, fines, has_silt);
    if (!criterion.remark.empty()) {
        return criterion;
    }
    criterion.verdict = judge(criterion);
    criterion.remark = fmt::format(
        "h' = {:.3g}, h'' = {:.3g}, fit for {}", slopes.coarse, slopes.whole,
        has_silt ? "silt-sand-gravel of plasticity index up to 12" : "sand-gravel"
    );
    return criterion;
}

Criterion wan_fell_alternative(const Grading& grading, const std::optional<FineFraction>& fines) {
    const double coarse = 30 / std::log10(grains::size_at(grading, 0.90) / grains::size_at(grading, 0.60));
    const double fine = 15 / std::log10(grains::size_at(grading, 0.20) / grains::size_at(grading, 0.05));
    Criterion criterion = define("wan-fell-alternative");
    criterion.value = coarse;
    criterion.strict = true;
    if (find_gap(grading)) {
        criterion.remark = "valid for soils without a gap";
    } else if (!(grains::passing(grading, sand_size) < 1 && grains::passing(grading, silt_size) > 0.10)) {
        criterion.remark = "valid for broadly graded silt-sand-gravel";
    } else if (!fines || fines->content < 0.20) {
        criterion.remark = "doubtful below 20 % of fine fraction";
    } else {
        criterion.remark = fmt::format("15/log(d20/d5) = {:.3g}", fine);
        criterion.verdict = coarse < 70 || fine > 22   ? Verdict::Stable
                            : coarse > 80 && fine < 22 ? Verdict::Unstable
                                                       : Verdict::Transition;
    }
    return criterion;
}

} // namespace suffuse::stability
