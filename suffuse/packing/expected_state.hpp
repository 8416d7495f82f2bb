#pragma once
// What a mixture of spheres will be like before it is prepared: its solid fraction by de Larrard's linear packing
// density model [deLarrard1999, chapter 1], a size class of which fills what the others leave, and how many grains of a
// class will carry load. The state of equal grains, per preparation, is our own samples'.

#include <span>
#include <vector>

namespace suffuse::packing {

/// Equal grains after a preparation.
struct EqualGrains {
    double solid_fraction = 0; ///< [-]
    double coordination = 0;   ///< mechanical: contacts a grain that carries load [-]
    double rattlers = 0;       ///< share of the grains with fewer than two contacts [-]
    double filling = 0;        ///< of the room left by coarser grains, at which half of a finer class carries load [-]
    double filling_sharpness = 0; ///< of that transition: slope of the logit over the logarithm of the filling [-]
};

/// Prepared at a friction angle [rad], or sticking where they met.
EqualGrains equal_grains(double friction, bool adheres);

/// The same, found by the solid fraction that equal grains would have.
EqualGrains equal_grains_at(double solid_fraction);

struct SizeClass {
    double diameter = 0; ///< [m]
    double volume = 0;   ///< share of the solid [-]
};

/// Solid fraction that each class would reach were it the one to jam, the mixture given [-]: de Larrard's gamma_i. The
/// smallest of them is the mixture's. @param alone that of each class without the others [-]
std::vector<double> jamming_fractions(std::span<const SizeClass> classes, double alone);

/// Share of the grains of a fine class that carry load. @param filling the jamming fraction of the coarser grains over
/// that of the fine ones: above 1 the fine ones jam first [-]
double carrying_share(const EqualGrains& state, double filling);

} // namespace suffuse::packing
