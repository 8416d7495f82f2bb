#include "suffuse/dem/given_contacts.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/contact/linear_rolling.hpp"
#include "suffuse/contact/stress.hpp"
#include "suffuse/dem/first_contacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace suffuse::dem {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>; // of rows, the smaller first

Pair pair_of(std::uint32_t a, std::uint32_t b) {
    return std::minmax(a, b);
}

[[noreturn]] void refuse(const Pair& pair, const char* what) {
    throw CaseError(fmt::format("contact of grains {} and {} (counted from 0): {}", pair.first, pair.second, what));
}

std::map<Pair, const GivenContact*> by_pair(std::span<const GivenContact> given) {
    std::map<Pair, const GivenContact*> found;
    for (const GivenContact& contact : given) {
        const Pair pair = pair_of(contact.first, contact.second);
        if (!found.emplace(pair, &contact).second) {
            refuse(pair, "given twice, expected once");
        }
    }
    return found;
}

/// Forces and moments are stored as they act on the second grain.
void remember(World& world, std::size_t c, const GivenContact& given) {
    contact::Contacts& contacts = world.contacts;
    grains::Grains& grains = world.grains;
    const std::uint32_t first = contacts.first[c], second = contacts.second[c];
    const double sign = given.first == first ? -1 : 1;
    const Vec3 n = contacts.normal[c];
    const Vec3 shear = sign * (given.shear_force - dot(given.shear_force, n) * n), moment = sign * given.moment;
    const Vec3 twisting = dot(moment, n) * n, bending = moment - twisting;
    contacts.shear_force.set(c, shear);
    contacts.bending.set(c, bending);
    if (contacts.twisting.size() > 0) {
        contacts.twisting.set(c, twisting);
    }
    grains.force[first] -= shear;
    grains.force[second] += shear;
}

void note_cut(TakenContacts& taken, const World& world, std::size_t c, const GivenContact& given) {
    const double push = contact::normal_force(world.grains, world.contacts, world.material, c);
    const double limit = std::max(0.0, contact::resolve_law(world.material).tan_friction * push);
    const double shear = norm(world.contacts.shear_force[c]), cut = std::max(0.0, shear - limit);
    taken.borne += shear - cut;
    taken.cut += cut;
    taken.beyond += cut > 0 ? 1 : 0;
    if (cut > taken.worst_cut) {
        taken.worst = given, taken.worst_cut = cut, taken.worst_limit = limit;
    }
}

} // namespace

TakenContacts add_given_contacts(World& world, std::span<const GivenContact> given) {
    std::map<Pair, const GivenContact*> left = by_pair(given);
    add_first_contacts(world);
    contact::Contacts& contacts = world.contacts;
    if (world.material.twisting_stiffness > 0) {
        contacts.twisting.resize(contacts.size());
    }
    TakenContacts taken;
    Pair before{0, 0};
    for (std::size_t c = 0; c < contacts.size(); ++c) { // sorted: images of a pair follow each other
        const Pair pair = pair_of(contacts.first[c], contacts.second[c]);
        const auto found = left.find(pair);
        if (found != left.end()) {
            remember(world, c, *found->second);
            note_cut(taken, world, c, *found->second);
            left.erase(found);
            before = pair;
            ++taken.remembered;
        } else if (taken.remembered > 0 && pair == before) {
            refuse(pair, "it touches twice, across the faces of a narrow cell; which one remembers?");
        } else {
            ++taken.unknown;
        }
    }
    taken.apart = left.size();
    return taken;
}

std::optional<std::string> words_on_cut(const TakenContacts& taken, const std::string& file) {
    constexpr double little = 0.01; // of what friction bears
    if (taken.cut <= little * taken.borne) {
        return {};
    }
    return fmt::format(
        "{}:{}: the shear force of grains {} and {} is {:.3g} N, and friction bears {:.3g} N there; the first step "
        "cuts it, and those of {} of {} contacts in all. Check that forces are in N, and that `friction` is that of "
        "the packing",
        file, taken.worst.line, taken.worst.first, taken.worst.second, taken.worst_limit + taken.worst_cut,
        taken.worst_limit, taken.beyond, taken.remembered
    );
}

} // namespace suffuse::dem
