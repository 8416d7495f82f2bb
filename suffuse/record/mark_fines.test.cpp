#include "suffuse/record/mark_fines.hpp"

#include <gtest/gtest.h>

namespace suffuse::record {
namespace {

grains::Grading band(double least, double most) {
    return {{least, most}, {0, 1}, ""};
}

/// Two bands of diameters [m], half of the mass each.
casefile::Variant eroded_mixture(const grains::Grading& coarse, const grains::Grading& fines) {
    casefile::Variant variant;
    variant.soil.emplace();
    variant.soil->coarse = coarse;
    variant.soil->fines = fines;
    variant.soil->fines_content = 0.5;
    variant.stages.emplace_back().spec = erosion::ErodeSpec{};
    return variant;
}

grains::Grains grains_of(const std::vector<double>& diameters) {
    grains::Grains grains;
    for (const double d : diameters) {
        add_grain(grains, {}, 0.5 * d, 2600);
    }
    return grains;
}

std::string complaint(const casefile::Variant& variant, grains::Grains grains) {
    try {
        mark_fines(variant, "p.csv", grains);
    } catch (const CaseError& error) {
        return error.what();
    }
    return "";
}

TEST(MarkFines, TwoCurvesAreDistinguishedBySize) {
    grains::Grains grains = grains_of({1.4e-3, 1.1e-3, 1.2e-3, 1.0e-3});
    mark_fines(eroded_mixture(band(1.2e-3, 1.5e-3), band(1.0e-3, 1.2e-3)), "p.csv", grains); // they touch
    EXPECT_EQ(grains.fine, (std::vector<std::uint8_t>{0, 1, 0, 1}));
    grains = grains_of({1.19e-3, 1.01e-3}); // sizes that another program rounded: just outside of both curves
    mark_fines(eroded_mixture(band(1.2e-3, 1.5e-3), band(0.9e-3, 1.0e-3)), "p.csv", grains);
    EXPECT_EQ(grains.fine, (std::vector<std::uint8_t>{0, 1}));
}

TEST(MarkFines, CurvesThatOverlapAreRefusedUnlessTheFileNamesItsFines) {
    const casefile::Variant variant = eroded_mixture(band(1.1e-3, 1.5e-3), band(1.0e-3, 1.2e-3));
    grains::Grains grains = grains_of({1.15e-3, 1.16e-3});
    EXPECT_NE(complaint(variant, grains).find("fines go up to 1.2 mm"), std::string::npos)
        << complaint(variant, grains);
    grains.fine = {1, 0};
    mark_fines(variant, "p.vtp", grains);
    EXPECT_EQ(grains.fine, (std::vector<std::uint8_t>{1, 0}));
    grains.fine = {1, 1};
    EXPECT_NE(complaint(variant, grains).find("marks all grains as fine"), std::string::npos);
}

TEST(MarkFines, APackingWithoutFinesIsRefusedWhereAStageNeedsThem) {
    casefile::Variant variant = eroded_mixture(band(1.2e-3, 1.5e-3), band(0.9e-3, 1.0e-3));
    EXPECT_NE(complaint(variant, grains_of({1.3e-3, 1.4e-3})).find("leaves no fines"), std::string::npos);
    EXPECT_NE(complaint(variant, grains_of({0.9e-3, 0.95e-3})).find("leaves no skeleton"), std::string::npos);
    variant.soil->fines_content = 0; // none are requested
    EXPECT_EQ(complaint(variant, grains_of({1.3e-3, 1.4e-3})), "");
    variant.soil->fines_content = 0.5;
    variant.stages.front().spec = dem::SettleSpec{};
    EXPECT_EQ(complaint(variant, grains_of({1.3e-3, 1.4e-3})), "");
}

TEST(MarkFines, ASplitThatDoesNotExistIsRefused) {
    casefile::Variant variant;
    variant.soil.emplace();
    variant.soil->whole = band(1.0e-3, 1.5e-3);
    variant.soil->kenney_lau = true;
    EXPECT_NE(complaint(variant, grains_of({1.1e-3, 1.4e-3})).find("split does not exist"), std::string::npos);
}

} // namespace
} // namespace suffuse::record
