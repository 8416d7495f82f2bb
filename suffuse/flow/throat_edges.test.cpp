#include "suffuse/flow/throat_edges.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/pores/network.hpp"

#include <gtest/gtest.h>

#include "tests/support/packings.hpp"

namespace suffuse::flow {
namespace {

TEST(WedgeCaps, EndWhereTheSurfacesAreTheGapApart) {
    struct Case {
        double ra, rb, distance, gap;
    };

    for (const Case& c : {Case{1, 1, 2, 0.1}, {1, 1, 2.05, 0.1}, {1, 0.3, 1.3, 0.05}, {0.2, 3, 3.25, 0.1}}) {
        const auto [a, b] = wedge_caps(c.ra, c.rb, c.distance, c.gap);
        const double of_a = c.ra - a / c.ra, of_b = c.rb - b / c.rb; // from center to rim, along the line [Archimedes]
        EXPECT_NEAR(c.distance - of_a - of_b, c.gap, 1e-14);
        EXPECT_NEAR(c.ra * c.ra - of_a * of_a, c.rb * c.rb - of_b * of_b, 1e-14); // one rim
        const auto turned = wedge_caps(c.rb, c.ra, c.distance, c.gap);
        EXPECT_NEAR(turned[0], b, 1e-14);
        EXPECT_NEAR(turned[1], a, 1e-14);
    }
}

TEST(WedgeCaps, AreNothingBetweenDistantSpheresAndHalfTheSmallerInWideLayers) {
    EXPECT_EQ(wedge_caps(1, 0.5, 1.7, 0.2)[0], 0);
    EXPECT_EQ(wedge_caps(1, 0.5, 1.5, 0)[1], 0);
    for (const double gap : {2.0, 10.0}) {
        EXPECT_NEAR(wedge_caps(1, 0.5, 1.5, gap)[1], 0.25, 1e-15);
        EXPECT_NEAR(wedge_caps(1, 0.5, 1.5, gap)[0], 1 - std::sqrt(0.75), 1e-15);
        EXPECT_EQ(wedge_caps(1, 1, 2, gap), (std::array<double, 2>{1, 1}));
    }
}

TEST(WedgeCaps, OfOverlappingSpheresWithoutAGapAreThoseOfTheirLens) {
    EXPECT_EQ(wedge_caps(1, 0.6, 1.4, 0), lens_of(1, 0.6, 1.4).cap);
}

/// Whether p lies in the tetrahedron of four points.
bool is_inside(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const auto side = [](const Vec3& x, const Vec3& y, const Vec3& z, const Vec3& w) {
        return dot(w - x, cross(y - x, z - x));
    };
    const double whole = side(a, b, c, d);
    return side(a, b, c, p) * whole >= 0 && side(a, d, b, p) * whole >= 0 && side(b, d, c, p) * whole >= 0 &&
           side(c, d, a, p) * whole >= 0;
}

/// Whether a neighbor is nearer than the gap, along their edge, to the point of sphere k in the direction n.
bool rests_next_to(
    const std::array<Vec3, 3>& x, const std::array<double, 3>& r, std::size_t k, const Vec3& n, double gap
) {
    bool rests = false;
    for (std::size_t l = 0; l < 3; ++l) {
        const Vec3 edge = x[l] - x[k];
        const double d = norm(edge), along = l == k ? -1 : dot(n, edge) / d;
        const double off2 = r[k] * r[k] * (1 - along * along);
        rests = rests || (along > 0 && off2 < r[l] * r[l] && d - r[k] * along - std::sqrt(r[l] * r[l] - off2) < gap);
    }
    return rests;
}

TEST(SurfaceBeyondWedges, IsThatOfAQuadratureOverTheSpheres) {
    // Two grains touch, one stands apart. Surfaces are sampled over the whole spheres; those that count lie in the
    // throat's two tetrahedra, and beyond the rim where along an edge the neighbor is nearer than the gap.
    const std::array<Vec3, 3> x = {Vec3{0, 0, 0}, {1.5, 0, 0}, {0.5, 1.6, 0}};
    const std::array<double, 3> r = {1, 0.5, 0.6};
    const Vec3 p1{0.7, 0.6, -1.1}, p2{0.8, 0.5, 1.3};
    constexpr double gap = 0.06;
    constexpr int steps = 1200; // of the cosine and of the angle: areas to some 1e-3 of a thousandth of the sphere
    std::array<double, 3> wetted{}, open{};
    for (std::size_t k = 0; k < 3; ++k) {
        const double each = 4 * pi * r[k] * r[k] / (steps * steps);
        for (int i = 0; i < steps; ++i) {
            const double z = -1 + (i + 0.5) * 2 / steps, s = std::sqrt(1 - z * z);
            for (int j = 0; j < steps; ++j) {
                const double angle = (j + 0.5) * 2 * pi / steps;
                const Vec3 n{s * std::cos(angle), s * std::sin(angle), z};
                const Vec3 near = x[k] + 1e-3 * n; // the solid angle of the tetrahedra, however large the sphere
                if (!is_inside(near, x[0], x[1], x[2], p1) && !is_inside(near, x[0], x[1], x[2], p2)) {
                    continue;
                }
                wetted[k] += each;
                open[k] += rests_next_to(x, r, k, n, gap) ? 0 : each;
            }
        }
    }
    const std::array<double, 3> found = surface_beyond_wedges(ThroatEdges(x, p1, p2), {r, wetted}, gap);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(found[k], open[k], 2e-4 * 4 * pi * r[k] * r[k]) << k;
    }
    EXPECT_LT(open[0], wetted[0] - 0.03); // more than tenfold what the quadrature may be off by
    EXPECT_EQ(open[2], wetted[2]);
}

TEST(ThroatEdges, HaveTheAngleBetweenThePoreCentersAroundThem) {
    const std::array<Vec3, 3> x = {Vec3{0, 0, 0}, {2, 0, 0}, {0, 3, 0}};
    const ThroatEdges edges(x, {0.5, 1, -1}, {0.5, 1, std::sqrt(3.0)});
    EXPECT_NEAR(edges.angle[0], pi / 4 + pi / 3, 1e-15); // both above the edge along x
    EXPECT_NEAR(edges.length[0], 2, 0);
    EXPECT_NEAR(edges.length[1], std::sqrt(13.0), 1e-15);
    EXPECT_NEAR(edges.angle[2], std::atan(2.0) + std::atan(2 * std::sqrt(3.0)), 1e-15);
}

TEST(Lens, HasTheVolumeSurfaceAndSectionOfAQuadrature) {
    struct Case {
        double ra, rb, distance;
    };

    for (const Case& c : {Case{1, 1, 1.9}, {1, 0.4, 1.35}, {0.3, 1, 0.9}, {1, 0.2, 0.85}}) {
        const Lens lens = lens_of(c.ra, c.rb, c.distance);
        constexpr int steps = 100'000; // across the lens, along the line of centers
        const double from = c.distance - c.rb, width = c.ra - from;
        double volume = 0, section = 0, cap_of_first = 0;
        for (int i = 0; i < steps; ++i) {
            const double x = from + (i + 0.5) * width / steps, each = width / steps;
            const double one = c.ra * c.ra - x * x, two = c.rb * c.rb - (x - c.distance) * (x - c.distance);
            const double rim2 = std::max(0.0, std::min(one, two));
            volume += 0.5 * rim2 * each; // over a radian
            section += std::sqrt(rim2) * each;
            cap_of_first += one < two ? c.ra * each : 0; // Archimedes
        }
        EXPECT_NEAR(lens.volume, volume, 1e-5 * volume);
        EXPECT_NEAR(lens.half_section, section, 0.01 * section);
        EXPECT_NEAR(lens.cap[0], cap_of_first, 2 * c.ra * width / steps);
        const Lens other = lens_of(c.rb, c.ra, c.distance);
        EXPECT_NEAR(other.cap[1], lens.cap[0], 1e-14);
    }
}

TEST(Lens, OfASphereWithinTheOtherIsAllOfIt) {
    const Lens lens = lens_of(1, 0.3, 0.5);
    EXPECT_NEAR(2 * pi * lens.volume, 4 * pi / 3 * 0.027, 1e-14);
    EXPECT_NEAR(2 * pi * lens.cap[1], 4 * pi * 0.09, 1e-14);
    EXPECT_NEAR(lens.cap[0], 0, 1e-14);
}

TEST(Overlaps, CountedOnceLeaveTheWaterAndSurfaceOfTheUnion) {
    // Lattices whose neighbors, but no three of them, overlap: all that is void is some throat's water.
    for (const test::Packing& packing :
         {test::lattice(2, 1.96, 1, {{0.1, 0.2, 0.3}}),
          test::lattice(2, 2, 1, {{0.1, 0.2, 0.3}, {0.6, 0.7, 0.8}}), // body-centered: 8 neighbors at 1.732
          test::lattice(1, 2, 0.98, {{0.1, 0.2, 0.3}, {0.6, 0.7, 0.8}})}) {
        const pores::PoreNetwork network = pores::build_network(packing.h, packing.position, packing.radius);
        double water = 0, surface = 0, common = 0, hidden = 0;
        for (std::size_t t = 0; t < network.throats.size(); ++t) {
            const auto [x, r] = pores::spheres_of(network, packing.position, packing.radius, t);
            const auto [p1, p2] = pores::centers_around(network, t);
            const auto& wetted = network.throats.wetted[t];
            const double volume = network.throats.hydraulic_radius[t] * (wetted[0] + wetted[1] + wetted[2]);
            const ThroatWater once = count_overlaps_once(ThroatEdges(x, p1, p2), {volume, {r, wetted}});
            water += once.volume;
            surface += once.grains.area[0] + once.grains.area[1] + once.grains.area[2];
        }
        const double r = packing.radius[0];
        for (std::size_t g = 0; g < packing.size(); ++g) {
            for (std::size_t o = 0; o < packing.size(); ++o) {
                for (int image = 0; image < 27; ++image) {
                    const Vec3 to =
                        packing.position[o] +
                        cell::shift(packing.h, cell::Image(image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1));
                    const double d = norm(to - packing.position[g]);
                    if (d > 0 && d < 2 * r * (1 - 1e-12)) {
                        const Lens lens = lens_of(r, r, d);
                        common += pi * lens.volume; // half of it: each pair comes twice
                        hidden += 2 * pi * lens.cap[0];
                    }
                }
            }
        }
        const double grains = static_cast<double>(packing.size());
        EXPECT_NEAR(
            water, determinant(packing.h) - grains * 4 * pi / 3 * r * r * r + common, 1e-12 * determinant(packing.h)
        );
        EXPECT_NEAR(surface, grains * 4 * pi * r * r - hidden, 1e-12 * surface);
    }
}

} // namespace
} // namespace suffuse::flow
