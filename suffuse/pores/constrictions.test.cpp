#include "suffuse/pores/constrictions.hpp"

#include "suffuse/base/quantile.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/packings.hpp"
#include "tests/support/reference.hpp"
#include <algorithm>

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

TEST(Constrictions, OfTheCoarseSkeletonAreThoseOfTheReference) {
    const test::Packing packing = test::reference_spheres("packing10k");
    for (const auto& [name, limit] :
         {std::pair{"constrictions10k_0.20", 0.20e-3}, {"constrictions10k_0.26", 0.26e-3}}) {
        const auto about = test::read_reference_json(std::string(name) + ".json");
        const test::Packing coarse = coarse_part(packing, limit);
        ASSERT_EQ(coarse.size(), about["nbig"].get<std::size_t>());
        const Constrictions found = find_constrictions(coarse.h, coarse.position, coarse.radius);
        ASSERT_EQ(found.diameter.size(), about["n"].get<std::size_t>());
        EXPECT_NEAR(found.mean / about["mean_all"].get<double>(), 1, 1e-9);
        EXPECT_NEAR(found.median / about["median"].get<double>(), 1, 1e-9);
        std::istringstream rows(test::read_reference(std::string(name) + "_d.csv.gz"));
        std::string line;
        std::getline(rows, line);
        std::vector<double> expected, sorted = found.diameter;
        while (std::getline(rows, line)) {
            expected.push_back(std::stod(line));
        }
        std::sort(expected.begin(), expected.end());
        std::sort(sorted.begin(), sorted.end());
        ASSERT_EQ(expected.size(), sorted.size());
        for (std::size_t k = 0; k < sorted.size(); ++k) {
            EXPECT_NEAR(sorted[k] / expected[k], 1, 1e-9); // eleven digits in the file
        }
        EXPECT_NEAR(found.d35, quantile_of_sorted(expected, 0.35), 1e-9 * found.d35);
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
