#include "suffuse/grains/surrogate.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/grains/grading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::grains {
namespace {

/// Log-uniform: half of its mass is finer than `median` [m].
Grading fraction_around(double median, double width) {
    const double half = std::sqrt(width);
    return {{median / half, median * half}, {0, 1}, ""};
}

/// Medians by mass of the two parts of a curve [m].
struct Medians {
    double coarse = 0, fines = 0;
};

std::optional<Medians> find_medians(const Grading& measured, double finer_than) {
    constexpr double rounding = 1e-3; // of a share, by that of a size in a case
    const double content = passing(measured, finer_than), of_fines = content / 2, of_coarse = (1 + content) / 2;
    if (!(content > 0 && content < 1) || of_fines < (1 - rounding) * measured.passing.front() ||
        of_coarse > (1 + rounding) * measured.passing.back()) {
        return std::nullopt;
    }
    return Medians{size_at(measured, of_coarse), size_at(measured, of_fines)};
}

/// Of a log-uniform part with the D90/D10 of the curve between two shares of the mass.
double width_of_part(const Grading& measured, double from, double to, double most) {
    constexpr double from_tenth_to_tenth = 0.8; // of the logarithm of its sizes
    const auto width = width_between(measured, from, to);
    return width ? std::clamp(std::pow(*width, 1 / from_tenth_to_tenth), least_width, most) : most;
}

} // namespace

std::optional<double> width_between(const Grading& curve, double from, double to) {
    constexpr double tenth = 0.1;
    const double low = from + tenth * (to - from), high = to - tenth * (to - from);
    if (low < curve.passing.front() || high > curve.passing.back()) {
        return std::nullopt;
    }
    return size_at(curve, high) / size_at(curve, low);
}

std::optional<double> size_ratio(const Grading& measured, double finer_than) {
    const auto medians = find_medians(measured, finer_than);
    return medians ? std::optional(medians->coarse / medians->fines) : std::nullopt;
}

Soil surrogate_of(const Grading& measured, const SurrogateSpec& spec) {
    const double content = passing(measured, spec.finer_than);
    const auto medians = find_medians(measured, spec.finer_than);
    if (!medians) {
        throw CaseError(
            fmt::format(
                "{}: split at {:.4g} mm, {:.3g} % of the mass are finer; both parts need their middle on the measured "
                "curve, which runs from {:.3g} to {:.3g} %: choose another size",
                measured.origin.empty() ? "grading curve" : measured.origin, 1e3 * spec.finer_than, 100 * content,
                100 * measured.passing.front(), 100 * measured.passing.back()
            ),
            measured.origin
        );
    }
    const double of_soil = medians->coarse / medians->fines, ratio = spec.size_ratio.value_or(of_soil);
    if (!(ratio >= least_size_ratio)) {
        throw CaseError(
            fmt::format(
                "size ratio {:.3g} of a surrogate: below {:.3g}, its two fractions have grains of the same size", ratio,
                least_size_ratio
            ),
            measured.origin
        );
    }
    constexpr double apart = 0.98;     // size alone separates the fractions
    const double room = apart * ratio; // the geometric mean of both widths
    const double coarse_width =
        spec.coarse_width.value_or(std::min(room, width_of_part(measured, content, 1, most_coarse_width)));
    const double fines_width = spec.fines_width.value_or(std::max(
        least_width, std::min(room * room / coarse_width, width_of_part(measured, 0, content, most_fines_width))
    ));
    Soil soil;
    soil.measured = measured;
    soil.surrogate = Surrogate{spec.finer_than, of_soil, ratio, coarse_width, fines_width};
    soil.coarse = fraction_around(medians->coarse, coarse_width);
    soil.fines = fraction_around(medians->coarse / ratio, fines_width);
    soil.fines_content = content;
    return soil;
}

} // namespace suffuse::grains
