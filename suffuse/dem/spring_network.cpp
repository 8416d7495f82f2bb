#include "suffuse/dem/spring_network.hpp"

#include "suffuse/base/parallel.hpp"
#include "suffuse/contact/carry_over.hpp"
#include "suffuse/contact/stress.hpp"
#include "suffuse/dem/first_contacts.hpp"

#include <algorithm>

namespace suffuse::dem {
namespace {

/// Those that the last step found; before the first step those of the geometry.
contact::Contacts touching_contacts(const World& world) {
    return awaits_first_step(world) || world.contacts.size() == 0 ? find_first_contacts(world)
                                                                  : contact::touching_rows(world.contacts);
}

} // namespace

SpringNetwork::SpringNetwork(const World& world, double shear_ratio, double least_overlap)
    : world_(world), shear_ratio_(shear_ratio) {
    const contact::Contacts touching = touching_contacts(world);
    contact::plan_sums(touching, world.grains.size(), plan_);
    const std::vector<double>& radius = world.grains.radius;
    springs_.reserve(touching.size());
    for (std::size_t c = 0; c < touching.size(); ++c) {
        const std::uint32_t i = touching.first[c], j = touching.second[c];
        const double overlap = std::max(touching.overlap[c], least_overlap * std::min(radius[i], radius[j]));
        const double stiffness = contact::normal_stiffness(world.material, radius[i], radius[j], overlap);
        springs_.push_back({i, j, plan_.second_sum[c], stiffness, touching.normal[c]});
    }
}

template <bool Shears>
void SpringNetwork::add_springs(std::size_t domain, const Motions& in, Motions& out) const {
    const grains::Material& material = world_.material;
    for (std::size_t c = plan_.domain_start[domain]; c < plan_.domain_start[domain + 1]; ++c) {
        const auto& [i, j, sum, kn, n] = springs_[c];
        const Vec3 apart = in.shift[j] - in.shift[i];
        const double opening = dot(n, apart);
        Vec3 force = kn * opening * n;
        if constexpr (Shears) {
            const double ks = shear_ratio_ * kn, r1 = world_.grains.radius[i], r2 = world_.grains.radius[j];
            const Vec3 slip = apart - opening * n - cross(r1 * in.turn[i] + r2 * in.turn[j], n);
            const Vec3 roll = in.turn[j] - in.turn[i];
            const Vec3 twist = dot(n, roll) * n;
            const Vec3 moment =
                ks * r1 * r2 * (material.rolling_stiffness * (roll - twist) + material.twisting_stiffness * twist);
            const Vec3 arm = cross(n, ks * slip);
            force += ks * slip;
            out.turn[i] -= r1 * arm + moment;
            out.turn[sum] += moment - r2 * arm;
        }
        out.shift[i] -= force;
        out.shift[sum] += force;
    }
}

void SpringNetwork::apply(const Motions& in, Motions& out) const {
    parallel_for(rows(), 1024, [&](std::size_t begin, std::size_t end) {
        std::fill(&out.shift[begin], &out.shift[begin] + (end - begin), Vec3{});
        std::fill(&out.turn[begin], &out.turn[begin] + (end - begin), Vec3{});
    });
    parallel_for(plan_.domains(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t d = begin; d < end; ++d) {
            if (shear_ratio_ == 0) {
                add_springs<false>(d, in, out);
            } else {
                add_springs<true>(d, in, out);
            }
        }
    });
    parallel_for(plan_.domains(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = plan_.remote_start[begin]; k < plan_.remote_start[end]; ++k) {
            const std::uint32_t grain = plan_.remote[k];
            out.shift[grain] += out.shift[plan_.grains + k];
            out.turn[grain] += out.turn[plan_.grains + k];
        }
    });
}

} // namespace suffuse::dem
