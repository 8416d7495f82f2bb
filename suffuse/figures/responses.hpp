#pragma once
// The figures of triaxial tests: Figure 2 of the paper and our own. Inputs are SI; tables and axes are in kPa and %.
// Compression and contraction positive.

#include "suffuse/figures/figure.hpp"
#include "suffuse/study/response_curve.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::figures {

/// Figure 2: drained compression of the loose samples, a curve for each fines content, with bands over the replicates.
std::optional<Figure> loose_compression(const std::vector<study::ResponseCurve>& tests);

/// Ours: the same for other tests, all of them or none with a held deviator, of which the pore pressure is drawn; `id`
/// is that of the figure.
std::optional<Figure> triaxial_response(
    const std::vector<study::ResponseCurve>& tests, const std::string& id = "own-triaxial",
    const std::string& title = "Triaxial compression"
);

/// Ours: the way of each test through stresses, q over p, and through states, e over the logarithm of p.
std::optional<Figure> test_paths(const std::vector<study::ResponseCurve>& tests);

} // namespace suffuse::figures
