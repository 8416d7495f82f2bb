#pragma once
// Laboratory tests and small-strain stiffness.

#include "suffuse/facts/fact.hpp"
#include "suffuse/triaxial/laboratory_numbers.hpp"
#include "suffuse/triaxial/response.hpp"
#include "suffuse/triaxial/stiffness.hpp"

namespace suffuse::facts {

/// `response` of a triaxial test.
inline constexpr std::tuple response{
    row<&triaxial::Response::peak_deviator>(
        "peak_deviator", "Pa", "highest q; at a constant deviator q at the highest pore pressure until q is lost"
    )
        .as(Shown{"highest deviator stress", "q", "kPa"}),
    row<&triaxial::Response::peak_strain>("peak_strain", "-", "axial strain there")
        .as(Shown{"axial strain at the highest deviator stress", "ε₁", "%", 3}),
    row<&triaxial::Response::peak_ratio>("peak_ratio", "-", "q/p there"),
    row<&triaxial::Response::friction_angle>("friction_angle", "rad", "there, sin φ = (σ₁ − σ₃)/(σ₁ + σ₃)")
        .as(Shown{"friction angle", "φ", "°", 3}),
    row<&triaxial::Response::final_deviator>("final_deviator", "Pa", "q at the end")
        .as(Shown{"deviator stress at the end", "q", "kPa"}),
    row<&triaxial::Response::stiffness>("stiffness", "Pa", "secant E50; null where q is held or never grows")
        .as(Shown{"secant stiffness", "E50", "MPa", 3}),
    row<&triaxial::Response::dilatancy>(
        "dilatancy", "-", "largest −dεᵥ/dε₁ over one percent of strain; null of less strain"
    )
        .as(Shown{"dilatancy", "", "-", 3}),
    row<&triaxial::Response::largest_contraction>("largest_contraction", "-", "largest volumetric strain"),
    row<&triaxial::Response::final_volumetric_strain>("final_volumetric_strain", "-", "at the end")
        .as(Shown{"volumetric strain at the end", "εᵥ", "%", 3}),
    row<&triaxial::Response::lost_at>(
        "lost_at", "-",
        "drained and constant mean: axial strain at which more than a fifth of the stress held was lost, a flaw; or "
        "null"
    ),
    row<&triaxial::Response::instability>(
        "instability", "",
        "`q`, `p` [Pa], `strain` (axial) where the second-order work is first no longer above 0 ([triaxial "
        "paths](theory/periodic-cell-and-servo.md)); or null"
    ),
    row<&triaxial::Response::liquefied>(
        "liquefied", "", "undrained and at a constant deviator, else null: whether p fell below 5 % of its start"
    ),
    row<&triaxial::Response::excess_pore_pressure>(
        "excess_pore_pressure", "Pa",
        "undrained: at the end; at a constant deviator the highest until q is lost; else null"
    )
        .as(Shown{"excess pore pressure", "Δu", "kPa", 3}),
    row<&triaxial::Response::energy>(
        "energy", "J/m3",
        "`work`, `springs`, `motion`, `slip`, `rolling`, `damping`: where the work of the test went, over the volume "
        "at its start"
    ),
};

/// Of `oedometer` and `isotropic`.
inline constexpr std::tuple compression{
    row<&triaxial::CompressionNumbers::k0>(
        "k0", "-", "lateral over axial stress at the highest axial stress; null where that is the first"
    )
        .as(Shown{"K0", "K₀", "-", 3}),
    row<&triaxial::CompressionNumbers::compression_index>(
        "compression_index", "-",
        "−de/dlog₁₀σ of first loading, over its last half decade; null where the stress never grows"
    )
        .as(Shown{"compression index", "Cc", "-", 3}),
    row<&triaxial::CompressionNumbers::swelling_index>(
        "swelling_index", "-",
        "−de/dlog₁₀σ while the stress falls: one slope of all such branches; null where it never does"
    )
        .as(Shown{"swelling index", "Cs", "-", 3}),
};

/// Of `shear`.
inline constexpr std::tuple shear{
    row<&triaxial::ShearNumbers::shear_stress>("shear_stress", "Pa", "at the highest ratio of shear to normal stress"),
    row<&triaxial::ShearNumbers::normal_stress>("normal_stress", "Pa", "there"),
    row<&triaxial::ShearNumbers::peak_stress_ratio>("peak_stress_ratio", "-", "shear over normal stress there")
        .as(Shown{"highest stress ratio", "τ/σₙ", "-", 3}),
    row<&triaxial::ShearNumbers::peak_shear_strain>("peak_shear_strain", "-", "there"),
    row<&triaxial::ShearNumbers::final_stress_ratio>("final_stress_ratio", "-", "shear over normal stress at the end"),
    row<&triaxial::ShearNumbers::rotation>(
        "rotation", "rad", "at the highest ratio, of the major principal stress from the normal towards the shear"
    ),
};

/// Of `cyclic`.
inline constexpr std::tuple cyclic{
    row<&triaxial::CyclicNumbers::cycles>("cycles", "-", "begun, in halves"),
    row<&triaxial::CyclicNumbers::cycles_to_liquefaction>(
        "cycles_to_liquefaction", "-", "until the first of the limits in `until` was reached; null if none was"
    )
        .as(Shown{"cycles to liquefaction", "N", "-", 3}),
    row<&triaxial::CyclicNumbers::pore_pressure_ratio>(
        "pore_pressure_ratio", "-", "highest excess pore pressure over the lateral stress at the start"
    )
        .as(Shown{"pore-pressure ratio", "rᵤ", "-", 3}),
    row<&triaxial::CyclicNumbers::double_amplitude>(
        "double_amplitude", "-", "largest axial strain from one turn of the load to the next"
    ),
};

/// Of `stiffness`.
inline constexpr std::tuple stiffness{
    row<&triaxial::Stiffness::tensor>(
        "stiffness", "Pa", "6 × 6, in Voigt's order xx, yy, zz, yz, zx, xy with engineering shear strains"
    ),
    row<&triaxial::Stiffness::young_modulus>("young_modulus", "Pa", "of the two below")
        .as(Shown{"Young's modulus", "E₀", "MPa", 3}),
    row<&triaxial::Stiffness::shear_modulus>("shear_modulus", "Pa", "mean over all directions (Voigt)")
        .as(Shown{"shear modulus", "G₀", "MPa", 3}),
    row<&triaxial::Stiffness::bulk_modulus>("bulk_modulus", "Pa", "mean over all directions (Voigt)")
        .as(Shown{"bulk modulus", "K", "MPa", 3}),
    row<&triaxial::Stiffness::poisson_ratio>("poisson_ratio", "-", "of both moduli")
        .as(Shown{"Poisson's ratio", "ν", "-", 3}),
    row<&triaxial::Stiffness::young_moduli>("young_moduli", "Pa", "along x, y, z, each stress alone; or null"),
    row<&triaxial::Stiffness::anisotropy>(
        "anisotropy", "-", "5 Gᵥ/Gᵣ + Kᵥ/Kᵣ − 6 (averages of Voigt and Reuss): 0 if isotropic; or null"
    )
        .as(Shown{"anisotropy", "Aᵤ", "-", 3}),
    row<&triaxial::Stiffness::mean_field_shear>(
        "mean_field_shear", "Pa", "upper bound of `shear_modulus`: all grains move with the mean strain"
    ),
    row<&triaxial::Stiffness::mean_field_bulk>("mean_field_bulk", "Pa", "upper bound of `bulk_modulus`, likewise"),
    row<&triaxial::Stiffness::nonlinearity>(
        "nonlinearity", "-",
        "largest difference from the tensor by half of the increment, over the largest entry; above 2 % a flaw"
    )
        .as(Kind::Computation),
    row<&triaxial::Stiffness::reciprocity>(
        "reciprocity", "-", "largest difference of the measured tensor from its transpose, over the largest entry"
    )
        .as(Kind::Computation),
};

} // namespace suffuse::facts
