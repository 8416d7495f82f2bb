#pragma once
// The figures of the report, made from the results of a run: Figures 7 to 14 of the paper, and our own. Inputs are SI;
// tables and axes are in kPa, mm and %. Compression positive. A function whose input is empty makes no figure.

#include "suffuse/erosion/result.hpp"
#include "suffuse/figures/figure.hpp"
#include "suffuse/figures/responses.hpp"
#include "suffuse/grains/soil.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace suffuse::figures {

enum class GradingAxis { LeftToRight, Reversed };

/// Figure 7: the erosion loop, with this run's counts on its arrows.
std::optional<Figure> erosion_loop(const erosion::ErosionResult& erosion);

/// Figure 8: the specified grading and the sample's own; fines, smaller than `finer_than` [m], shaded.
std::optional<Figure> grading_curves(
    const grains::Grading& specified, const grains::Grading& sampled, std::optional<double> finer_than,
    GradingAxis axis = GradingAxis::LeftToRight
);

/// Ours: the curve of a soil, its split, and the two fractions that stand for it. Nothing for other soils.
std::optional<Figure> surrogate_grading(const grains::Soil& soil, GradingAxis axis = GradingAxis::LeftToRight);

/// Figure 9: speed of the fines in a panel a gradient.
std::optional<Figure> speed_by_gradient(const std::vector<erosion::ProbeResult>& probes);

/// Figure 10: the same in a panel a pass.
std::optional<Figure> speed_by_pass(const erosion::ErosionResult& erosion);

/// Figure 11: eroded mass of each pass.
std::optional<Figure> eroded_mass(const erosion::ErosionResult& erosion);

/// Figure 12: contacts that the removed grains had.
std::optional<Figure> eroded_coordination(const erosion::ErosionResult& erosion);

/// Figure 13: stress and volumetric strain along the path.
std::optional<Figure> stress_path(const erosion::ErosionResult& erosion);

/// Figure 14: porosity against eroded mass.
std::optional<Figure> porosity_path(const erosion::ErosionResult& erosion);

/// An erosion by its stage's name; none where there is but one.
using NamedErosion = std::pair<std::string, const erosion::ErosionResult*>;

/// Ours: how often the velocity rule and the displacement rule agree, for each probe and pass.
std::optional<Figure>
rules_compared(const std::vector<erosion::ProbeResult>& probes, const std::vector<NamedErosion>& erosions);

/// Ours: the speed of each fine grain with water against that of its twin without, a panel a pass.
std::optional<Figure> compared_with_twin(const erosion::ErosionResult& erosion);

/// Ours: constriction sizes of the coarse skeleton next to the sizes of the fines.
std::optional<Figure> constriction_sizes(const erosion::ErosionResult& erosion);

/// Ours: the sample's grading, that of the grains which left, and that of what remains. `sampled` is the grading of the
/// sample before erosion.
std::optional<Figure> eroded_grading(
    const grains::Grading& sampled, const erosion::ErosionResult& erosion, GradingAxis axis = GradingAxis::LeftToRight
);

/// Ours: how far the detached fines of each pass got along the flow, where they travel.
std::optional<Figure> transport_by_pass(const erosion::ErosionResult& erosion);

/// Ours: permeability before erosion and after each pass.
std::optional<Figure> permeability_by_pass(const erosion::ErosionResult& erosion);

} // namespace suffuse::figures
