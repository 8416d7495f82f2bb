#include "suffuse/run/assumed_values.hpp"

#include <gtest/gtest.h>

namespace suffuse::run {
namespace {

TEST(AssumedValues, CarryTheirTableAndTheirStage) {
    const auto values = assumed_values(R"(# `#~` marks = a choice
seed = 2016
[grain]
density = "2600 kg/m^3"               #~
[contact]
friction = "37 deg" # from the paper
modulus  = "356 MPa" #~ kn = 2 E r1 r2/(r1 + r2)
[[study.erosion.stage]]
name     = "initial"
pressure = "100 kPa"                  #~
[[study.erosion.stage]]
porosity = 0.65 #~
)");
    ASSERT_EQ(values.size(), 4U);
    EXPECT_EQ(values[0].key, "grain.density");
    EXPECT_EQ(values[0].value, "\"2600 kg/m^3\"");
    EXPECT_EQ(values[1].key, "contact.modulus");
    EXPECT_EQ(values[1].note, "kn = 2 E r1 r2/(r1 + r2)");
    EXPECT_EQ(values[2].key, "study.erosion, stage initial: pressure");
    EXPECT_EQ(values[3].key, "study.erosion: porosity") << "the name of the stage before is not its own";
}

TEST(AssumedValues, ACaseWithoutMarksHasNone) {
    EXPECT_TRUE(assumed_values("").empty());
    EXPECT_TRUE(assumed_values("[a]\nb = 1\n").empty());
}

} // namespace
} // namespace suffuse::run
