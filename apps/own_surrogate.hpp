#pragma once
// A soil of the user's that is too wide to simulate, as a case with two fractions that stand for it.

#include "suffuse/grains/soil.hpp"

#include "apps/own_soil.hpp"
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace suffuse::apps {

struct OwnSurrogate {
    std::string name;           ///< of the file, fit for a table of a case and a folder
    grains::Soil soil;          ///< the surrogate at the largest of its ratios
    std::string reason;         ///< why the curve is split there
    std::vector<double> ratios; ///< that are simulated, rising: the soil's alone, or several up to the largest in reach
    std::int64_t coarse_grains = 0; ///< of each sample
    std::int64_t grains = 0;        ///< of a sample at the largest of them

    [[nodiscard]] bool is_extrapolated() const { return ratios.size() > 1; }
};

/// @param finer_than where the curve is split [m]; found on it unless given
/// @param most grains of a sample
/// @param words of a command that reads the curve: "table.csv --sample TP1"
/// @throws CaseError where no split of the curve is unstable, or the curve does not show both parts.
OwnSurrogate model_surrogate(
    const grains::Grading& measured, const std::string& path, std::optional<double> finer_than, double most,
    const std::string& words
);

bool is_surrogate_in_reach(const grains::Grading& measured, std::optional<double> finer_than, double most);

/// The case: which gradients move the fines.
std::string own_case_text(const OwnSurrogate& own, const OwnConditions& conditions);

} // namespace suffuse::apps
