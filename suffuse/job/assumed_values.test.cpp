#include "suffuse/job/assumed_values.hpp"

#include <gtest/gtest.h>

namespace suffuse::job {
namespace {

TEST(AssumedValues, CarryTheirTableAndTheirStage) {
    const auto values = assumed_values(
        R"(# `#~` marks = a choice
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
)",
        "standard"
    );
    ASSERT_EQ(values.size(), 4U);
    EXPECT_EQ(values[0].key, "grain.density");
    EXPECT_EQ(values[0].value, "\"2600 kg/m^3\"");
    EXPECT_EQ(values[1].key, "contact.modulus");
    EXPECT_EQ(values[1].note, "kn = 2 E r1 r2/(r1 + r2)");
    EXPECT_EQ(values[2].key, "study.erosion, stage initial: pressure");
    EXPECT_EQ(values[3].key, "study.erosion: porosity") << "the name of the stage before is not its own";
}

TEST(AssumedValues, AreThoseInForceUnderThePresetWithoutOtherComments) {
    const char* const text = R"([presets.quick]
particles       = 2000 #~ few
triaxial_strain = "5 %" #~
[presets.long]
particles = 1_000_000 #~ many
[soil.a]
psd = "data/a#1.csv" # d [mm]; #~ ours
[study.erosion]
particles = 8000 #~ cost grows with it
[[study.erosion.stage]]
name   = "shear"
strain = "10 %" #~
)";
    const auto quick = assumed_values(text, "quick"), standard = assumed_values(text, "standard");
    ASSERT_EQ(quick.size(), 3U);
    EXPECT_EQ(quick[0].value, "2000");
    EXPECT_EQ(quick[1].key, "presets.quick.triaxial_strain");
    EXPECT_EQ(quick[2].value, "\"data/a#1.csv\"");
    EXPECT_EQ(quick[2].note, "ours");
    ASSERT_EQ(standard.size(), 3U);
    EXPECT_EQ(standard[1].value, "8000");
    EXPECT_EQ(standard[2].value, "\"10 %\"");
}

TEST(AssumedValues, WhatIsSetOnTheCommandLineIsNoMoreAssumedByTheCase) {
    const char* const text = R"([study.erosion]
particles = 8000 #~ cost grows with it
[[study.erosion.stage]]
name     = "initial"
pressure = "100 kPa" #~
prepare  = { friction = "10 deg" } #~
[[study.erosion.stage]]
name     = "other"
pressure = "100 kPa" #~
)";
    const auto values = assumed_values(
        text, "standard",
        {"study.erosion.particles=4000", "study.erosion.stage.initial.pressure = 200 kPa",
         "study.erosion.stage.initial.prepare.friction=5 deg"}
    );
    ASSERT_EQ(values.size(), 1U);
    EXPECT_EQ(values[0].key, "study.erosion, stage other: pressure");
}

TEST(AssumedValues, AreThoseOfTheStudiesThatWereRun) {
    const char* const text = R"([contact]
modulus = "356 MPa" #~
[study.fines]
particles = 8000 #~
[[study.fines-again.stage]]
porosity = 0.65 #~
)";
    const auto values = assumed_values(text, "standard", {}, {"fines"});
    ASSERT_EQ(values.size(), 2U);
    EXPECT_EQ(values[1].key, "study.fines.particles");
    EXPECT_EQ(assumed_values(text, "standard").size(), 3U);
}

TEST(AssumedValues, ACaseWithoutMarksHasNone) {
    EXPECT_TRUE(assumed_values("", "quick").empty());
    EXPECT_TRUE(assumed_values("[a]\nb = 1\n", "quick").empty());
}

} // namespace
} // namespace suffuse::job
