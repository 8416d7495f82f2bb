#include "suffuse/stats/stress_by_fraction.hpp"

#include "suffuse/dem/inspect.hpp"

namespace suffuse::stats {

std::vector<Mat3> grain_stress_moments(const dem::World& world) {
    const grains::Grains& grains = world.grains;
    std::vector<Mat3> moment(grains.size());
    for (const dem::ContactView& c : dem::inspect_contacts(world)) {
        const Vec3 branch = grains.position[c.j] + cell::shift(world.cell.h, c.image) - grains.position[c.i];
        const double half = 0.5 * c.overlap, arm_i = grains.radius[c.i] - half, arm_j = grains.radius[c.j] - half;
        const Mat3 product = outer(-(c.normal_force + c.shear_force), branch); // minus: compression is positive
        moment[c.i] += arm_i / (arm_i + arm_j) * product;
        moment[c.j] += arm_j / (arm_i + arm_j) * product;
    }
    return moment;
}

std::vector<Mat3> grain_stresses(const dem::World& world) {
    std::vector<Mat3> stress = grain_stress_moments(world);
    for (std::size_t g = 0; g < stress.size(); ++g) {
        stress[g] = (1 / sphere_volume(world.grains.radius[g])) * stress[g];
    }
    return stress;
}

StressByFraction measure_stress_by_fraction(const dem::World& world) {
    const std::vector<Mat3> moment = grain_stress_moments(world);
    const double volume = cell::volume(world.cell);
    StressByFraction result;
    double solid = 0, fines = 0;
    for (std::size_t g = 0; g < moment.size(); ++g) {
        const bool fine = world.grains.fine[g] != 0;
        const double grain_volume = sphere_volume(world.grains.radius[g]);
        solid += grain_volume;
        fines += fine ? grain_volume : 0;
        (fine ? result.fines : result.coarse) += (1 / volume) * moment[g];
    }
    result.total = result.coarse + result.fines;
    result.fines_content = solid > 0 ? fines / solid : 0;
    const double pressure = dem::mean_stress(result.total);
    result.fines_share = pressure != 0 ? dem::mean_stress(result.fines) / pressure : 0;
    if (result.fines_content > 0) {
        result.alpha_fines = result.fines_share / result.fines_content;
    }
    if (result.fines_content < 1) {
        result.alpha_coarse = (1 - result.fines_share) / (1 - result.fines_content);
    }
    return result;
}

} // namespace suffuse::stats
