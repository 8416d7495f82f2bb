#pragma once
// The constants of the contact laws [Aboul Hosn 2017 for the linear one; values are ours unless the case says
// otherwise]. What a law makes of them stands in contact/springs.hpp.

#include "suffuse/base/constants.hpp"

namespace suffuse::grains {

/// Its numbers are those of checkpoints.
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

/// What files call a member of Material.
struct Member {
    const char* name = "";
    const char* unit = "";
    bool is_newer = false; ///< checkpoints of before lack it: they were made with its default
};

/// Calls `visit` with each member's name and value, for all that reads and writes materials. It binds every member by
/// name: a new one stops the compiler until it is listed.
template <class Values, class Visit>
void list_members(Values& material, Visit&& visit) {
    auto& [density, modulus, shear_ratio, friction, rolling_stiffness, rolling_friction, twisting_stiffness, twisting_friction, adhesion_normal, adhesion_shear, law, poisson, viscous_damping] =
        material;
    constexpr bool is_newer = true;
    visit(Member{"density", "kg/m3"}, density);
    visit(Member{"modulus", "Pa"}, modulus);
    visit(Member{"shear_ratio", ""}, shear_ratio);
    visit(Member{"friction", "rad"}, friction);
    visit(Member{"rolling_stiffness", ""}, rolling_stiffness);
    visit(Member{"rolling_friction", ""}, rolling_friction);
    visit(Member{"twisting_stiffness", ""}, twisting_stiffness);
    visit(Member{"twisting_friction", ""}, twisting_friction);
    visit(Member{"adhesion_normal", "Pa"}, adhesion_normal);
    visit(Member{"adhesion_shear", "Pa"}, adhesion_shear);
    visit(Member{"law", "", is_newer}, law);
    visit(Member{"poisson", "", is_newer}, poisson);
    visit(Member{"viscous_damping", "", is_newer}, viscous_damping);
}

} // namespace suffuse::grains
