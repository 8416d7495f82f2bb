#include "suffuse/casefile/stage_traits.hpp"

#include "suffuse/casefile/case_for_tests.hpp"
#include "suffuse/casefile/names.hpp"
#include "suffuse/casefile/stage_list.hpp"
#include "suffuse/casefile/stage_loading.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace {

using namespace suffuse;
using namespace suffuse::casefile;
using suffuse::casefile::testing::full_case;
using suffuse::casefile::testing::keys_of_weight;

TEST(StageTraits, EachSpecHasTheRowOfItsVerb) {
    EXPECT_EQ(traits_of(StageSpec{ImportSpec{}}).verb, "import");
    EXPECT_EQ(traits_of(StageSpec{packing::PackSpec{}}).verb, "pack");
    EXPECT_EQ(traits_of(StageSpec{packing::CompactSpec{}}).verb, "compact");
    EXPECT_EQ(traits_of(StageSpec{dem::SettleSpec{}}).verb, "settle");
    EXPECT_EQ(traits_of(StageSpec{triaxial::TriaxialSpec{}}).verb, "triaxial");
    EXPECT_EQ(traits_of(StageSpec{triaxial::StressProbeSpec{}}).verb, "stress-probe");
    EXPECT_EQ(traits_of(StageSpec{dem::AdvanceSpec{}}).verb, "advance");
    EXPECT_EQ(traits_of(StageSpec{flow::FlowSpec{}}).verb, "flow");
    EXPECT_EQ(traits_of(StageSpec{erosion::DetachStageSpec{}}).verb, "detach");
    EXPECT_EQ(traits_of(StageSpec{erosion::ErodeSpec{}}).verb, "erode");
    EXPECT_EQ(traits_of(StageSpec{erosion::RemoveSpec{}}).verb, "remove");
    EXPECT_EQ(traits_of(StageSpec{erosion::MigrateSpec{}}).verb, "migrate");
    EXPECT_EQ(traits_of(StageSpec{triaxial::StiffnessSpec{}}).verb, "stiffness");
}

TEST(StageTraits, AVerbIsFoundByItsName) {
    for (std::size_t k = 0; k < stage_traits.size(); ++k) {
        EXPECT_EQ(find_verb(stage_traits[k].verb), &stage_traits[k]);
        EXPECT_EQ(names::verbs[k], stage_traits[k].verb);
        EXPECT_EQ(verb_of(default_spec(k)), stage_traits[k].verb);
    }
    EXPECT_EQ(find_verb("wash"), nullptr);
    EXPECT_EQ(find_verb(""), nullptr);
}

TEST(StageTraits, TheRowsAgreeWithThemselves) {
    for (const StageTraits& traits : stage_traits) {
        SCOPED_TRACE(traits.verb);
        EXPECT_FALSE(traits.only_looks && traits.loses_grains);
        EXPECT_FALSE(traits.only_looks && !traits.keeps_path) << "a look changes nothing";
        EXPECT_TRUE(!traits.makes_sample() || traits.needs == Needs::Nothing);
        EXPECT_TRUE(!traits.loses_grains || traits.needs_fines_rule);
        for (const std::string_view measure : traits.measures) {
            EXPECT_TRUE(measure.empty() || std::ranges::count(names::measures, measure) == 1) << measure;
        }
    }
}

std::string text_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// The paragraph or table of a page that begins so; empty where there is none.
std::string part_of(const std::string& page, const std::string& begin) {
    const std::string text = text_of(test::in_checkout(page));
    const std::size_t at = text.find(begin);
    return at == std::string::npos ? "" : text.substr(at, text.find("\n\n", at) - at);
}

TEST(StageTraits, PagesThatListAllVerbsHaveEachOfThem) {
    const std::string resumes = part_of("docs/first-run.md", "| stage | resumes |");
    const std::string history = part_of("docs/formats.md", "`history.csv`: one row");
    for (const StageTraits& traits : stage_traits) {
        const std::string name = fmt::format("`{}`", traits.verb);
        EXPECT_NE(resumes.find(name), std::string::npos) << name << ": docs/first-run.md, where a stage resumes";
        EXPECT_NE(history.find(name), std::string::npos) << name << ": docs/formats.md, rows of history.csv";
    }
}

/// All files below a folder whose names end so.
std::string texts_below(const std::string& folder, std::string_view ending) {
    std::string text;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test::in_checkout(folder))) {
        text += entry.path().string().ends_with(ending) ? text_of(entry.path()) : "";
    }
    return text;
}

TEST(StageTraits, TestsOfAllVerbsHaveEachOfThem) {
    const std::string compared = texts_below("examples", ".toml") + texts_below("tools/same_results", ".toml");
    const std::string scenarios = texts_below("tests/scenarios", ".cpp");
    for (const StageTraits& traits : stage_traits) {
        const std::regex stage(fmt::format(R"(\bdo *= *\\?"{}\\?")", traits.verb));
        EXPECT_TRUE(std::regex_search(full_case + keys_of_weight, stage)) << traits.verb << ": case_for_tests.hpp";
        EXPECT_TRUE(std::regex_search(compared, stage)) << traits.verb << ": tools/same_results/rest.toml";
        EXPECT_TRUE(std::regex_search(scenarios, stage)) << traits.verb << ": a scenario in tests/scenarios/";
    }
}

TEST(StageTraits, AMeasureOfFewVerbsNamesThem) {
    using List = std::vector<std::string>;
    EXPECT_EQ(names::verbs_of_measure("stress-strain"), (List{"triaxial", "plane-strain"}));
    EXPECT_EQ(names::verbs_of_measure("flow"), (List{"flow", "erode"}));
    EXPECT_EQ(names::verbs_of_measure("coordination-of-eroded"), (List{"erode", "remove"}));
    EXPECT_EQ(
        names::verbs_of_measure("volumetric-strain"), (List{
                                                          "compact", "settle", "triaxial", "advance", "erode", "remove",
                                                          "oedometer", "isotropic", "plane-strain", "shear", "cyclic"})
    );
    EXPECT_EQ(names::verbs_of_measure("porosity"), List{}) << "every state has one";
}

TEST(StageLoading, OnlyWhatSettlesUnderANamedLoadingHasOne) {
    packing::CompactSpec compact;
    compact.pressure = 1e5;
    compact.shear_released = true;
    const auto loading = loading_at_end(compact);
    ASSERT_TRUE(loading);
    EXPECT_TRUE(loading->shear_released);
    for (const cell::AxisControl& axis : loading->axis) {
        EXPECT_EQ(axis.control, cell::Control::Stress);
        EXPECT_EQ(axis.value, 1e5);
    }
    for (std::size_t k = 0; k < stage_traits.size(); ++k) {
        const bool names_one = stage_traits[k].verb == "compact" || stage_traits[k].verb == "settle";
        EXPECT_EQ(loading_at_end(default_spec(k)).has_value(), names_one) << stage_traits[k].verb;
    }
}

} // namespace
