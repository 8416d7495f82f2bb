#include "suffuse/contact/linear_rolling.hpp"

namespace suffuse::contact {

LawConstants resolve_law(const grains::Material& material) {
    constexpr double no_limit = 1e300; // [N m]: beyond any moment, and finite, so that zero times it is zero
    LawConstants law;
    law.twice_modulus = 2 * material.modulus;
    law.shear_ratio = material.shear_ratio;
    law.tan_friction = std::tan(material.friction);
    law.rolling_stiffness = material.rolling_stiffness;
    law.rolling_limit = material.rolling_friction < 0 ? 0 : material.rolling_friction;
    law.rolling_free = material.rolling_friction < 0 ? no_limit : 0;
    law.twisting_stiffness = material.twisting_stiffness;
    law.twisting_limit = material.twisting_friction < 0 ? 0 : material.twisting_friction;
    law.twisting_free = material.twisting_friction < 0 ? no_limit : 0;
    law.adhesion_normal = material.adhesion_normal;
    law.adhesion_shear = material.adhesion_shear;
    return law;
}

} // namespace suffuse::contact
