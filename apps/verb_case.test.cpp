// The verbs on cases, as a user calls them: new, check, plan, explain.

#include "tests/support/program.hpp"

namespace suffuse {
namespace {

using namespace test;

TEST_F(Cli, ExplainsKeysCodesFiguresAndCriteria) {
    for (const auto& [word, part] : std::vector<std::pair<std::string, std::string>>{
             {"contact.modulus", "356 MPa"},
             {"E310", "unit"},
             {"conventions", "compression positive"},
             {"figure-9", "`detach` stage"},
             {"9", "Figure 9"},
             {"own-rules", "agree"},
             {"kezdi-1979", "<= 4"}}) {
        const ProgramResult result = run_suffuse({"explain", word});
        EXPECT_EQ(result.code, 0) << word;
        expect_in(part, result.out);
        EXPECT_LE(std::count(result.out.begin(), result.out.end(), '\n'), 24) << word;
    }
    expect_in("figure-12", run_suffuse({"explain", "figur-12"}).error);
}

TEST_F(Cli, NewCheckAndPlanWorkOnEveryTemplate) {
    for (const auto& entry : std::filesystem::directory_iterator(examples)) {
        const std::string name = entry.path().filename();
        if (!std::filesystem::exists(entry.path() / "case.toml")) {
            continue; // scripts, not a case
        }
        const ProgramResult made = run_suffuse({"new", name, "--from", name});
        ASSERT_EQ(made.code, 0) << made.error;
        expect_in(name + "/case.toml", made.out);
        for (const auto& file : std::filesystem::directory_iterator(entry.path())) {
            if (const std::filesystem::path& path = file.path(); path.extension() == ".toml") {
                EXPECT_TRUE(read_all(folder / name / path.filename()) == read_all(path)) << path;
            }
        }
        EXPECT_EQ(run_suffuse({"check", name + "/case.toml"}).code, 0);
        const ProgramResult plan = run_suffuse({"plan", name + "/case.toml", "--json"});
        ASSERT_EQ(plan.code, 0) << plan.error;
        EXPECT_GT(plan.json().at("stages").size(), 3U);
        EXPECT_GT(plan.json().at("seconds").at(1), plan.json().at("seconds").at(0));
        EXPECT_EQ(run_suffuse({"new", name, "--from", name}).code, 2); // nothing is overwritten
    }
}

TEST_F(Cli, APlanUntilAStageCostsWhatARunUntilItDoes) {
    run_suffuse({"new", "soil", "--from", "replay"});
    const ProgramResult all = run_suffuse({"plan", "soil/case.toml", "--json"});
    const ProgramResult part = run_suffuse({"plan", "soil/case.toml", "--json", "--until", "start"});
    ASSERT_EQ(part.code, 0) << part.error;
    const nlohmann::json stages = part.json().at("stages");
    EXPECT_EQ(stages.back().at("stage"), "start");
    EXPECT_LT(stages.size(), all.json().at("stages").size());
    EXPECT_LT(part.json().at("steps").at(1), all.json().at("steps").at(1));
    EXPECT_EQ(part.json().at("samples").at(0).at("stages"), stages.size());
    const ProgramResult wrong = run_suffuse({"plan", "soil/case.toml", "--until", "sepe"});
    EXPECT_EQ(wrong.code, 2);
    EXPECT_EQ(wrong.error, run_suffuse({"run", "soil/case.toml", "--until", "sepe"}).error);
}

TEST_F(Cli, ErrorsOfACaseAreCodeThreeWithFileAndLine) {
    struct Slip {
        std::string what, with, line, part;
    };

    for (const Slip& slip : std::vector<Slip>{
             {R"("356 MPa")", "356e6", "case.toml:10:", "kPa"},
             {R"("2600 kg/m^3")", R"("-2600 kg/m^3")", "case.toml:6:", "above 0"},
             {R"(pressure = "100 kPa")", "pressure = 100", "case.toml:33:", "100 kPa"},
             {R"(pressure = "100 kPa")", R"(pressure = "100 mm")", "case.toml:33:", "pressure"},
             {"shear_ratio       = 0.42", "shear_ratoi       = 0.42", "case.toml:11:", "shear_ratio"},
             {"shear_ratio       = 0.42", "shear_ratio       = nan", "case.toml:11:", "finite"},
             {R"(do      = "import")", R"(do      = "improt")", "case.toml:", "import"},
             {R"("packing.csv")", R"("nothing.csv")", "case.toml:", "nothing.csv"},
             {"schema = 1", "schema = \xef\xbb\xca", "case.toml:2:", ""},
             {"[study.replay]\n", "[.a]\n", "case.toml:", ""},
         }) {
        const ProgramResult result = check_with(slip.what, slip.with);
        EXPECT_EQ(result.code, 3) << slip.with << ": " << result.error;
        expect_in(slip.line, result.error);
        expect_in(slip.part, result.error);
    }
}

TEST_F(Cli, BadGradingsAreCodeThreeWithFileAndLine) {
    struct Slip {
        std::string what, with, part;
    };

    const std::string good = read_all(examples + "fontainebleau-2016/data/fontainebleau.csv");
    write_to(folder / "case.toml", read_all(examples + "fontainebleau-2016/case.toml"));
    for (const Slip& slip : std::vector<Slip>{
             {"0.21,50", "0.21,20", "fontainebleau.csv:"},
             {"0.21,50", "-0.21,50", "fontainebleau.csv:"},
             {"0.21,50", "0.21,nan", "fontainebleau.csv:"},
             {"0.21,50", "0.21,150", "fontainebleau.csv:"},
             {good, "", "fontainebleau.csv"},
         }) {
        write_to(folder / "data/fontainebleau.csv", replaced(good, slip.what, slip.with));
        const ProgramResult result = run_suffuse({"check", "case.toml"});
        EXPECT_EQ(result.code, 3) << slip.with << ": " << result.error;
        expect_in(slip.part, result.error);
    }
    write_to(folder / "data/fontainebleau.csv", good);
    const ProgramResult small = run_suffuse({"check", "case.toml", "--set", "study.erosion.particles=20"});
    EXPECT_EQ(small.code, 3) << small.error;
    expect_in("grains", small.error);
}

} // namespace
} // namespace suffuse
