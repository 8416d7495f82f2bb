#pragma once
// Figures 1 to 6 of the paper, section 3: what the fines content does to soil, strength and structure. Inputs are SI;
// tables and axes are in mm, kPa and %. A function whose input is empty makes no figure.

#include "suffuse/figures/figures.hpp"
#include "suffuse/study/fines_study.hpp"

namespace suffuse::figures {

/// Figure 1: the gradings of the mixtures as specified, and those of samples as points.
std::optional<Figure>
mixture_gradings(const std::vector<study::Mixture>& mixtures, GradingAxis axis = GradingAxis::LeftToRight);

/// Figure 3: (a) e of the loose state and e_min of the densest, (b) e, e_g and e_eq of the loose state.
std::optional<Figure> void_ratios(const study::FinesStudy& study);

/// Figure 4: b, the share of the fines' volume that is active.
std::optional<Figure> active_fines(const study::FinesStudy& study);

/// Figure 5: shares of the contacts between large, large and small, small grains.
std::optional<Figure> contact_classes(const study::FinesStudy& study);

/// Figure 6: share of the contacts between large and small grains among the strong ones.
std::optional<Figure> strong_contacts(const study::FinesStudy& study);

} // namespace suffuse::figures
