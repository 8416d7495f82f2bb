#pragma once
// Read-only views of a world: contacts with normals and forces, stress, density. Made on demand from what the last step
// left.

#include "suffuse/dem/world.hpp"

#include <cstdint>
#include <vector>

namespace suffuse::dem {

/// One touching contact at the last step. Rows i and j of the grain table; forces act on grain i.
struct ContactView {
    std::uint32_t i = 0, j = 0;
    cell::Image image;
    double overlap = 0;     ///< [m]
    Vec3 normal;            ///< from i to j [-]
    Vec3 normal_force;      ///< on i [N]
    Vec3 shear_force;       ///< on i [N]
    Vec3 moment;            ///< bending and twisting, on i [N m]
    bool is_bonded = false; ///< adhesion holds it
};

std::vector<ContactView> inspect_contacts(const World& world);

/// Which of the touching contacts, in the order of `inspect_contacts`, the last step left at a limit of the law (to
/// 1e-6: fast mode is of single precision). Where the limit is zero or there is none, no contact has reached it.
struct ContactsAtLimit {
    std::vector<std::uint8_t> sliding; ///< 1: |shear force| = tan(friction) x normal force, and not bonded
    std::vector<std::uint8_t> rolling; ///< 1: |bending moment| = rolling_friction x min(r1, r2) x |normal force|
};

ContactsAtLimit find_contacts_at_limit(const World& world);

/// Stress of the last step's contact forces with branches at the positions now, compression positive [Pa]; the same
/// choice as the reference's, within 1e-6 of the tensor inside the step.
Mat3 mean_stress_tensor(const World& world);

/// Number of touching contacts of each grain.
std::vector<int> coordination(const World& world);

/// Whether contacts can only push, now and in all steps to come in a cell that is not sheared: no friction, no
/// adhesion, no spin, and no contact that remembers a shear force or a moment.
bool contacts_only_push(const World& world);

double void_ratio(const World& world);

double porosity(const World& world);

/// p = tr/3 and the deviator stress q = sqrt(3 J2) [Pa].
double mean_stress(const Mat3& stress);
double deviator_stress(const Mat3& stress);

/// Logarithmic strain of each axis since `reference_h`, compression positive [-]; volumetric is their sum for boxes.
Vec3 strain(const World& world);

} // namespace suffuse::dem
