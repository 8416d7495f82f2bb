#pragma once
// Where the work of triaxial tests goes: springs, slip, rolling, damping.

#include "suffuse/dem/energy.hpp"
#include "suffuse/figures/figure.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::figures {

/// Of a whole test; the mean over samples that differ in their seed only.
struct TestEnergy {
    std::string name;        ///< "shear", "FC 10 %, shear"
    dem::EnergyParts energy; ///< [J/m3]; no work: a test of an earlier version, which is not drawn
};

/// Ours: the shares of the work, a bar a test.
std::optional<Figure> energy_of_tests(const std::vector<TestEnergy>& tests);

} // namespace suffuse::figures
