#include "suffuse/contact/stress.hpp"

#include "suffuse/contact/springs.hpp"
#include "suffuse/contact/sum_touching.hpp"

namespace suffuse::contact {

double normal_stiffness(const grains::Material& material, double r1, double r2, double overlap) {
    return visit_spring(material.law, [&](auto spring) { return spring.tangent(material, r1, r2, overlap); });
}

template <class Real>
AffineModuli affine_moduli(
    const grains::Grains& grains, const ContactPairs& contacts, const MemoryOf<Real>& memory,
    const grains::Material& material, const Mat3& h
) {
    const double shear_ratio = spring_of(material).shear_ratio(material);
    const auto add = [&](AffineModuli& part, std::size_t c) {
        const double r1 = grains.radius[contacts.first[c]], r2 = grains.radius[contacts.second[c]];
        const double kn = normal_stiffness(material, r1, r2, memory.overlap[c]), length = r1 + r2 - memory.overlap[c];
        const Vec3 n = memory.normal[c];
        for (int a = 0; a < 3; ++a) {
            const double square = n[a] * n[a];
            part.longitudinal[a] += kn * length * length * square * (square + shear_ratio * (1 - square));
            const double other = n[(a + 1) % 3] * n[(a + 1) % 3], third = n[(a + 2) % 3] * n[(a + 2) % 3];
            const double product = other * third;
            part.shear[a] += kn * length * length * (product + shear_ratio * ((other + third) / 4 - product));
        }
    };
    const AffineModuli sum = sum_touching(contacts, memory, grains.size(), AffineModuli{}, add);
    const double per_volume = 1 / determinant(h);
    return {per_volume * sum.longitudinal, per_volume * sum.shear};
}

template AffineModuli
affine_moduli(const grains::Grains&, const ContactPairs&, const SingleMemory&, const grains::Material&, const Mat3&);

AffineModuli
affine_moduli(const grains::Grains& grains, const Contacts& contacts, const grains::Material& material, const Mat3& h) {
    return affine_moduli(grains, contacts, contacts, material, h);
}

double
normal_force(const grains::Grains& grains, const Contacts& contacts, const grains::Material& material, std::size_t c) {
    const bool bonded = !contacts.bonded.empty() && contacts.bonded[c] != 0;
    const double overlap = contacts.overlap[c];
    const double r1 = grains.radius[contacts.first[c]], r2 = grains.radius[contacts.second[c]];
    if (overlap < 0 && !bonded) {
        return 0;
    }
    return visit_spring(material.law, [&](auto spring) { return spring.force(material, r1, r2, overlap); });
}

} // namespace suffuse::contact
