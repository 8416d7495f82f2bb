#pragma once
// Which grains of a soil count as its fine fraction: those that could be washed out from between the others.

#include "suffuse/grains/soil.hpp"
#include "suffuse/stability/curve.hpp"

#include <optional>

namespace suffuse::stability {

enum class FinesBasis { Given, Gap, KenneyLau };

/// "as given", "fine end of the gap", "Kenney and Lau's split".
const char* basis_text(FinesBasis basis);

struct FineFraction {
    double finer_than = 0; ///< [m]
    double content = 0;    ///< of the mass [-]
    FinesBasis basis = FinesBasis::Given;
};

/// As specified [m]; else the fine end of a gap; else where Kenney and Lau would split; nothing for a soil without
/// either.
/// @throws CaseError where the specified size has no mass on one side.
std::optional<FineFraction>
find_fine_fraction(const grains::Grading& grading, const std::optional<Gap>& gap, std::optional<double> limit);

} // namespace suffuse::stability
