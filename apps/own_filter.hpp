#pragma once
// A base and its filter, both curves of the user's, as a stack that a case can model: its sizes, and the case itself.

#include "suffuse/grains/soil.hpp"

#include "apps/own_soil.hpp"
#include <string>

namespace suffuse::apps {

/// Grains of a stack, at most: what runs in minutes.
inline constexpr double most_stack_grains = 40'000;

struct OwnStack {
    std::string base, filter;                                   ///< names, fit for tables of a case
    grains::Grading base_curve, filter_curve;                   ///< of what was measured alone, from 0 to 100 %
    std::string base_left_out, filter_left_out;                 ///< what was not measured; empty where all was
    double width = 0, base_thickness = 0, filter_thickness = 0; ///< [m]
    std::size_t base_grains = 0, filter_grains = 0;
};

/// The smallest stack that has three of the largest grains across and in each layer, and a base of half a filter grain.
/// @param base and filter as measured: grains beyond open ends are left out, for nobody knows their sizes
/// @param words of a command that reads both: "base.csv --filter filter.csv"
/// @throws CaseError for a filter that is finer than its base, curves that so few grains cannot follow, and bases of
/// too many grains; each says what to do
OwnStack model_own_stack(
    const grains::Grading& base, const std::string& base_name, const grains::Grading& filter,
    const std::string& filter_name, const std::string& words
);

std::string own_case_text(const OwnStack& stack, const OwnConditions& conditions);

/// Of a stack, where the user gives none [-].
inline constexpr double assumed_base_gradient = 1;

} // namespace suffuse::apps
