#pragma once
// How states answer small loads in all directions, and the figure drawn from it. Inputs are SI.

#include "suffuse/figures/figure.hpp"
#include "suffuse/study/probed_states.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::figures {

/// Where a state is least stable, and in which directions it is not; one sentence.
std::string describe_stability(const study::ProbedState& state);

/// Ours: the second-order work of each direction, and the strains that the loads lead to.
std::optional<Figure> stability_in_directions(const std::vector<study::ProbedState>& states);

} // namespace suffuse::figures
