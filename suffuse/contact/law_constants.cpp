#include "suffuse/contact/law_constants.hpp"

#include "suffuse/base/error.hpp"

#include <cmath>

namespace suffuse::contact {

LawConstants resolve_law(const grains::Material& material) {
    constexpr double no_limit = 1e300; // [N m]: beyond any moment, and finite, so that zero times it is zero
    const bool is_hertzian = material.law == grains::ContactLaw::HertzMindlin;
    if (is_hertzian && adheres(material)) {
        throw CaseError("grains under the law \"hertz-mindlin\" do not adhere; leave adhesion out, or take the law "
                        "\"linear-rolling\"");
    }
    LawConstants law;
    law.twice_modulus = is_hertzian ? 0 : 2 * material.modulus;
    law.hertz_modulus = is_hertzian ? hertz_modulus(material) : 0;
    const double tangent_ratio = is_hertzian ? 1.5 : 1; // d(normal force)/d(overlap) over force/overlap
    law.shear_ratio = tangent_ratio * shear_ratio(material);
    law.viscosity = 2 * material.viscous_damping * std::sqrt(tangent_ratio * material.density * sphere_volume(1));
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
