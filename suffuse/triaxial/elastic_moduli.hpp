#pragma once
// What an elastic tensor says in the numbers that engineers use. Voigt's notation: rows xx, yy, zz, yz, zx, xy, with
// engineering shear strains. Averages over all directions by Voigt and Reuss [Hill1952]; one number for anisotropy
// [RanganathanOstojaStarzewski2008].

#include <array>
#include <optional>

namespace suffuse::triaxial {

using Voigt = std::array<double, 6>;
using ElasticTensor = std::array<Voigt, 6>; ///< stress over strain [Pa]

struct ElasticModuli {
    double bulk_modulus = 0;  ///< Voigt's average, as of all below [Pa]
    double shear_modulus = 0; ///< [Pa]
    double young_modulus = 0; ///< [Pa]
    double poisson_ratio = 0; ///< [-]
    // Nothing where some strain costs no work, so that there is no compliance:
    std::optional<std::array<double, 3>> young_moduli; ///< along x, y, z under a stress along that axis alone [Pa]
    std::optional<double> anisotropy;                  ///< 5 Gv/Gr + Kv/Kr - 6: 0 where all directions are alike [-]
};

/// Mean of a tensor and its transpose.
ElasticTensor symmetric_part(const ElasticTensor& tensor);

/// Nothing where the symmetric tensor is not positive definite.
std::optional<ElasticTensor> compliance_of(const ElasticTensor& stiffness);

/// Of a symmetric tensor.
ElasticModuli moduli_of(const ElasticTensor& stiffness);

} // namespace suffuse::triaxial
