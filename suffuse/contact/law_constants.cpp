#include "suffuse/contact/law_constants.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/contact/springs.hpp"

#include <fmt/format.h>

#include <cmath>

namespace suffuse::contact {

LawConstants resolve_law(const grains::Material& material) {
    constexpr double no_limit = 1e300; // [N m]: beyond any moment, and finite, so that zero times it is zero
    const Spring& spring = spring_of(material);
    if (!spring.may_adhere && adheres(material)) {
        throw CaseError(fmt::format(
            "grains under the law \"{}\" do not adhere; leave adhesion out, or take the law \"{}\"", spring.words.name,
            laws_that_adhere()
        ));
    }
    LawConstants law;
    law.spring = material.law;
    law.spring_constants = spring.constants(material);
    law.most_stress = spring.most_stress(material);
    const double tangent_ratio = spring.exponent(material); // d(normal force)/d(overlap) over force/overlap
    law.shear_ratio = tangent_ratio * spring.shear_ratio(material);
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
