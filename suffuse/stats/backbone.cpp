#include "suffuse/stats/backbone.hpp"

#include "suffuse/contact/springs.hpp"
#include "suffuse/dem/inspect.hpp"

#include <algorithm>
#include <vector>

namespace suffuse::stats {

int least_contacts(const grains::Material& material) {
    return material.friction > 0 ? 2 : 4;
}

Backbone measure_backbone(const dem::World& world, int least) {
    const contact::Contacts& contacts = world.contacts;
    std::vector<int> count = dem::coordination(world);
    std::vector<std::uint8_t> gone(count.size(), 0);
    Backbone backbone;
    while (true) {
        bool changed = false;
        for (std::size_t g = 0; g < count.size(); ++g) {
            if (gone[g] == 0 && count[g] < least) {
                gone[g] = 1;
                ++backbone.rattlers;
                changed = true;
            }
        }
        if (!changed) {
            break;
        }
        std::ranges::fill(count, 0);
        for (std::size_t c = 0; c < contacts.size(); ++c) {
            const auto i = contacts.first[c], j = contacts.second[c];
            if (contacts.touches(c) && gone[i] == 0 && gone[j] == 0) {
                ++count[i];
                ++count[j];
            }
        }
    }
    std::int64_t ends = 0;
    for (std::size_t g = 0; g < count.size(); ++g) {
        ends += gone[g] == 0 ? count[g] : 0;
    }
    backbone.grains = static_cast<std::int64_t>(count.size()) - backbone.rattlers;
    backbone.contacts = ends / 2;
    backbone.coordination = backbone.grains > 0 ? static_cast<double>(ends) / static_cast<double>(backbone.grains) : 0;
    return backbone;
}

double stiffness_to_pressure(const dem::World& world) {
    const double pressure = dem::mean_stress(dem::mean_stress_tensor(world));
    if (!(pressure > 0)) {
        return 0;
    }
    return contact::spring_of(world.material).stiffness_to_pressure(world.material, pressure);
}

} // namespace suffuse::stats
