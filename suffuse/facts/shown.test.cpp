#include "suffuse/facts/shown.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/facts/by_key.hpp"
#include "suffuse/facts/every_fact.hpp"

#include <gtest/gtest.h>

namespace suffuse::facts {
namespace {

TEST(Shown, ATitleHasNameSymbolAndUnit) {
    EXPECT_EQ(title("mean_stress"), "mean stress p [kPa]");
    EXPECT_EQ(short_title("mean_stress"), "p [kPa]");
    EXPECT_EQ(title("unbalanced_force"), "unbalanced force [-]");
    EXPECT_EQ(short_title("unbalanced_force"), "unbalanced force [-]");
    EXPECT_THROW(title("state_hash"), Bug) << "which no table shows";
}

TEST(Shown, AValueIsInTheUnitOfItsTitle) {
    EXPECT_EQ(in_unit_shown("mean_stress", 99'800), 99.8);
    EXPECT_EQ(in_unit_shown("axial_strain", 0.07), 100 * 0.07);
    EXPECT_EQ(in_unit_shown("void_ratio", 0.71), 0.71);
    EXPECT_EQ(text_shown("mean_stress", 99'812.3), "99.81");
    EXPECT_EQ(text_shown("unbalanced_force", 0.00123), "0.0012");
}

TEST(Shown, EveryUnitShownHasAConversion) {
    int shown = 0;
    for (const Group& group : every_group()) {
        for (const Fact& fact : group.facts) {
            if (!fact.shown.name.empty()) {
                EXPECT_NO_THROW(in_unit_shown(fact.key, 1)) << fact.key;
                ++shown;
            }
        }
    }
    EXPECT_GT(shown, 8);
}

TEST(Kind, SaysWhatTwoRunsMayDifferIn) {
    EXPECT_EQ(kind_of("void_ratio"), Kind::Result);
    EXPECT_EQ(kind_of("steps"), Kind::Computation);
    EXPECT_EQ(kind_of("wall_seconds"), Kind::Origin);
}

} // namespace
} // namespace suffuse::facts
