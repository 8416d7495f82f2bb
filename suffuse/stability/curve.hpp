#pragma once
// What the criteria read off a grading curve: its shape curve H over F [Kenney and Lau 1985], gaps, the curve's fine
// and coarse part, sizes by surface area. Curves are linear in log d between their points, so that all of it is exact.

#include "suffuse/grains/soil.hpp"

#include <optional>
#include <vector>

namespace suffuse::stability {

/// One point of the shape curve: F(d) and H(d) = F(4d) - F(d) [-] at a diameter [m].
struct ShapePoint {
    double diameter = 0, finer = 0, increment = 0;
};

/// The shape curve where it bends, sizes rising; between two points F and H are linear in log d. The ends of the part
/// with F from `from` to `to` are among them.
std::vector<ShapePoint> shape_curve(const grains::Grading& grading, double from = 0, double to = 1);

/// A range of sizes [m] that the soil almost lacks.
struct Gap {
    double fine_end = 0, coarse_end = 0;
    double finer = 0; ///< mass fraction below it [-]
};

/// The widest gap; a gap is a run of segments flatter than 10 % of the mass per tenfold size, at least 1.5 wide (about
/// one sieve is missing), with 5 % of the mass or more on either side, and steeper below: not the tail of a curve whose
/// fine end was not measured. The bounds are ours; the literature draws none.
std::optional<Gap> find_gap(const grains::Grading& grading);

/// The finest of the gaps: grains below it pass between those above it, so a filter must hold them.
std::optional<Gap> find_finest_gap(const grains::Grading& grading);

/// The largest size with no more than `fraction` passing: the coarse end of a gap, where size_at gives its fine end
/// [m].
double coarse_end_at(const grains::Grading& grading, double fraction);

/// The curve of the grains below, and above, `split` [m] alone. @throws Bug unless the split has mass on both sides.
grains::Grading fine_part(const grains::Grading& grading, double split);
grains::Grading coarse_part(const grains::Grading& grading, double split);

/// The diameter [m] below which a share of the surface area of spheres lies: surface goes with mass over diameter.
double size_by_surface(const grains::Grading& grading, double share);

} // namespace suffuse::stability
