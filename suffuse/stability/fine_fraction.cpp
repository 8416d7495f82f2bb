#include "suffuse/stability/fine_fraction.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/grains/grading.hpp"

#include <fmt/format.h>

namespace suffuse::stability {

const char* basis_text(FinesBasis basis) {
    switch (basis) {
    case FinesBasis::Given:
        return "as given";
    case FinesBasis::Gap:
        return "fine end of the gap";
    case FinesBasis::KenneyLau:
        break;
    }
    return "Kenney and Lau's split";
}

std::optional<FineFraction>
find_fine_fraction(const grains::Grading& grading, const std::optional<Gap>& gap, std::optional<double> limit) {
    if (limit) {
        const double content = grains::passing(grading, *limit);
        if (!(content > 0 && content < 1)) {
            throw CaseError(
                fmt::format(
                    "grading curve {}: {:.6g} % of it is finer than {:.6g} mm; fines and skeleton both need some mass: "
                    "take a size between {:.6g} and {:.6g} mm",
                    grading.origin, 100 * content, 1e3 * *limit, 1e3 * grains::size_at(grading, 0),
                    1e3 * grains::size_at(grading, 1)
                ),
                grading.origin
            );
        }
        return FineFraction{*limit, content, FinesBasis::Given};
    }
    if (gap) {
        return FineFraction{gap->fine_end, gap->finer, FinesBasis::Gap};
    }
    if (const auto split = grains::kenney_lau_split(grading)) {
        const double content = grains::passing(grading, *split);
        if (content > 0 && content < 1) {
            return FineFraction{*split, content, FinesBasis::KenneyLau};
        }
    }
    return std::nullopt;
}

} // namespace suffuse::stability
