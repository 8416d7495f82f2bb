#include "suffuse/triaxial/elastic_moduli.hpp"

#include <cmath>

namespace suffuse::triaxial {
namespace {

constexpr std::size_t size = 6;

struct Averages {
    double bulk, shear;
};

/// Sums of a tensor's entries of which all averages are made.
struct Sums {
    double axial = 0, lateral = 0, shear = 0; ///< (11 + 22 + 33), (12 + 23 + 31), (44 + 55 + 66)
};

Sums sums_of(const ElasticTensor& t) {
    return {t[0][0] + t[1][1] + t[2][2], t[0][1] + t[1][2] + t[2][0], t[3][3] + t[4][4] + t[5][5]};
}

Averages voigt_averages(const ElasticTensor& stiffness) {
    const Sums c = sums_of(stiffness);
    return {(c.axial + 2 * c.lateral) / 9, (c.axial - c.lateral + 3 * c.shear) / 15};
}

Averages reuss_averages(const ElasticTensor& compliance) {
    const Sums s = sums_of(compliance);
    return {1 / (s.axial + 2 * s.lateral), 15 / (4 * s.axial - 4 * s.lateral + 3 * s.shear)};
}

/// Lower triangle whose product with its transpose is the tensor; nothing where there is none.
std::optional<ElasticTensor> cholesky_factor(const ElasticTensor& t) {
    ElasticTensor lower{};
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double left = t[i][j];
            for (std::size_t k = 0; k < j; ++k) {
                left -= lower[i][k] * lower[j][k];
            }
            if (i == j && !(left > 0)) {
                return std::nullopt;
            }
            lower[i][j] = i == j ? std::sqrt(left) : left / lower[j][j];
        }
    }
    return lower;
}

} // namespace

ElasticTensor symmetric_part(const ElasticTensor& tensor) {
    ElasticTensor mean;
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < size; ++j) {
            mean[i][j] = 0.5 * (tensor[i][j] + tensor[j][i]);
        }
    }
    return mean;
}

std::optional<ElasticTensor> compliance_of(const ElasticTensor& stiffness) {
    const std::optional<ElasticTensor> lower = cholesky_factor(stiffness);
    if (!lower) {
        return std::nullopt;
    }
    ElasticTensor compliance{};
    for (std::size_t column = 0; column < size; ++column) {
        Voigt x{};
        x[column] = 1;
        for (std::size_t i = 0; i < size; ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                x[i] -= (*lower)[i][k] * x[k];
            }
            x[i] /= (*lower)[i][i];
        }
        for (std::size_t i = size; i-- > 0;) {
            for (std::size_t k = i + 1; k < size; ++k) {
                x[i] -= (*lower)[k][i] * x[k];
            }
            x[i] /= (*lower)[i][i];
        }
        compliance[column] = x; // symmetric
    }
    return compliance;
}

ElasticModuli moduli_of(const ElasticTensor& stiffness) {
    const auto [bulk, shear] = voigt_averages(stiffness);
    ElasticModuli moduli;
    moduli.bulk_modulus = bulk;
    moduli.shear_modulus = shear;
    moduli.young_modulus = 9 * bulk * shear / (3 * bulk + shear);
    moduli.poisson_ratio = (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear));
    if (const std::optional<ElasticTensor> compliance = compliance_of(stiffness)) {
        const Averages soft = reuss_averages(*compliance);
        moduli.young_moduli = {1 / (*compliance)[0][0], 1 / (*compliance)[1][1], 1 / (*compliance)[2][2]};
        moduli.anisotropy = 5 * shear / soft.shear + bulk / soft.bulk - 6;
    }
    return moduli;
}

} // namespace suffuse::triaxial
