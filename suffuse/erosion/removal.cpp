#include "suffuse/erosion/removal.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/erosion/extraction.hpp"
#include "suffuse/erosion/reequilibrate.hpp"
#include "suffuse/stats/coordination.hpp"

#include <cmath>

namespace suffuse::erosion {
namespace {

std::string reason_of(RemovedFines which) {
    return which == RemovedFines::All      ? "removed"
           : which == RemovedFines::Active ? "removed, active"
                                           : "removed, inactive";
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

RemovalResult remove_fines(dem::World& world, const RemoveSpec& spec, const Surroundings& around) {
    RemovalResult result;
    result.erosion = begin_erosion(world);
    dem::World next = world;
    dem::sort_along_curve(next);
    PassResult pass;
    pass.pass = 1;
    describe_before(next, pass);
    const Mat3 start_h = next.cell.h;
    const std::vector<int> contacts = dem::coordination(next);
    std::vector<Leaver> leavers;
    for (const std::uint32_t g : fines_to_remove(next, spec.grains)) {
        leavers.push_back({g, contacts[g]});
        ++pass.coordination_histogram[contacts[g]];
    }
    if (leavers.size() == next.grains.size()) {
        throw StateError("all grains are fines and would be removed: nothing stays to carry the stresses; leave this "
                         "fines content out (key `only`)");
    }
    pass.detachable = pass.removed = static_cast<std::int64_t>(leavers.size());
    extract(next, leavers, pass.pass, reason_of(spec.grains), result.erosion.ledger);
    check_ledger(next, result.erosion.ledger, result.erosion.initial_mass);
    result.removed_share = 1 - total_mass(next.grains) / result.erosion.initial_mass;
    pass.eroded_mass_percent = pass.eroded_mass_percent_of_initial = 100 * result.removed_share;
    const double dt = dem::stable_time_step(next);
    result.erosion.path = reequilibrate(next, dt, result.erosion, around, pass, spec.max_strain);
    result.strain = edge_strains(start_h, next.cell.h);
    result.erosion.passes.push_back(std::move(pass));
    world = std::move(next);
    return result;
}

} // namespace suffuse::erosion
