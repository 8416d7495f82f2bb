#include "suffuse/pores/throat.hpp"

#include "suffuse/pores/tangent.hpp"
#include "suffuse/pores/throat_measure.hpp"

namespace suffuse::pores {
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
    return solid_angle_of(a, b, c);
}

InscribedCircle inscribed_circle(const Vec3& b, const Vec3& c, const std::array<double, 3>& r) {
    // |center - x_k| = radius + r_k; differences to the first are linear: center = u + radius v, in the basis (b, c).
    const double bb = norm2(b), bc = dot(b, c), cc = norm2(c), gram = bb * cc - bc * bc;

    struct InBasis {
        double along_b, along_c;
    };

    const auto in_basis = [&](double along_b, double along_c) {
        return InBasis{(along_b * cc - along_c * bc) / gram, (along_c * bb - along_b * bc) / gram};
    };
    const auto in_plane = [&](const InBasis& k) { return k.along_b * b + k.along_c * c; };
    const InBasis u = in_basis(0.5 * (bb + r[0] * r[0] - r[1] * r[1]), 0.5 * (cc + r[0] * r[0] - r[2] * r[2]));
    const InBasis v = in_basis(r[0] - r[1], r[0] - r[2]);
    const Vec3 from = in_plane(u), each = in_plane(v);
    const std::optional<double> radius = tangent_size(from, each, r[0]);
    if (!radius) {
        return {from, 0, false};
    }
    const InBasis at = {u.along_b + *radius * v.along_b, u.along_c + *radius * v.along_c};
    return {from + *radius * each, *radius, at.along_b >= 0 && at.along_c >= 0 && at.along_b + at.along_c <= 1};
}

ThroatGeometry
measure_throat(const std::array<Vec3, 3>& x, const std::array<double, 3>& r, const Vec3& p1, const Vec3& p2) {
    return geometry_of_throat(x, r, p1, p2);
}

} // namespace suffuse::pores
