#pragma once
// What to type after an assessment: which simulation of these curves is in reach.

#include "suffuse/grains/grading.hpp"

#include <optional>
#include <string>

namespace suffuse::apps {

/// @param words of a command that reads the case
std::string advise_run(const std::string& words);

/// The soil whole, else a surrogate of it, else where it says what to do.
/// @param words of a command that reads the curve: "table.csv --sample TP1"
/// @param fines as typed, and the size that it is [m]
std::string advise_new(
    const grains::Grading& measured, const std::string& words, const std::string& fines,
    const std::optional<double>& finer_than
);

/// Of a base and its filter. @return nothing where no stack of theirs is in reach
std::string advise_stack(const grains::Grading& base, const grains::Grading& filter, const std::string& words);

} // namespace suffuse::apps
