#include "suffuse/dem/inspect.hpp"

#include "suffuse/cell/strain.hpp"
#include "suffuse/contact/linear_rolling.hpp"
#include "suffuse/contact/stress.hpp"
#include "suffuse/contact/sum_touching.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::dem {

namespace {

bool is_bonded(const contact::Contacts& contacts, std::size_t c) {
    return !contacts.bonded.empty() && contacts.bonded[c] != 0;
}

ContactView view_of(const World& world, std::size_t c) {
    const contact::Contacts& contacts = world.contacts;
    const std::uint32_t i = contacts.first[c], j = contacts.second[c];
    const Vec3 n = contacts.normal[c];
    const double push = contact::normal_force(world.grains, contacts, world.material, c);
    Vec3 moment = contacts.bending[c];
    if (contacts.twisting.size() > 0) {
        moment += contacts.twisting[c];
    }
    return {i,
            j,
            contacts.image[c],
            contacts.overlap[c],
            n,
            -push * n,
            -contacts.shear_force[c],
            -moment,
            is_bonded(contacts, c)};
}

bool has_reached(const Vec3& v, double limit) {
    constexpr double rounding = 1e-6; // of single precision
    return limit > 0 && norm(v) >= (1 - rounding) * limit;
}

} // namespace

std::vector<ContactView> inspect_contacts(const World& world) {
    std::vector<ContactView> views;
    for (std::size_t c = 0; c < world.contacts.size(); ++c) {
        if (world.contacts.touches(c)) {
            views.push_back(view_of(world, c));
        }
    }
    return views;
}

ContactsAtLimit find_contacts_at_limit(const World& world) {
    const contact::LawConstants law = contact::resolve_law(world.material);
    const contact::Contacts& contacts = world.contacts;
    ContactsAtLimit found;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        if (!contacts.touches(c)) {
            continue;
        }
        const double push = contact::normal_force(world.grains, contacts, world.material, c);
        const double r1 = world.grains.radius[contacts.first[c]], r2 = world.grains.radius[contacts.second[c]];
        found.sliding.push_back(
            !is_bonded(contacts, c) && has_reached(contacts.shear_force[c], law.tan_friction * push) ? 1 : 0
        );
        const double most_bending = law.rolling_limit * std::min(r1, r2) * std::abs(push);
        found.rolling.push_back(has_reached(contacts.bending[c], most_bending) ? 1 : 0);
    }
    return found;
}

Mat3 mean_stress_tensor(const World& world) {
    const std::vector<Vec3>& position = world.grains.position;
    const Mat3 sum = contact::sum_touching(world.contacts, position.size(), Mat3{}, [&](Mat3& part, std::size_t c) {
        const ContactView view = view_of(world, c);
        const Vec3 branch = position[view.j] + cell::shift(world.cell.h, view.image) - position[view.i];
        part += outer(-(view.normal_force + view.shear_force), branch);
    });
    return (1 / cell::volume(world.cell)) * sum;
}

std::vector<int> coordination(const World& world) {
    std::vector<int> count(world.grains.size(), 0);
    for (std::size_t c = 0; c < world.contacts.size(); ++c) {
        if (!world.contacts.touches(c)) {
            continue;
        }
        ++count[world.contacts.first[c]];
        ++count[world.contacts.second[c]];
    }
    return count;
}

bool contacts_only_push(const World& world) {
    const grains::Material& material = world.material;
    if (material.friction != 0 || material.viscous_damping != 0 || adheres(material) ||
        !is_diagonal(world.cell.velocity_gradient)) {
        return false;
    }
    const auto all_zero = [](const std::vector<double>& column) {
        return std::ranges::all_of(column, [](double a) { return a == 0; });
    };
    const contact::Contacts& contacts = world.contacts;
    for (const contact::VectorColumn* memory : {&contacts.shear_force, &contacts.bending, &contacts.twisting}) {
        if (!all_zero(memory->x) || !all_zero(memory->y) || !all_zero(memory->z)) {
            return false;
        }
    }
    return contacts.bonded.empty() &&
           std::ranges::all_of(world.grains.spin, [](const Vec3& spin) { return spin == Vec3{}; });
}

double void_ratio(const World& world) {
    return cell::volume(world.cell) / grains::solid_volume(world.grains) - 1;
}

double porosity(const World& world) {
    return 1 - grains::solid_volume(world.grains) / cell::volume(world.cell);
}

double mean_stress(const Mat3& stress) {
    return trace(stress) / 3;
}

double deviator_stress(const Mat3& stress) {
    const double p = mean_stress(stress);
    double square = 0;
    for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) {
            const double s = 0.5 * (stress(a, b) + stress(b, a)) - (a == b ? p : 0);
            square += s * s;
        }
    }
    return std::sqrt(1.5 * square);
}

Vec3 strain(const World& world) {
    return cell::axial_strains(world.reference_h, world.cell.h);
}

} // namespace suffuse::dem
