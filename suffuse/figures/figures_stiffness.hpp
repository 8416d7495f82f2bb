#pragma once
// Stiffness as laboratories draw it: G0 against the mean stress, and G against the strain. Inputs are SI.

#include "suffuse/figures/figures_laboratory.hpp"

namespace suffuse::figures {

/// Of stages that do "stiffness".
std::optional<Figure> stiffness_points(const std::vector<LaboratoryTest>& probed);

/// Secant shear modulus against shear strain: q/2 over the difference of axial and lateral strain of axisymmetric
/// tests, tau/gamma of simple shear, both since the start of the test; and the modulus of small strains. Nothing
/// without both.
/// @param probed stages that do "stiffness"; @param loaded tests whose load does not turn
std::optional<Figure>
stiffness_over_strain(const std::vector<LaboratoryTest>& probed, const std::vector<LaboratoryTest>& loaded);

} // namespace suffuse::figures
