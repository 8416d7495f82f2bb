#include "suffuse/contact/stress.hpp"

#include "suffuse/base/parallel.hpp"

namespace suffuse::contact {

Vec3 affine_moduli(
    const grains::Grains& grains, const Contacts& contacts, const grains::Material& material, const Mat3& h
) {
    const Vec3 sum = parallel_sum(contacts.size(), 1024, Vec3{}, [&](std::size_t begin, std::size_t end) {
        Vec3 part;
        for (std::size_t c = begin; c < end; ++c) {
            if (!contacts.touches(c)) {
                continue;
            }
            const double r1 = grains.radius[contacts.first[c]], r2 = grains.radius[contacts.second[c]];
            const double kn = normal_stiffness(material, r1, r2), length = r1 + r2 - contacts.overlap[c];
            const Vec3 n = contacts.normal[c];
            for (int a = 0; a < 3; ++a) {
                const double square = n[a] * n[a];
                part[a] += kn * length * length * square * (square + material.shear_ratio * (1 - square));
            }
        }
        return part;
    });
    return (1 / determinant(h)) * sum;
}

} // namespace suffuse::contact
