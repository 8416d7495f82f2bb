#include "suffuse/grains/surrogate.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/grains/grading.hpp"

#include <fmt/format.h>

#include <cmath>

namespace suffuse::grains {
namespace {

/// Nearly equal grains, half of whose mass is finer than `median` [m].
Grading fraction_around(double median) {
    const double half = std::sqrt(surrogate_width);
    return {{median / half, median * half}, {0, 1}, ""};
}

/// Medians by mass of the two parts of a curve [m].
struct Medians {
    double coarse = 0, fines = 0;
};

std::optional<Medians> find_medians(const Grading& measured, double finer_than) {
    const double content = passing(measured, finer_than), of_fines = content / 2, of_coarse = (1 + content) / 2;
    if (!(content > 0 && content < 1) || of_fines < measured.passing.front() || of_coarse > measured.passing.back()) {
        return std::nullopt;
    }
    return Medians{size_at(measured, of_coarse), size_at(measured, of_fines)};
}

} // namespace

std::optional<double> size_ratio(const Grading& measured, double finer_than) {
    const auto medians = find_medians(measured, finer_than);
    return medians ? std::optional(medians->coarse / medians->fines) : std::nullopt;
}

Soil surrogate_of(const Grading& measured, double finer_than, std::optional<double> modeled) {
    const auto medians = find_medians(measured, finer_than);
    if (!medians) {
        throw CaseError(
            fmt::format(
                "{}: split at {:.4g} mm, {:.3g} % of the mass are finer; both parts need their middle on the measured "
                "curve, which runs from {:.3g} to {:.3g} %: choose another size",
                measured.origin.empty() ? "grading curve" : measured.origin, 1e3 * finer_than,
                100 * passing(measured, finer_than), 100 * measured.passing.front(), 100 * measured.passing.back()
            ),
            measured.origin
        );
    }
    const double of_soil = medians->coarse / medians->fines, ratio = modeled.value_or(of_soil);
    if (!(ratio >= least_size_ratio)) {
        throw CaseError(
            fmt::format(
                "size ratio {:.3g} of a surrogate: below {:.3g}, its two fractions have grains of the same size", ratio,
                least_size_ratio
            ),
            measured.origin
        );
    }
    Soil soil;
    soil.measured = measured;
    soil.surrogate = Surrogate{finer_than, of_soil, ratio};
    soil.coarse = fraction_around(medians->coarse);
    soil.fines = fraction_around(medians->coarse / ratio);
    soil.fines_content = passing(measured, finer_than);
    return soil;
}

} // namespace suffuse::grains
