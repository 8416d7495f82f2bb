#pragma once
// The hot loop over contacts. Contacts are treated in tiles: the two grains of each contact are copied side by side,
// one loop without branches applies the law to the whole tile, and what it exerts is added to the grains. The compiler
// turns it into vector instructions of the processor at hand. Sums are taken in a fixed order.

#include "suffuse/contact/contacts.hpp"
#include "suffuse/contact/law_constants.hpp"
#include "suffuse/contact/sum_plan.hpp"
#include "suffuse/grains/moving_rows.hpp"

#include <functional>
#include <vector>

namespace suffuse::contact {

/// Displacement and velocity of a period against the home period.
struct alignas(64) ImageShift {
    Double4 position, velocity; ///< [m], [m/s]
};

/// What is the same for all contacts in a step.
struct StepSetting {
    double volume = 0;         ///< of the cell [m3]
    double largest_radius = 0; ///< of all grains [m]
    double dt = 0;             ///< [s]
    bool normals_only = false; ///< contacts can only push (`dem::contacts_only_push`)
    bool looked_at = true;     ///< somebody reads overlaps, and normals of contacts that only push, after this step
    std::vector<ImageShift> shifts; ///< of the plan's images
};

/// @param h cell of this step, columns are its vectors [m]; @param image_velocity relative velocity of neighboring
/// periods, G times the cell of the step before [m/s, columns as h] (reference 1.1, 1.3)
void set_up_step(
    const SumPlan& plan, const Mat3& h, const Mat3& image_velocity, double largest_radius, double dt,
    StepSetting& setting
);

struct Pressed {
    Mat3 force_branch; ///< sum over contacts of force (x) branch [N m]: minus tension, so compression is positive
    bool wild = false; ///< a force is not finite, or beyond what grains of this modulus exert however much they overlap
};

/// What is to happen to the grains of a domain as soon as the sums of all that acts on them are complete and no contact
/// looks at where they are any more: while the loop goes on elsewhere, and they are still in the cache.
struct DomainSequel {
    std::function<void(std::size_t domain)> run; ///< on any thread, once for each domain
    std::vector<std::uint32_t> waits_for;        ///< for each domain, how many others are not through yet; scratch
};

/// One step of every contact: updates their memory, and makes the first `plan.grains` rows of `sums` the force and
/// torque on each grain of the contacts of its own domain, the others those from other domains.
/// @param sums `plan.rows()` rows; those beyond the grains must be zero, and those of grains without a contact
Pressed compute_forces(
    const std::vector<grains::MovingRow>& grains, const SumPlan& plan, const StepSetting& setting,
    const LawConstants& law, Contacts& contacts, std::vector<grains::GrainSum>& sums, DomainSequel* sequel = nullptr
);

/// The contacts' memory in single precision, column after column; the table is left without.
void take_single(MemoryOf<double>& contacts, SingleMemory& single);

/// The table has it again.
void give_back_single(SingleMemory& single, MemoryOf<double>& contacts);

/// The same with the memory and the law in single precision; distances, and sums over contacts, stay in double.
Pressed compute_forces(
    const std::vector<grains::MovingRow>& grains, const SumPlan& plan, const StepSetting& setting,
    const LawConstants& law, const ContactPairs& contacts, SingleMemory& memory, std::vector<grains::GrainSum>& sums,
    DomainSequel* sequel = nullptr
);

} // namespace suffuse::contact
