#pragma once
// What the program needs from a normal spring: one row of the table in springs.hpp. A spring is a power of the overlap,
// so that its tangent d(force)/d(overlap) is the same multiple of force/overlap everywhere; the hot loop counts on it.

#include "suffuse/grains/material.hpp"

#include <array>
#include <span>
#include <string_view>

namespace suffuse::contact {

inline constexpr std::size_t most_spring_constants = 4;

/// What a spring takes from the material, in an order of its own; the rest is zero.
template <class Real>
using SpringConstantsOf = std::array<Real, most_spring_constants>;

using SpringConstants = SpringConstantsOf<double>;

/// A key of [contact] that a case must give, since its default is that of another law.
struct NeededKey {
    std::string_view name;
    std::string_view what;   ///< "the `modulus` of the grains"
    std::string_view advice; ///< what it is, with an example
};

/// What a law is called in cases, and what the case reference says of it.
struct SpringWords {
    std::string_view name;      ///< of the law, in files: a promise
    std::string_view summary;   ///< what its springs are
    std::string_view modulus;   ///< what `modulus` is to it
    std::string_view shear_key; ///< the member of Material, and key of [contact], that shear stiffness follows from
    std::string_view shear;     ///< advice: how
    std::span<const std::string_view> more_keys{}; ///< what else is of this law only
    std::span<const NeededKey> needs{};
};

struct Spring {
    using OfMaterial = double (*)(const grains::Material&);
    using OfPair = double (*)(const grains::Material&, double r1, double r2, double overlap);

    grains::ContactLaw law{}; ///< its number is the one in checkpoints
    SpringWords words;
    bool stiffens = false;   ///< its stiffness grows with the overlap
    bool may_adhere = false; ///< it may also pull

    SpringConstants (*constants)(const grains::Material&) = nullptr;
    OfMaterial exponent = nullptr;    ///< force as overlap^this; tangent over force/overlap [-]
    OfMaterial shear_ratio = nullptr; ///< shear stiffness over tangent [-]
    /// No mean stress of grains reaches it, however much they overlap, nor their force over the square of the radius
    /// [Pa].
    OfMaterial most_stress = nullptr;

    OfPair force = nullptr;   ///< [N]
    OfPair tangent = nullptr; ///< d(force)/d(overlap) [N/m]
    OfPair energy = nullptr;  ///< held at that overlap [J]

    /// Overlap over radius of two equal grains that a force presses together [-]. @param stress force/radius^2 [Pa]
    double (*overlap_under)(const grains::Material&, double stress) = nullptr;

    /// Overlap over radius at which a fixed equal grain stops one of this squared speed [m2/s2]: density (4/3) pi r^3
    /// speed^2/2 is the energy of the spring [-].
    double (*overlap_of_impact)(const grains::Material&, double speed2) = nullptr;

    /// Stiffness over mean pressure, as papers give it for this law: about the radius over the overlap [-].
    double (*stiffness_to_pressure)(const grains::Material&, double pressure) = nullptr;
};

} // namespace suffuse::contact
