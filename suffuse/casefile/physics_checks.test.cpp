#include "suffuse/casefile/physics_checks.hpp"

#include "suffuse/casefile/case_for_tests.hpp"
#include "suffuse/contact/springs.hpp"

#include <gtest/gtest.h>

namespace {

using namespace suffuse;
using namespace suffuse::casefile;
using namespace suffuse::casefile::testing;

// Settled at 100 kPa with 356 MPa, the reference's grains overlap by some thousandths of their radius.
TEST(PhysicsChecks, OverlapIsOfTheRightOrder) {
    EXPECT_GT(contact::mean_overlap_at({}, 1e5), 0.5e-3);
    EXPECT_LT(contact::mean_overlap_at({}, 1e5), 5e-3);
}

TEST(PhysicsChecks, APressureThatSqueezesGrainsIsDoubtfulThenAnError) {
    EXPECT_EQ(problems_of(good_case).size(), 0U);
    EXPECT_EQ(find_problem(problems_of(replaced(good_case, "100 kPa", "2 MPa")), "W603").line, 14);
    const Diagnostic found = find_problem(problems_of(replaced(good_case, "100 kPa", "20 MPa")), "E603");
    EXPECT_EQ(found.column, 12);
    EXPECT_NE(found.help.find("modulus"), std::string::npos);
}

TEST(PhysicsChecks, StressesOfOtherStagesAreCheckedToo) {
    const std::string head = good_case + "[[study.one.stage]]\nname = \"x\"\n";
    EXPECT_EQ(find_problem(problems_of(head + "do = \"settle\"\npressure = \"20 MPa\"\n"), "E603").line, 18);
    EXPECT_EQ(
        find_problem(problems_of(head + "do = \"settle\"\nstress = [\"20 MPa\", \"-\", \"-\"]\n"), "E603").line, 18
    );
}

TEST(PhysicsChecks, StressesThatATestComesToAreChecked) {
    const std::string head = good_case + "[[study.one.stage]]\nname = \"x\"\n";
    for (const char* verb : {"oedometer", "isotropic"}) {
        const std::string text = head + "do = \"" + verb + "\"\nstresses = [\"200 kPa\", \"20 MPa\"]\n";
        EXPECT_EQ(find_problem(problems_of(text), "E603").line, 18) << verb;
        EXPECT_EQ(problems_of(replaced(text, "20 MPa", "400 kPa")).size(), 0U);
    }
    EXPECT_EQ(find_problem(problems_of(head + "do = \"triaxial\"\ndeviator_stress = \"20 MPa\"\n"), "E603").line, 18);
}

TEST(PhysicsChecks, SkemptonsBNeedsTheStiffnessOfTheFluid) {
    const std::string stage = "[[study.one.stage]]\nname = \"x\"\ndo = \"stiffness\"\nmeasure = [\"skempton-b\"]\n";
    const Diagnostic found = find_problem(problems_of(good_case + stage), "E207");
    EXPECT_EQ(found.line, 18);
    EXPECT_NE(found.help.find("2.2 GPa"), std::string::npos);
    const std::string fluid = "[fluid]\nbulk_modulus = \"2.2 GPa\"\n";
    EXPECT_EQ(problems_of(good_case + stage + fluid).size(), 0U);
    const std::string test = "[[study.one.stage]]\nname = \"x\"\ndo = \"triaxial\"\nmeasure = [\"skempton-b\"]\n";
    EXPECT_NE(
        find_problem(problems_of(good_case + test + fluid), "E207").message.find("its test is not undrained"),
        std::string::npos
    );
    EXPECT_EQ(problems_of(good_case + test + "path = \"undrained\"\n" + fluid).size(), 0U);
}

TEST(PhysicsChecks, ADensityThatIsOffByAThousandIsDoubtful) {
    for (const char* const bad :
         {"[fluid]\ndensity = \"1 kg/m^3\"\n", "[fluid]\ndensity = \"2500 kg/m^3\"\n",
          "[grain]\ndensity = \"2.65 kg/m^3\"\n"}) {
        const Diagnostic found = find_problem(problems_of(good_case + bad), "W622");
        EXPECT_TRUE(found.is_warning) << bad;
        EXPECT_EQ(found.line, 16) << bad;
    }
    for (const char* const good :
         {"[fluid]\ndensity = \"1 g/cm^3\"\n", "[fluid]\ndensity = \"800 kg/m^3\"\n",
          "[grain]\ndensity = \"1050 kg/m^3\"\n"}) {
        EXPECT_EQ(find_problem(problems_of(good_case + good), "W622").code, "") << good;
    }
}

TEST(PhysicsChecks, AGradientAboveTheCriticalOneIsDoubtful) {
    const std::string head = good_case + "[[study.one.stage]]\nname = \"x\"\ndo = \"flow\"\n";
    EXPECT_EQ(problems_of(head + "gradient = 0.9\n").size(), 0U);
    EXPECT_TRUE(find_problem(problems_of(head + "gradient = 1.1\n"), "W604").is_warning);
    EXPECT_EQ(find_problem(problems_of(head + "gradient = -1.1\n"), "W604").line, 18);
    const Diagnostic light =
        find_problem(problems_of(head + "gradient = 0.1\n[grain]\ndensity = \"2.65 kg/m^3\"\n"), "W604");
    EXPECT_NE(light.message.find("grains of 2.65 kg/m^3 do not sink"), std::string::npos) << light.message;
}

TEST(PhysicsChecks, AResolvedFlowTakesNoCellThatReleasedItsShearStresses) {
    const auto settled = [](const std::string& shear_stresses) {
        return good_case + "[[study.one.stage]]\nname = \"s\"\ndo = \"settle\"\npressure = \"100 kPa\"\n" +
               "shear_stresses = \"" + shear_stresses +
               "\"\n[[study.one.stage]]\nname = \"x\"\ndo = \"flow\"\ngradient = 0.1\n";
    };
    EXPECT_EQ(find_problem(problems_of(settled("released") + "resolve = 8\n"), "E207").line, 24);
    EXPECT_EQ(problems_of(settled("kept") + "resolve = 8\n").size(), 0U);
    EXPECT_EQ(problems_of(settled("released")).size(), 0U);
}

TEST(PhysicsChecks, AProbeHasOneFlow) {
    const std::string probe = good_case + "[[study.one.stage]]\nname = \"p\"\ndo = \"detach\"\n";
    EXPECT_EQ(problems_of(probe + "resolve = 8\n").size(), 0U);
    EXPECT_EQ(problems_of(probe + "solver = \"auto\"\nresolve = 8\n").size(), 0U);
    EXPECT_EQ(find_problem(problems_of(probe + "solver = \"network\"\nresolve = 8\n"), "E207").line, 18);
    const std::string flow = good_case + "[[study.one.stage]]\nname = \"f\"\ndo = \"flow\"\ngradient = 0.1\n";
    EXPECT_EQ(problems_of(flow + "solver = \"network\"\nresolve = 8\n").size(), 0U); // both, side by side
}

TEST(PhysicsChecks, TestsAndErosionNeedASampleThatCarriesAStress) {
    const std::string test = "[[study.one.stage]]\nname = \"x\"\ndo = \"triaxial\"\n";
    EXPECT_EQ(problems_of(good_case + test).size(), 0U);
    EXPECT_EQ(find_problem(problems_of(good_case + test + "from = \"cloud\"\n"), "E608").line, 17);
    const std::string import = R"(schema = 1
[[study.one.stage]]
name = "packing"
do = "import"
packing = "packing.csv"
cell = ["1 cm", "1 cm", "1 cm"]
)";
    const Diagnostic found = find_problem(problems_of(import + test), "E608");
    EXPECT_EQ(found.line, 9);
    EXPECT_NE(found.help.find("`contacts`"), std::string::npos);
    const std::string forces = "contacts = \"contacts.csv\"\n";
    EXPECT_EQ(find_problem(problems_of(import + forces + test), "E608").code, "") << "it brings its shear forces";
    const std::string probe = "[[study.one.stage]]\nname = \"x\"\ndo = \"detach\"\n";
    EXPECT_EQ(find_problem(problems_of(import + probe), "E608").code, ""); // it may carry its contacts
    for (const std::string verb : {"detach", "erode", "remove"}) {
        const std::string stage = "[[study.one.stage]]\nname = \"x\"\nfrom = \"cloud\"\ndo = \"" + verb + "\"\n";
        EXPECT_EQ(find_problem(problems_of(good_case + stage), "E608").line, 18) << verb;
    }
}

TEST(PhysicsChecks, ErosionNeedsFines) {
    EXPECT_EQ(problems_of(good_case + erode_stage).size(), 0U);
    EXPECT_EQ(
        find_problem(problems_of(replaced(good_case, "fines = { finer_than = \"0.15 mm\" }", "") + erode_stage), "E605")
            .line,
        17
    );
    const std::string two = replaced(
        replaced(
            good_case, "fines = { finer_than = \"0.15 mm\" }",
            "fines = { psd = \"data/silt.csv\" }\nfines_content = 0.0"
        ),
        "psd = \"data/sand.csv\"", "coarse = { psd = \"data/sand.csv\" }"
    );
    EXPECT_TRUE(find_problem(problems_of(two + erode_stage), "W605").is_warning);
    // Of a packing from elsewhere, too: Kenney and Lau do not split this sand.
    const std::string imported = replaced(
        replaced(good_case, "{ finer_than = \"0.15 mm\" }", "\"kenney-lau\""), "do = \"pack\"",
        "do = \"import\"\npacking = \"packing.csv\"\ncell = [\"1 mm\", \"1 mm\", \"1 mm\"]"
    );
    EXPECT_NE(
        find_problem(problems_of(replaced(imported, "compact", "settle") + erode_stage), "E605")
            .message.find("split does not exist"),
        std::string::npos
    );
}

TEST(PhysicsChecks, AWayToTravelIsWarnedOfWhereGrainsDoNotTravel) {
    const auto with = [](const std::string& keys) { return problems_of(good_case + erode_stage + keys); };
    const std::string size = "passes_constriction = { size = \"flow-path\", distance = \"5 mm\" }\n";
    EXPECT_EQ(find_problem(with(size), "W613").code, "");
    const Diagnostic found =
        find_problem(with("passes_constriction = { size = \"mean\", distance = \"5 mm\" }\n"), "W613");
    EXPECT_TRUE(found.is_warning) << found.message;
    EXPECT_EQ(found.line, 18);
    EXPECT_TRUE(find_problem(with(size + "forced = {}\n"), "W613").is_warning);
}

TEST(PhysicsChecks, AFrictionThatASearchReplacesIsWarnedOf) {
    const auto with = [](const std::string& keys) {
        return problems_of(replaced(good_case, "pressure =", keys + "\npressure ="));
    };
    const std::string friction = "prepare = { friction = \"10 deg\" }", search = "\nvoid_ratio = 0.6";
    const Diagnostic found = find_problem(with(friction + search), "W611");
    EXPECT_TRUE(found.is_warning) << found.message;
    EXPECT_EQ(found.line, 14);
    EXPECT_NE(found.message.find("protocol \"faithful\" searches the friction"), std::string::npos) << found.message;
    EXPECT_TRUE(find_problem(with(friction + "\nintergranular_void_ratio = 0.9"), "W611").is_warning);
    EXPECT_EQ(find_problem(with(friction), "W611").code, "");
    EXPECT_EQ(find_problem(with(search), "W611").code, "");
    EXPECT_EQ(find_problem(with(friction + search + "\nprotocol = \"swift\""), "W611").code, "");
}

} // namespace
