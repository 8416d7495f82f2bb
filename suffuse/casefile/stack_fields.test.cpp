// Layers of a pack: what makes no stack, and what has no meaning in one.

#include "suffuse/casefile/stack_fields.hpp"

#include "suffuse/casefile/case_for_tests.hpp"
#include "suffuse/casefile/dependencies.hpp"

#include <gtest/gtest.h>

namespace suffuse::casefile {
namespace {

using namespace testing;

/// A base and a filter that are good; a test puts something wrong into it.
const std::string stack_case = R"(schema = 1
[gravity]
down = "z"
[soil.base]
psd = { d = ["0.18 mm", "0.22 mm"], passing = ["0 %", "100 %"] }
grading_tolerance = "10 %"
[soil.filter]
psd = { d = ["0.54 mm", "0.66 mm"], passing = ["0 %", "100 %"] }
grading_tolerance = "10 %"
[study.s]
[[study.s.stage]]
name = "cloud"
do = "pack"
layers = [{ soil = "base", thickness = "0.9 mm" }, { soil = "filter", thickness = "2 mm" }]
width = "2 mm"
[[study.s.stage]]
name = "initial"
do = "compact"
pressure = "100 kPa"
)";

const std::string flow_in_stack =
    "[[study.s.stage]]\nname = \"flow\"\ndo = \"migrate\"\ngradients = [1]\ndirection = \"z\"\n";

TEST(Layers, AreReadInTheOrderOfTheFlowWithNeitherSoilNorParticles) {
    const Case value = load(stack_case + flow_in_stack);
    const Variant& variant = value.studies.front().variants.front();
    const auto& pack = std::get<packing::PackSpec>(variant.stages.front().spec);
    ASSERT_EQ(pack.layers.size(), 2U);
    EXPECT_EQ(pack.layers[0].soil, "base");
    EXPECT_NEAR(pack.layers[1].thickness, 2e-3, 1e-15);
    EXPECT_NEAR(*pack.width, 2e-3, 1e-15);
    EXPECT_EQ(pack.axis, 2);
    EXPECT_EQ(pack.porosity, packing::stack_porosity);
    EXPECT_EQ(stack_of(variant, variant.stages.back()), &pack);
    EXPECT_EQ(stack_of(load(good_case).studies.front().variants.front(), Stage{}), nullptr);
}

TEST(Layers, OfAnotherSoilAreAnotherSample) {
    const auto key = [](const std::string& text) {
        const Case value = load(text);
        const Variant& variant = value.studies.front().variants.front();
        return dependencies_of(value, variant, variant.stages.front());
    };
    EXPECT_EQ(key(stack_case), key(stack_case + flow_in_stack));
    EXPECT_NE(key(stack_case), key(replaced(stack_case, "0.66 mm", "0.65 mm")));
    EXPECT_NE(key(stack_case), key(replaced(stack_case, "\"0.9 mm\"", "\"0.95 mm\"")));
}

struct Wrong {
    std::string from, to, code, message, help;
};

void expect_refused(const Wrong& wrong, const std::string& text) {
    SCOPED_TRACE(wrong.to);
    const Diagnostic found = find_problem(problems_of(replaced(text, wrong.from, wrong.to)), wrong.code);
    EXPECT_NE(found.message.find(wrong.message), std::string::npos) << found.message;
    EXPECT_NE(found.help.find(wrong.help), std::string::npos) << found.help;
    EXPECT_GT(found.line, 0) << "it says where";
}

TEST(Layers, ThatMakeNoStackAreRefusedWithTheirPlaceAndAdvice) {
    const std::vector<Wrong> all{
        {"\"0.9 mm\"", "\"0.5 mm\"", "E619", "of its largest grains thick", "at least 3"},
        {"\"2 mm\" }", "\"1.5 mm\" }", "E619", "of its largest grains thick", "at least 3"},
        {"width = \"2 mm\"", "width = \"1.5 mm\"", "E619", "of its largest grains wide", "at least 3"},
        {"soil = \"filter\", thickness", "soil = \"gravel\", thickness", "E402", "the soil \"gravel\"", "base, filter"},
        {"\"0.54 mm\", \"0.66 mm\"", "\"0.1 mm\", \"0.12 mm\"", "E620", "is finer than \"base\" before it", "exchange"},
        {"width = \"2 mm\"\n", "", "E201", "`layers` and no `width`", "width = "},
        {", { soil = \"filter\", thickness = \"2 mm\" }", "", "E207", "has one layer", "two or more"},
        {"layers = [{ soil = \"base\", thickness = \"0.9 mm\" }, { soil = \"filter\", thickness = \"2 mm\" }]\n", "",
         "E207", "gives `width` and no `layers`", "leave it out"},
        {"[study.s]\n", "[study.s]\nparticles = 100\n", "E207", "packs layers, and gives `particles`", "leave it out"},
        {"[study.s]\n", "[study.s]\nsoil = \"base\"\n", "E207", "packs layers, and gives `soil`", "leave it out"},
        {"grading_tolerance = \"10 %\"\n[study", "grading_tolerance = \"0.1 %\"\n[study", "E606",
         "the layer \"filter\"", "`width`"}};
    for (const Wrong& wrong : all) {
        expect_refused(wrong, stack_case);
    }
}

TEST(Layers, HaveNoStageThatShearsThemOrWashesOutFinesOfOneSoil) {
    const std::string shear = "[[study.s.stage]]\nname = \"x\"\ndo = \"shear\"\nstrain = \"1 %\"\n";
    const std::string erode = "[[study.s.stage]]\nname = \"x\"\ndo = \"erode\"\n";
    const std::string again = replaced(flow_in_stack, "name = \"flow\"", "name = \"again\"");
    const std::string cell = "pressure = \"100 kPa\"\n";
    const std::vector<Wrong> all{
        {flow_in_stack, shear, "E621", "shears the cell", "right-angled"},
        {cell, cell + "shear_stresses = \"released\"\n", "E621", "shears the cell", "\"kept\""},
        {flow_in_stack, erode, "E621", "through a skeleton of the same soil", "do = \"migrate\""},
        {"direction = \"z\"", "direction = \"x\"", "E621", "does not go along +z", "`direction`"},
        {"direction = \"z\"", "direction = \"-z\"", "E621", "does not go along +z", "[gravity]"},
        {"direction = \"z\"", "direction = \"z\"\nskeleton = \"moves\"", "E621", "its skeleton moves", "\"held\""},
        {flow_in_stack, flow_in_stack + again, "E621", "its base has migrated before", "list all gradients"}};
    for (const Wrong& wrong : all) {
        expect_refused(wrong, stack_case + flow_in_stack);
    }
}

} // namespace
} // namespace suffuse::casefile
