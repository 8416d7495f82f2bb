#include "suffuse/contact/springs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace suffuse::contact {
namespace {

constexpr double contacts_per_grain = 4; // of the grains that carry load
constexpr double usual_porosity = 0.4;

} // namespace

std::string laws_that_adhere() {
    const auto names = laws_where([](const Spring& spring) { return spring.may_adhere; });
    return fmt::format("{}", fmt::join(names, "\" or \""));
}

double mean_overlap_at(const grains::Material& material, double pressure) {
    // Mean force of equal spheres: p pi d^2/(Z (1 - n)).
    const double stress = 4 * pi / (contacts_per_grain * (1 - usual_porosity)) * pressure;
    return spring_of(material).overlap_under(material, stress);
}

grains::Material linearized(const grains::Material& material, double relative_overlap) {
    const Spring& spring = spring_of(material);
    grains::Material linear = material;
    linear.law = LinearSpring::law;
    linear.modulus = spring.tangent(material, 1, 1, relative_overlap); // E r of equal grains
    linear.shear_ratio = spring.shear_ratio(material);
    return linear;
}

} // namespace suffuse::contact
