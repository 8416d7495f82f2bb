#pragma once
// Materials under every law of the table, for the tests that each law has to pass unasked.

#include "suffuse/contact/springs.hpp"

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

namespace suffuse::grains {

/// For messages of tests.
inline std::ostream& operator<<(std::ostream& out, const Material& material) {
    return out << "a material under " << contact::spring_of(material).words.name;
}

} // namespace suffuse::grains

namespace suffuse::test {

/// Under each law as it is by default but for a modulus of its own, and with another value of each key of its own.
inline std::vector<grains::Material> every_law() {
    std::vector<grains::Material> materials;
    for (const contact::Spring& spring : contact::springs) {
        grains::Material usual;
        usual.law = spring.law;
        usual.modulus = 2e9;
        materials.push_back(usual);
        grains::list_members(usual, [&](const grains::Member& member, const auto&) {
            if (!has_own(spring, member.name)) {
                return;
            }
            grains::Material other = usual;
            grains::list_members(other, [&](const grains::Member& same, auto& value) {
                if constexpr (std::is_same_v<decltype(value), double&>) {
                    value *= std::string_view(same.name) == member.name ? 0.9 : 1;
                }
            });
            materials.push_back(other);
        });
    }
    return materials;
}

/// A name for the test of one of them: "hertz_mindlin_2".
inline std::string law_test_name(const ::testing::TestParamInfo<grains::Material>& test) {
    std::string name(contact::spring_of(test.param).words.name);
    for (char& letter : name) {
        letter = letter == '-' ? '_' : letter;
    }
    return name + "_" + std::to_string(test.index);
}

} // namespace suffuse::test
