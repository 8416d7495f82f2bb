#include "suffuse/record/result_json.hpp"

#include <gtest/gtest.h>

#include "tests/support/laws.hpp"
#include <type_traits>

namespace suffuse::grains {
namespace {

TEST(ResultJson, HoldsEveryMemberOfAMaterialUnderEveryLaw) {
    for (Material material : test::every_law()) {
        double value = 0.1;
        list_members(material, [&](const Member&, auto& number) {
            if constexpr (std::is_same_v<decltype(number), double&>) {
                number = value += 1.0 / 3; // another one each
            }
        });
        const nlohmann::json json = material;
        const Material back = json.get<Material>();
        std::size_t members = 0;
        list_members(material, [&](const Member& member, const auto& wanted) {
            ++members;
            list_members(back, [&](const Member& same, const auto& found) {
                if constexpr (std::is_same_v<decltype(found), decltype(wanted)>) {
                    if (std::string_view(same.name) == member.name) {
                        EXPECT_EQ(found, wanted) << member.name;
                    }
                }
            });
            nlohmann::json without = json;
            without.erase(member.name);
            EXPECT_THROW(static_cast<void>(without.get<Material>()), nlohmann::json::exception); // whole or not at all
        });
        EXPECT_EQ(json.size(), members);
    }
}

} // namespace
} // namespace suffuse::grains
