#pragma once
// The constants of the contact laws [Aboul Hosn 2017 for the linear one; values are ours unless the case says
// otherwise], and how stiff a law is that grows stiffer as it is pressed.

#include "suffuse/base/constants.hpp"

namespace suffuse::grains {

enum class ContactLaw {
    LinearRolling, ///< linear springs
    HertzMindlin,  ///< elastic spheres: springs that grow with the contact area
};

struct Material {
    double density = 2600;          ///< [kg/m3]
    double modulus = 356e6;         ///< linear: E of kn = 2 E r1 r2/(r1 + r2); Hertz: Young's of the grains [Pa]
    double shear_ratio = 0.42;      ///< ks/kn of the linear law [-]
    double friction = radians(37);  ///< contact friction angle [rad]
    double rolling_stiffness = 7.5; ///< kr = this x ks r1 r2 [-]
    double rolling_friction = 0.22; ///< limit of the rolling moment: this x min(r1, r2) |Fn|; negative = no limit [-]
    double twisting_stiffness = 0;  ///< ktw = this x ks r1 r2 [-]
    double twisting_friction = 0;   ///< limit of the twisting moment, as for rolling; negative = no limit [-]
    double adhesion_normal = 0;     ///< pull-off force = this x min(r1, r2)^2, on contacts made from now on [Pa]
    double adhesion_shear = 0;      ///< shear strength without normal force, likewise [Pa]
    ContactLaw law = ContactLaw::LinearRolling;
    double poisson = 0.3;       ///< Poisson's ratio of the grains, of Hertz's law [-]
    double viscous_damping = 0; ///< of the normal motion, as a share of what is critical at the stiffness now [-]
};

/// Whether contacts that are made now stick.
inline bool adheres(const Material& material) {
    return material.adhesion_normal > 0 || material.adhesion_shear > 0;
}

/// ks/kn: shear stiffness over d(normal force)/d(overlap) [-]. Hertz's law: 2 (1 - nu)/(2 - nu), without slip [Mindlin
/// 1949].
double shear_ratio(const Material& material);

/// H of the normal force H sqrt(R overlap) overlap, R = r1 r2/(r1 + r2): (2/3) E/(1 - nu^2) [Pa] [Hertz 1882]
double hertz_modulus(const Material& material);

/// Overlap over radius of two equal grains that a force presses together [-]. @param stress force/radius^2 [Pa]
double overlap_under(const Material& material, double stress);

/// Mean overlap over radius of equal spheres under an isotropic pressure [Pa].
double mean_overlap_at(const Material& material, double pressure);

/// The linear law that is as stiff as `material` at an overlap of this share of the smaller radius: pairs of unequal
/// grains are less stiff, by the root of two at most. The linear law itself is.
Material linearized(const Material& material, double relative_overlap);

} // namespace suffuse::grains
