#include "suffuse/stats/coordination.hpp"

#include "suffuse/dem/inspect.hpp"
#include "suffuse/stats/contact_class.hpp"

#include <algorithm>

namespace suffuse::stats {
namespace {

double per(double contacts, std::int64_t grains) {
    return grains > 0 ? contacts / static_cast<double>(grains) : 0;
}

void count_by_class(const dem::World& world, Coordination& result) {
    std::int64_t fines = 0;
    for (const std::uint8_t fine : world.grains.fine) {
        fines += fine != 0 ? 1 : 0;
    }
    PerClass<std::int64_t> count{};
    for (std::size_t c = 0; c < world.contacts.size(); ++c) {
        if (world.contacts.touches(c)) {
            ++count[class_of(world.grains, world.contacts.first[c], world.contacts.second[c])];
        }
    }
    const std::int64_t coarse = result.grains - fines;
    const auto mixed = static_cast<double>(count.large_small);
    result.contacts = count.total();
    result.coarse_coarse = per(2 * static_cast<double>(count.large_large), coarse);
    result.coarse_fine = per(mixed, coarse);
    result.fine_coarse = per(mixed, fines);
    result.fine_fine = per(2 * static_cast<double>(count.small_small), fines);
}

} // namespace

Coordination measure_coordination(const dem::World& world) {
    Coordination result;
    result.grains = static_cast<std::int64_t>(world.grains.size());
    std::int64_t single = 0;
    for (const int k : dem::coordination(world)) {
        const auto contacts = static_cast<std::size_t>(k);
        result.histogram.resize(std::max(result.histogram.size(), contacts + 1));
        ++result.histogram[contacts];
        result.without_contact += k == 0 ? 1 : 0;
        single += k == 1 ? 1 : 0;
    }
    result.rattlers = result.without_contact + single;
    count_by_class(world, result);
    const double ends = 2 * static_cast<double>(result.contacts);
    result.mean = per(ends, result.grains);
    result.mechanical = per(ends - static_cast<double>(single), result.grains - result.rattlers);
    return result;
}

} // namespace suffuse::stats
