#pragma once
// Figures 1 to 6 of the paper, section 3: what the fines content does to soil, strength and structure. Inputs are SI;
// tables and axes are in mm, kPa and %. A function whose input is empty makes no figure.

#include "suffuse/report/figures.hpp"
#include "suffuse/report/fines_study.hpp"

namespace suffuse::report {

/// Figure 1: the gradings of the mixtures as asked for, and those of samples as points.
std::optional<Figure>
mixture_gradings(const std::vector<Mixture>& mixtures, GradingAxis axis = GradingAxis::LeftToRight);

/// Figure 3: (a) e of the loose state and e_min of the densest, (b) e, e_g and e_eq of the loose state.
std::optional<Figure> void_ratios(const FinesStudy& study);

/// Figure 4: b, the share of the fines' volume that is active.
std::optional<Figure> active_fines(const FinesStudy& study);

/// Figure 5: shares of the contacts between large, large and small, small grains.
std::optional<Figure> contact_classes(const FinesStudy& study);

/// Figure 6: share of the contacts between large and small grains among the strong ones.
std::optional<Figure> strong_contacts(const FinesStudy& study);

} // namespace suffuse::report
