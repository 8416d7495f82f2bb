// Cases under every law of the table, unasked: its keys are read, written back and documented, another law's refused.

#include "suffuse/contact/springs.hpp"

#include "suffuse/casefile/case_for_tests.hpp"
#include "suffuse/casefile/names.hpp"
#include "suffuse/casefile/schema.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/laws.hpp"
#include <type_traits>

namespace suffuse::casefile {
namespace {

using namespace testing;

class LawOfACase : public ::testing::TestWithParam<grains::Material> {
protected:
    const grains::Material& material = GetParam();
    const contact::Spring& spring = contact::spring_of(material);

    /// [contact] with the law, what it needs and its own keys at the values of the material.
    [[nodiscard]] std::string contact_table() const {
        std::string text = fmt::format("[contact]\nlaw = \"{}\"\n", spring.words.name);
        for_each_number([&](const std::string& name, double value) {
            if (name == "modulus" || has_own(spring, name)) {
                text += name + " = " + written(name, value) + "\n";
            }
        });
        return text;
    }

    static std::string written(const std::string& name, double value) {
        const Key* key = find_key("contact", name);
        return key->kind == ValueKind::Quantity ? "\"" + print_quantity(value, key->dimension) + "\""
                                                : fmt::format("{}", value);
    }

    template <class Use>
    void for_each_number(const Use& use) const {
        grains::list_members(material, [&](const grains::Member& member, const auto& value) {
            if constexpr (std::is_same_v<decltype(value), const double&>) {
                use(std::string(member.name), value);
            }
        });
    }
};

INSTANTIATE_TEST_SUITE_P(EveryLaw, LawOfACase, ::testing::ValuesIn(test::every_law()), test::law_test_name);

TEST_P(LawOfACase, IsReadWithItsKeys) {
    const std::string text = good_case + contact_table();
    EXPECT_TRUE(problems_of(text).empty()) << render(problems_of(text));
    const grains::Material found = load(text).material;
    EXPECT_EQ(found.law, material.law);
    for_each_number([&](const std::string& name, double value) {
        grains::list_members(found, [&](const grains::Member& member, const auto& read) {
            if constexpr (std::is_same_v<decltype(read), const double&>) {
                if (name == member.name && (name == "modulus" || has_own(spring, name))) {
                    EXPECT_DOUBLE_EQ(read, value) << name;
                }
            }
        });
    });
}

TEST_P(LawOfACase, RefusesTheKeysOfOtherLaws) {
    for_each_number([&](const std::string& name, double value) {
        const bool of_others =
            !contact::laws_where([&](const contact::Spring& other) { return has_own(other, name); }).empty();
        if (!of_others || has_own(spring, name)) {
            return;
        }
        const Diagnostic found =
            find_problem(problems_of(good_case + contact_table() + name + " = " + written(name, value)), "E207");
        EXPECT_EQ(found.message, fmt::format("the law \"{}\" has no `{}`", spring.words.name, name));
        EXPECT_NE(found.help, "");
    });
}

TEST_P(LawOfACase, RequestsWhatItNeeds) {
    for (const contact::NeededKey& key : spring.words.needs) {
        const std::string text = fmt::format("[contact]\nlaw = \"{}\"\n", spring.words.name);
        const Diagnostic found = find_problem(problems_of(good_case + text), "E201");
        EXPECT_EQ(found.message, fmt::format("the law \"{}\" needs {}", spring.words.name, key.what));
        EXPECT_NE(find_key("contact", key.name), nullptr);
    }
}

TEST_P(LawOfACase, AdheresOnlyWhereItMay) {
    const std::string text = good_case + contact_table() + "adhesion = { normal = \"1 MPa\" }\n";
    if (spring.may_adhere) {
        EXPECT_TRUE(problems_of(text).empty()) << render(problems_of(text));
    } else {
        EXPECT_NE(find_problem(problems_of(text), "E207").message.find("do not adhere"), std::string::npos);
    }
}

TEST_P(LawOfACase, HasItsNameAndKeysInTheReference) {
    EXPECT_EQ(names::word_for(names::law, material.law), spring.words.name);
    EXPECT_NE(find_key("contact", "law")->text.find(spring.words.name), std::string::npos);
    EXPECT_NE(find_key("contact", "modulus")->text.find(spring.words.name), std::string::npos);
    for_each_number([&](const std::string& name, double) {
        if (has_own(spring, name)) {
            ASSERT_NE(find_key("contact", name), nullptr) << name;
            EXPECT_NE(find_key("contact", name)->text.find(spring.words.name), std::string::npos) << name;
        }
    });
}

} // namespace
} // namespace suffuse::casefile
