// Moduli of made-up elastic tensors, against closed forms.

#include "suffuse/triaxial/elastic_moduli.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::triaxial {
namespace {

ElasticTensor cubic(double c11, double c12, double c44) {
    ElasticTensor tensor{};
    for (std::size_t i = 0; i < 3; ++i) {
        tensor[i] = {c12, c12, c12, 0, 0, 0};
        tensor[i][i] = c11;
        tensor[i + 3][i + 3] = c44;
    }
    return tensor;
}

TEST(ElasticModuli, OfAnIsotropicBodyAreItsOwn) {
    const double young = 90e6, poisson = 0.2, shear = young / (2 * (1 + poisson)),
                 lame = 2 * shear * poisson / (1 - 2 * poisson);
    const ElasticModuli moduli = moduli_of(cubic(lame + 2 * shear, lame, shear));
    EXPECT_NEAR(moduli.young_modulus, young, 1e-6 * young);
    EXPECT_NEAR(moduli.poisson_ratio, poisson, 1e-12);
    EXPECT_NEAR(moduli.shear_modulus, shear, 1e-6 * shear);
    EXPECT_NEAR(moduli.bulk_modulus, lame + 2 * shear / 3, 1e-6 * young);
    EXPECT_NEAR(*moduli.anisotropy, 0, 1e-12);
    for (const double along_axis : *moduli.young_moduli) {
        EXPECT_NEAR(along_axis, young, 1e-6 * young);
    }
}

TEST(ElasticModuli, AnisotropyOfACubicBodyIsThatOfItsZenerRatio) {
    for (const double zener : {0.3, 1.0, 2.5}) {
        const ElasticModuli moduli = moduli_of(cubic(3, 1, zener)); // 2 c44 / (c11 - c12)
        EXPECT_NEAR(*moduli.anisotropy, 1.2 * std::pow(std::sqrt(zener) - 1 / std::sqrt(zener), 2), 1e-12);
        EXPECT_NEAR((*moduli.young_moduli)[0], 3 - 2.0 / 4, 1e-12); // c11 - 2 c12^2/(c11 + c12)
    }
}

TEST(ElasticModuli, ComplianceIsTheInverse) {
    ElasticTensor tensor = cubic(4, 1, 1.5);
    tensor[0][4] = tensor[4][0] = 0.3;
    tensor[1][5] = tensor[5][1] = -0.2;
    const ElasticTensor compliance = *compliance_of(tensor);
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j) {
            double product = 0;
            for (std::size_t k = 0; k < 6; ++k) {
                product += tensor[i][k] * compliance[k][j];
            }
            EXPECT_NEAR(product, i == j ? 1 : 0, 1e-14) << i << j;
        }
    }
}

TEST(ElasticModuli, ABodyThatSomeStrainCostsNoWorkHasNoCompliance) {
    const ElasticModuli moduli = moduli_of(cubic(1, 2, 1)); // c11 < c12
    EXPECT_FALSE(moduli.anisotropy);
    EXPECT_FALSE(moduli.young_moduli);
}

} // namespace
} // namespace suffuse::triaxial
