#pragma once
// Triaxial tests and stress probes.

#include "suffuse/facts/fact.hpp"
#include "suffuse/triaxial/response.hpp"

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
    row<&triaxial::Response::stiffness>("stiffness", "Pa", "secant E50").as(Shown{"secant stiffness", "E50", "MPa", 3}),
    row<&triaxial::Response::dilatancy>("dilatancy", "-", "largest −dεᵥ/dε₁ over one percent of strain")
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

} // namespace suffuse::facts
