#include "suffuse/triaxial/pore_fluid.hpp"

#include "suffuse/triaxial/stiffness.hpp"

namespace suffuse::triaxial {

double skempton_b(double porosity, const PoreFluid& fluid) {
    return 1 / (1 + porosity * fluid.skeleton_modulus / fluid.bulk_modulus);
}

double measure_skeleton_modulus(const dem::World& world, double damping, const Pulse& pulse) {
    const StiffnessSpec spec; // an undrained test has no keys for it
    const ProbeAdvice advice{
        "an undrained test with `bulk_modulus` of the fluid measures the stiffness of the sample first: settle it to a "
        "smaller unbalanced force before, or leave out `bulk_modulus`, so that water is incompressible",
        "an undrained test with `bulk_modulus` of the fluid measures the stiffness of the sample first: begin it at a "
        "state further from failure, or leave out `bulk_modulus`, so that water is incompressible"};
    RestedState state = rest_for_strains(world, spec, damping, pulse, advice);
    const Voigt stress = probe_strain(state, spec, (1.0 / 3) * identity(), damping, pulse, advice).whole;
    return (stress[0] + stress[1] + stress[2]) / 3;
}

} // namespace suffuse::triaxial
