#include "suffuse/dem/move_grains.hpp"

#include "suffuse/base/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::dem {
namespace {

/// Contact force and torque on grain `g`: first the contacts in which it is the first grain, then the others.
void gather(
    const contact::Incidence& incidence, const std::vector<contact::ContactForce>& forces, std::size_t g, Vec3& force,
    Vec3& torque
) {
    for (std::uint32_t c = incidence.first_start[g]; c < incidence.first_start[g + 1]; ++c) {
        force -= forces[c].force;
        torque += forces[c].torque_1;
    }
    for (std::uint32_t k = incidence.second_start[g]; k < incidence.second_start[g + 1]; ++k) {
        const contact::ContactForce& f = forces[incidence.second_contact[k]];
        force += f.force;
        torque += f.torque_2;
    }
}

} // namespace

double move_grains(
    const motion::StepMotion& step, const StepCaches& caches, const grains::GrainLoad* load, double load_share,
    const Mat3& h, grains::Grains& grains
) {
    const contact::Incidence& incidence = caches.neighborhood.incidence();
    const std::vector<Vec3>& reference = caches.neighborhood.reference();
    // The cell moves on with the new gradient in the next step, when this motion is looked at.
    const Mat3 mean_motion =
        (h + step.dt * ((step.old_gradient + step.change) * h)) * inverse(caches.neighborhood.reference_h());
    const bool loaded = load != nullptr && !load->force.empty();
    const double square = parallel_sum(
        grains.size(), 512, 0.0,
        [&](std::size_t begin, std::size_t end) {
            double most = 0;
            for (std::size_t g = begin; g < end; ++g) {
                Vec3 force, torque;
                gather(incidence, caches.forces, g, force, torque);
                grains.force[g] = force;
                grains.torque[g] = torque;
                if (loaded) {
                    force += load_share * load->force[g];
                }
                if (grains.motion[g] == grains::Motion::Free) {
                    motion::move_free(
                        step, force, torque, grains.mass[g], grains.inertia[g], grains.position[g], grains.velocity[g],
                        grains.spin[g]
                    );
                } else {
                    motion::move_held(step, grains.position[g], grains.velocity[g], grains.spin[g]);
                }
                most = std::max(most, norm2(grains.position[g] - mean_motion * reference[g]));
            }
            return most;
        },
        [](double a, double b) { return std::max(a, b); }
    );
    return std::sqrt(square);
}

} // namespace suffuse::dem
