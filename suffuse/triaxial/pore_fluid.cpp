#include "suffuse/triaxial/pore_fluid.hpp"

#include "suffuse/triaxial/stiffness.hpp"

namespace suffuse::triaxial {

double skempton_b(double porosity, const PoreFluid& fluid) {
    return 1 / (1 + porosity * fluid.skeleton_modulus / fluid.bulk_modulus);
}

double measure_skeleton_modulus(const dem::World& world, double damping, const Pulse& pulse) {
    const StiffnessSpec spec;
    RestedState state = rest_for_strains(world, spec, damping, pulse);
    const Voigt stress = probe_strain(state, spec, (1.0 / 3) * identity(), damping, pulse).whole;
    return (stress[0] + stress[1] + stress[2]) / 3;
}

} // namespace suffuse::triaxial
