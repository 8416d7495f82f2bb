#pragma once
// The figures that laboratories draw of tests other than triaxial compression: e against log stress, stress ratio
// against shear strain, and the loops, the path and the pore pressure of cycles. Inputs are SI.

#include "suffuse/figures/figure.hpp"
#include "suffuse/record/finished_stage.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::figures {

/// A finished stage, and what the legend calls it.
struct LaboratoryTest {
    std::string name;
    const record::FinishedStage* stage = nullptr;
};

/// Of stages that do "oedometer" or "isotropic"; nothing where there are none, as below.
std::optional<Figure> compression_curves(const std::vector<LaboratoryTest>& tests);

/// Of stages that do "shear".
std::optional<Figure> shear_curves(const std::vector<LaboratoryTest>& tests);

/// Of stages that do "cyclic".
std::optional<Figure> cyclic_curves(const std::vector<LaboratoryTest>& tests);

/// Amplitude of the cyclic stress ratio against the cycles to liquefaction, a color a name; nothing of fewer than two
/// tests that liquefied. @param tests named by the state that they start from
std::optional<Figure> cyclic_resistance(const std::vector<LaboratoryTest>& tests);

} // namespace suffuse::figures
