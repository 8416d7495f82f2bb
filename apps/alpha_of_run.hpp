#pragma once
// The share of the stress that fines carry, from the samples of a run: what a grading does not show.

#include "suffuse/stability/assess.hpp"

#include "apps/console.hpp"
#include <optional>
#include <string>

namespace suffuse::apps {

/// What was typed of the seepage, and of where alpha is from.
struct AlphaSource {
    std::string run; ///< folder; empty: alpha is from nowhere
    std::optional<double> gradient, porosity, density, alpha;
};

/// The specification with what the samples of the run say of this soil, where the user says nothing.
/// @param soil of the run's case; empty: whichever it has. @throws UsageError, StateError
stability::AssessSpec with_alpha_of_run(
    const AlphaSource& source, stability::AssessSpec spec, const std::string& soil, const Console& console
);

/// The case of a run whose folder was given in place of a file; the file as it is otherwise.
std::string case_of_run(const std::string& file);

} // namespace suffuse::apps
