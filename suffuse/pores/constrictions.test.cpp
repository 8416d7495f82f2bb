#include "suffuse/pores/constrictions.hpp"

#include "suffuse/base/quantile.hpp"
#include "suffuse/pores/throat.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/packings.hpp"
#include "tests/support/reference.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace suffuse::pores {
namespace {

/// The grains of at least this diameter, alone in the cell.
test::Packing coarse_part(const test::Packing& packing, double diameter) {
    test::Packing coarse;
    coarse.h = packing.h;
    for (std::size_t g = 0; g < packing.size(); ++g) {
        if (2 * packing.radius[g] < diameter) {
            continue;
        }
        coarse.position.push_back(packing.position[g]);
        coarse.radius.push_back(packing.radius[g]);
    }
    return coarse;
}

/// The grains of a throat: centers of the second and third from the first, radii [m].
struct Facet {
    Vec3 origin, b, c;
    std::array<double, 3> r;
};

Facet facet_of(const PoreNetwork& network, const test::Packing& packing, std::size_t t) {
    const auto [x, r] = spheres_of(network, packing.position, packing.radius, t);
    return {x[0], x[1] - x[0], x[2] - x[0], r};
}

/// How far the sphere at `center` may grow until it touches the nearest of all grains [m].
double clearance(const test::Packing& packing, const Vec3& center) {
    const Mat3 inverse_h = inverse(packing.h);
    double least = 1e300;
    for (std::size_t g = 0; g < packing.size(); ++g) {
        const Vec3 apart = inverse_h * (packing.position[g] - center);
        const Vec3 nearest{std::round(apart.x), std::round(apart.y), std::round(apart.z)};
        least = std::min(least, norm(packing.h * (apart - nearest)) - packing.radius[g]);
    }
    return least;
}

const auto skeletons = {std::pair{"constrictions10k_0.20", 0.20e-3}, {"constrictions10k_0.26", 0.26e-3}};

TEST(Constrictions, CirclesOfTheCoarseSkeletonAreThoseOfTheReference) {
    // The reference counts circles that reach into a fourth grain, and such as lie next to their triangle.
    const test::Packing packing = test::reference_spheres("packing10k");
    for (const auto& [name, limit] : skeletons) {
        const auto about = test::read_reference_json(std::string(name) + ".json");
        const test::Packing coarse = coarse_part(packing, limit);
        ASSERT_EQ(coarse.size(), about["nbig"].get<std::size_t>());
        const PoreNetwork network = build_network(coarse.h, coarse.position, coarse.radius);
        std::vector<double> found;
        std::size_t kept = 0;
        for (std::size_t t = 0; t < network.throats.size(); ++t) {
            const Facet facet = facet_of(network, coarse, t);
            const InscribedCircle circle = inscribed_circle(facet.b, facet.c, facet.r);
            found.push_back(2 * circle.radius);
            const double own = network.throats.inscribed_radius[t];
            EXPECT_LE(own, circle.radius * (1 + 1e-12));
            if (circle.is_inside && clearance(coarse, facet.origin + circle.center) > circle.radius * (1 - 1e-9)) {
                EXPECT_EQ(own, circle.radius) << "free of all grains: the constriction is the reference's";
                ++kept;
            }
        }
        EXPECT_GT(kept, network.throats.size() / 3);
        std::sort(found.begin(), found.end());
        ASSERT_EQ(found.size(), about["n"].get<std::size_t>());
        const double mean = std::accumulate(found.begin(), found.end(), 0.0) / static_cast<double>(found.size());
        EXPECT_NEAR(mean / about["mean_all"].get<double>(), 1, 1e-9);
        EXPECT_NEAR(quantile_of_sorted(found, 0.5) / about["median"].get<double>(), 1, 1e-9);
        std::istringstream rows(test::read_reference(std::string(name) + "_d.csv.gz"));
        std::string line;
        std::getline(rows, line);
        std::vector<double> expected;
        while (std::getline(rows, line)) {
            expected.push_back(std::stod(line));
        }
        std::sort(expected.begin(), expected.end());
        ASSERT_EQ(expected.size(), found.size());
        for (std::size_t k = 0; k < found.size(); ++k) {
            EXPECT_NEAR(found[k] / expected[k], 1, 1e-9); // eleven digits in the file
        }
    }
}

TEST(Constrictions, AreFreeRoomOfNoMoreThanTheVoid) {
    struct Skeleton {
        test::Packing packing;
        double still_cut; ///< share of facets into whose sphere a grain beyond the nearest eight reaches
    };

    std::vector<Skeleton> all;
    const test::Packing sand = test::reference_spheres("packing10k");
    all.push_back({test::reference_spheres("packing500"), 0.003});
    all.push_back({coarse_part(sand, 0.20e-3), 0.003});
    all.push_back({coarse_part(sand, 0.26e-3), 0.003});
    all.push_back({test::random_packing(identity(), 400, 0.01, 0.1, 5), 0.02});
    for (const Skeleton& skeleton : all) {
        const test::Packing& packing = skeleton.packing;
        const PoreNetwork network = build_network(packing.h, packing.position, packing.radius);
        const std::vector<VoidSphere> space = void_spheres(network, packing.position, packing.radius);
        std::size_t cut = 0, looked_at = 0;
        for (std::size_t t = 0; t < network.throats.size(); t += 7, ++looked_at) {
            const double own = network.throats.inscribed_radius[t];
            const Facet facet = facet_of(network, packing, t);
            EXPECT_LE(own, 0.5 * std::max({norm(facet.b), norm(facet.c), norm(facet.c - facet.b)}));
            cut += clearance(packing, network.throats.center[t]) < own * (1 - 1e-9) ? 1 : 0;
            for (const std::uint32_t p : network.throats.side[t]) {
                EXPECT_TRUE(!(space[p].radius > 0) || own <= space[p].radius * (1 + 1e-9)) << t;
            }
        }
        EXPECT_LE(static_cast<double>(cut), skeleton.still_cut * static_cast<double>(looked_at)) << packing.size();
    }
}

TEST(Constrictions, OfFinesInAWideVoidAreNoWiderThanTheCell) {
    // Grains of 50 to 1, a cloud: circles of up to hundreds of cells touch three of them.
    const test::Packing packing = test::random_packing(identity(), 120, 0.004, 0.2, 3);
    const PoreNetwork network = build_network(packing.h, packing.position, packing.radius);
    double widest_circle = 0, widest = 0;
    for (std::size_t t = 0; t < network.throats.size(); ++t) {
        const Facet facet = facet_of(network, packing, t);
        widest_circle = std::max(widest_circle, 2 * inscribed_circle(facet.b, facet.c, facet.r).radius);
        widest = std::max(widest, 2 * network.throats.inscribed_radius[t]);
    }
    EXPECT_GT(widest_circle, 1);
    EXPECT_LT(widest, 0.8);
}

TEST(Constrictions, CountEachFacetOnceAndHaveTheMeanAndTheQuantilesOfTheirList) {
    const test::Packing packing = test::reference_spheres("packing10k");
    for (const auto& [name, limit] : skeletons) {
        const test::Packing coarse = coarse_part(packing, limit);
        const auto about = test::read_reference_json(std::string(name) + ".json");
        const Constrictions found = find_constrictions(coarse.h, coarse.position, coarse.radius);
        ASSERT_EQ(found.diameter.size(), about["n"].get<std::size_t>()); // as many facets as the reference's
        std::vector<double> sorted = found.diameter;
        std::sort(sorted.begin(), sorted.end());
        const double sum = std::accumulate(sorted.begin(), sorted.end(), 0.0);
        EXPECT_NEAR(found.mean / (sum / static_cast<double>(sorted.size())), 1, 1e-9);
        EXPECT_NEAR(found.median / quantile_of_sorted(sorted, 0.5), 1, 1e-9);
        EXPECT_NEAR(found.d35 / quantile_of_sorted(sorted, 0.35), 1, 1e-9);
    }
}

TEST(Constrictions, OfAFaceCenteredPackingAreAllOfThreeTouchingGrains) {
    const test::Packing packing = test::face_centered(3, 1);
    const Constrictions found = find_constrictions(packing.h, packing.position, packing.radius);
    EXPECT_EQ(found.diameter.size(), 8U * packing.size()); // eight tetrahedra of four facets share each grain's corners
    for (const double d : found.diameter) {
        EXPECT_NEAR(d, 2 * (2 / std::sqrt(3.0) - 1), 1e-12);
    }
}

} // namespace
} // namespace suffuse::pores
