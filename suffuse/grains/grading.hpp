#pragma once
// Reading a grading curve: percent passing at a size, size at a percentage, and where Kenney and Lau would cut the
// fines off [Kenney and Lau 1985, 1986; limits on F as in Fell and Wan]. A curve is linear in log d between its points.

#include "suffuse/grains/soil.hpp"

#include <optional>

namespace suffuse::grains {

/// Throws CaseError, naming the point, unless sizes are positive and increase and passing never falls, from 0 to 1.
void check(const Grading& grading);

/// F(d): mass fraction finer than `diameter` [m].
double passing(const Grading& grading, double diameter);

/// D_x: diameter below which `fraction` of the mass lies [m]; in a gap of the curve its fine end.
double size_at(const Grading& grading, double fraction);

/// Coefficient of uniformity, D60/D10 [-].
double uniformity(const Grading& grading);

/// H(d) = F(4d) - F(d): mass fraction between a size and four times that size [-].
double kenney_lau_increment(const Grading& grading, double diameter);

/// The size [m] that splits fines from skeleton by Kenney and Lau: the coarse end of the range in which H < F, provided
/// that this range begins at F <= 0.20 (D60/D10 > 3) or F <= 0.30; where H stays below F, its fine end. Nothing for a
/// soil that the criterion calls stable.
std::optional<double> kenney_lau_split(const Grading& grading);

/// The curve of the grains between two sizes [m] alone, from 0 to 100 %. @throws Bug where it has no mass there.
Grading part_between(const Grading& grading, double finest, double coarsest);

/// The curve of `coarse` and `fines` mixed so that the fines are `fines_content` of the mass.
Grading mixture(const Grading& coarse, const Grading& fines, double fines_content);

} // namespace suffuse::grains
