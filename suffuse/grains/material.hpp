#pragma once
// The constants of the contact law [Aboul Hosn 2017; values are ours unless the case says otherwise].

#include "suffuse/base/constants.hpp"

namespace suffuse::grains {

struct Material {
    double density = 2600;          ///< [kg/m3]
    double modulus = 356e6;         ///< E of kn = 2 E r1 r2/(r1 + r2) [Pa]
    double shear_ratio = 0.42;      ///< ks/kn [-]
    double friction = radians(37);  ///< contact friction angle [rad]
    double rolling_stiffness = 7.5; ///< kr = this x ks r1 r2 [-]
    double rolling_friction = 0.22; ///< limit of the rolling moment: this x min(r1, r2) |Fn|; negative = no limit [-]
    double twisting_stiffness = 0;  ///< ktw = this x ks r1 r2 [-]
    double twisting_friction = 0;   ///< limit of the twisting moment, as for rolling; negative = no limit [-]
    double adhesion_normal = 0;     ///< pull-off force = this x min(r1, r2)^2, on contacts made from now on [Pa]
    double adhesion_shear = 0;      ///< shear strength without normal force, likewise [Pa]
};

/// Whether contacts that are made now stick.
inline bool adheres(const Material& material) {
    return material.adhesion_normal > 0 || material.adhesion_shear > 0;
}

} // namespace suffuse::grains
