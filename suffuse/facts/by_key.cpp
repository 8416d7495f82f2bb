#include "suffuse/facts/by_key.hpp"

#include "suffuse/facts/every_fact.hpp"

#include <algorithm>

namespace suffuse::facts {
namespace {

/// Of each key the first fact that fulfills a condition.
template <class Condition>
std::map<std::string_view, Fact> first_with(Condition condition) {
    std::map<std::string_view, Fact> known;
    for (const Group& group : every_group()) {
        for (const Fact& fact : group.facts) {
            if (condition(fact)) {
                known.emplace(fact.key, fact);
            }
        }
    }
    return known;
}

} // namespace

const std::map<std::string, std::string>& units() {
    static const std::map<std::string, std::string> known = [] {
        std::map<std::string, std::string> made;
        for (const Group& group : every_group()) {
            for (const Fact& fact : group.facts) {
                if ((!fact.unit.empty() && fact.unit != "-") || group.within == columns_of_tables) {
                    made.emplace(fact.key, fact.unit);
                }
            }
        }
        return made;
    }();
    return known;
}

Kind kind_of(const std::string& key) {
    static const auto known = first_with([](const Fact& fact) { return fact.kind != Kind::Result; });
    const auto found = known.find(key);
    return found == known.end() ? Kind::Result : found->second.kind;
}

const Fact* shown_fact(std::string_view key) {
    static const auto known = first_with([](const Fact& fact) { return !fact.shown.name.empty(); });
    const auto found = known.find(key);
    return found == known.end() ? nullptr : &found->second;
}

bool is_fact(const std::string& key) {
    return std::ranges::any_of(every_group(), [&](const Group& group) {
        return std::ranges::any_of(group.facts, [&](const Fact& fact) { return fact.key == key; });
    });
}

} // namespace suffuse::facts
