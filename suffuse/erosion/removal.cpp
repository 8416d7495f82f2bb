#include "suffuse/erosion/removal.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/cell/strain.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/erosion/extraction.hpp"
#include "suffuse/erosion/reequilibrate.hpp"
#include "suffuse/erosion/removal_order.hpp"
#include "suffuse/stats/coordination.hpp"

#include <algorithm>
#include <utility>

namespace suffuse::erosion {
namespace {

Reason reason_of(RemovedFines which) {
    return which == RemovedFines::All      ? Reason::Removed
           : which == RemovedFines::Active ? Reason::RemovedActive
                                           : Reason::RemovedInactive;
}

/// What pass `number` takes, in the order of the grain table: all of the class where all goes at once, else as much as
/// is still to go by the end of the pass.
std::vector<std::uint32_t>
choose_leaving(const dem::World& world, const RemoveSpec& spec, const RemovalResult& result, int number) {
    std::vector<std::uint32_t> rows = fines_to_remove(world, spec.grains);
    const bool takes_all = spec.share >= 1 && spec.passes == 1;
    if (!takes_all) {
        const double gone = result.erosion.initial_mass - total_mass(world.grains);
        const double by_now = result.requested_mass * number / spec.passes;
        rows = take_mass(world, put_in_order(world, std::move(rows), spec.order), by_now - gone);
        std::sort(rows.begin(), rows.end());
    }
    return rows;
}

} // namespace

std::vector<std::uint32_t> fines_to_remove(const dem::World& world, RemovedFines which) {
    const std::vector<int> contacts = dem::coordination(world);
    std::vector<std::uint32_t> rows;
    for (std::uint32_t g = 0; g < world.grains.size(); ++g) {
        const bool is_active = contacts[g] >= stats::active_contacts;
        const bool is_meant = which == RemovedFines::All || is_active == (which == RemovedFines::Active);
        if (world.grains.fine[g] != 0 && is_meant) {
            rows.push_back(g);
        }
    }
    return rows;
}

RemovalResult begin_removal(const dem::World& world, const RemoveSpec& spec) {
    ErosionResult erosion = begin_erosion(world);
    double mass = 0;
    for (const std::uint32_t g : fines_to_remove(world, spec.grains)) {
        mass += world.grains.mass[g];
    }
    return {std::move(erosion), world.cell.h, spec.share * mass};
}

bool remove_once(
    dem::World& world, const RemoveSpec& spec, const Surroundings& around, RemovalResult& result, PassUnderWay& now
) {
    using At = PassUnderWay::At;
    dem::World& next = now.world;
    PassResult& pass = now.pass;
    if (now.at == At::Start) {
        next = world;
        dem::sort_along_curve(next);
        pass.pass = static_cast<int>(result.erosion.passes.size()) + 1;
        describe_before(next, pass);
        const std::vector<std::uint32_t> leaving = choose_leaving(next, spec, result, pass.pass);
        if (leaving.size() == next.grains.size()) {
            throw NoSkeleton("all grains are fines and would be removed: nothing would remain to carry the stresses");
        }
        now.ledger = extract(next, leaving, dem::coordination(next), reason_of(spec.grains), result.erosion, pass);
        pass.detachable = pass.removed;
        now.at = At::Settle;
    }
    reequilibrate(next, spec.resettle, result.erosion, around, pass, now.resettlement);
    const bool is_last = pass.pass >= spec.passes;
    if (!is_last && !pass.verdict && fines_to_remove(next, spec.grains).empty()) {
        pass.verdict = {NoneToRemove{pass.pass, spec.passes}};
    }
    const bool go_on = !is_last && !pass.verdict;
    result.erosion.ledger = std::move(now.ledger);
    const std::vector<PathRow>& path = now.resettlement.rows;
    result.erosion.path.insert(result.erosion.path.end(), path.begin(), path.end());
    result.erosion.passes.push_back(std::move(pass));
    world = std::move(next);
    now = {};
    return go_on;
}

double removed_share(const dem::World& world, const RemovalResult& result) {
    return 1 - total_mass(world.grains) / result.erosion.initial_mass;
}

Vec3 removal_strain(const dem::World& world, const RemovalResult& result) {
    return cell::axial_strains(result.start_h, world.cell.h);
}

} // namespace suffuse::erosion
