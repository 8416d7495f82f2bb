#include "suffuse/contact/forces.hpp"

#include "suffuse/base/large_pages.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/contact/contact_loop.hpp"

#include <atomic>
#include <cmath>
#include <mutex>
#include <utility>

namespace suffuse::contact {
namespace {

template <class Real>
MemoryColumns<Real> pointers(MemoryOf<Real>& m) {
    return {m.shear_force.x.data(), m.shear_force.y.data(), m.shear_force.z.data(), m.bending.x.data(),
            m.bending.y.data(),     m.bending.z.data(),     m.normal.x.data(),      m.normal.y.data(),
            m.normal.z.data(),      m.twisting.x.data(),    m.twisting.y.data(),    m.twisting.z.data(),
            m.overlap.data(),       m.bonded.data()};
}

/// Calls `visit` on every column of memory of the two tables that is known to the precision of its table.
template <class Visit>
void for_each_column(MemoryOf<double>& contacts, SingleMemory& single, Visit&& visit) {
    const auto each = [&](VectorColumn& a, VectorColumnOf<float>& b) {
        visit(a.x, b.x);
        visit(a.y, b.y);
        visit(a.z, b.z);
    };
    each(contacts.shear_force, single.shear_force);
    each(contacts.bending, single.bending);
    each(contacts.normal, single.normal);
    each(contacts.twisting, single.twisting);
    visit(contacts.overlap, single.overlap);
}

/// Nothing is left of `from`: at no time is there room for two tables.
template <class From, class To>
void move_column(std::vector<From>& from, std::vector<To>& to) {
    reserve_in_large_pages(to, from.size());
    to.assign(from.begin(), from.end());
    from = std::vector<From>();
}

/// A domain is through: those that it reaches wait for one less.
void go_on_after(std::size_t domain, const SumPlan& plan, DomainSequel& sequel) {
    for (std::uint32_t k = plan.reach_start[domain]; k < plan.reach_start[domain + 1]; ++k) {
        const std::uint32_t reached = plan.reach[k];
        if (std::atomic_ref(sequel.waits_for[reached]).fetch_sub(1, std::memory_order_acq_rel) == 1) {
            sequel.run(reached);
        }
    }
}

template <class Real>
Pressed press_contacts(
    const std::vector<grains::MovingRow>& grains, const SumPlan& plan, const StepSetting& setting,
    const LawConstants& law, const ContactPairs& contacts, MemoryOf<Real>& memory, std::vector<grains::GrainSum>& sums,
    DomainSequel* sequel
) {
    if (sequel != nullptr) {
        sequel->waits_for = plan.reached_by;
    }
    // Grains whose centers coincide push with the spring's largest stress. With shear, the sum of a force's components
    // stays below twice that until they are nearly there. And no mean stress reaches it. The quantum follows from the
    // state alone, as the same bits after a resume require.
    const double r = setting.largest_radius, most = law.most_stress, largest_force = 2 * most * r * r;
    const SumQuantum quantum(largest_force * 2 * r, most * setting.volume);
    const DomainWork<Real> work{
        .grains = grains.data(),
        .first = contacts.first.data(),
        .second = contacts.second.data(),
        .second_sum = plan.second_sum.data(),
        .image = plan.image.data(),
        .shifts = setting.shifts.data(),
        .exact_law = law,
        .law = law.as<Real>(),
        .dt = static_cast<Real>(setting.dt),
        .quantum = quantum,
        .largest_force = largest_force,
        .looked_at = setting.looked_at,
        .beyond_cache = grains.size() > cached_grains,
        .memory = pointers(memory),
        .sums = sums.data()};
    const DomainLoop<Real> press_loop =
        choose_loop<Real>(setting.normals_only, !memory.bonded.empty(), memory.twisting.size() > 0);
    StressSum total;
    std::mutex adding; // integers: the order does not matter
    parallel_for(plan.domains(), 1, Help::Late, [&](std::size_t first, std::size_t last) {
        StressSum part;
        for (std::size_t d = first; d < last; ++d) {
            for (std::size_t k = d * domain_grains; k < plan.awake_end[d]; ++k) {
                sums[plan.roster[k]] = {}; // now, so that the loop finds them in the cache
            }
            press_loop(work, {plan.domain_start[d], plan.domain_start[d + 1], plan.far[d]}, part);
            if (sequel != nullptr) {
                go_on_after(d, plan, *sequel);
            }
        }
        const std::lock_guard lock(adding);
        for (std::size_t q = 0; q < part.quanta.size(); ++q) {
            total.quanta[q] += part.quanta[q];
        }
        total.wild |= part.wild;
    });
    Pressed pressed;
    for (std::size_t q = 0; q < total.quanta.size(); ++q) {
        pressed.force_branch.m[q / 3][q % 3] = quantum.value(total.quanta[q]);
    }
    pressed.wild = total.wild != 0;
    return pressed;
}

} // namespace

void set_up_step(
    const SumPlan& plan, const Mat3& h, const Mat3& image_velocity, double largest_radius, double dt,
    StepSetting& setting
) {
    setting.volume = std::abs(determinant(h));
    setting.largest_radius = largest_radius;
    setting.dt = dt;
    setting.shifts.clear();
    for (const cell::Image& image : plan.images) {
        setting.shifts.push_back({double4(cell::shift(h, image), 0), double4(cell::shift(image_velocity, image), 0)});
    }
}

void take_single(MemoryOf<double>& contacts, SingleMemory& single) {
    for_each_column(contacts, single, [](std::vector<double>& from, std::vector<float>& to) { move_column(from, to); });
    single.bonded = std::move(contacts.bonded);
}

void give_back_single(SingleMemory& single, MemoryOf<double>& contacts) {
    for_each_column(contacts, single, [](std::vector<double>& to, std::vector<float>& from) { move_column(from, to); });
    contacts.bonded = std::move(single.bonded);
}

Pressed compute_forces(
    const std::vector<grains::MovingRow>& grains, const SumPlan& plan, const StepSetting& setting,
    const LawConstants& law, Contacts& contacts, std::vector<grains::GrainSum>& sums, DomainSequel* sequel
) {
    return press_contacts<double>(grains, plan, setting, law, contacts, contacts, sums, sequel);
}

Pressed compute_forces(
    const std::vector<grains::MovingRow>& grains, const SumPlan& plan, const StepSetting& setting,
    const LawConstants& law, const ContactPairs& contacts, SingleMemory& memory, std::vector<grains::GrainSum>& sums,
    DomainSequel* sequel
) {
    return press_contacts<float>(grains, plan, setting, law, contacts, memory, sums, sequel);
}

} // namespace suffuse::contact
