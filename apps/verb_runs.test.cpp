// runs as a user calls it.

#include "tests/support/program.hpp"

namespace suffuse {
namespace {

using namespace test;

TEST_F(Cli, RunsListsAFolderAndSaysHowToCompareTwoOfThem) {
    for (const char* name : {"a-0001", "b-0001"}) {
        write_to(folder / "runs" / name / "case.resolved.toml", "schema = 1\n");
        write_to(
            folder / "runs" / name / "summary.json",
            R"({"title": "Dyke", "samples": {"total": 2, "done": 2}, "answer": {"verdict": ["It holds."]}})"
        );
    }
    const ProgramResult listed = run_suffuse({"runs", "--sort", "name"});
    EXPECT_EQ(listed.code, 0) << listed.error;
    EXPECT_LT(listed.out.find("a-0001"), listed.out.find("b-0001"));
    EXPECT_NE(listed.out.find("It holds."), std::string::npos) << listed.out;
    EXPECT_NE(listed.error.find("suffuse compare runs/a-0001 runs/b-0001"), std::string::npos) << listed.error;
    const ProgramResult listed_json = run_suffuse({"runs", "--json"});
    EXPECT_EQ(listed_json.json()["runs"].size(), 2U);
    EXPECT_EQ(listed_json.json()["runs"][0]["state"], "done");
    std::filesystem::copy(folder / "runs", folder / "my runs", std::filesystem::copy_options::recursive);
    expect_in(
        "suffuse compare 'my runs/a-0001' 'my runs/b-0001'", run_suffuse({"runs", "my runs", "--sort", "name"}).error
    );
    EXPECT_EQ(run_suffuse({"runs", "nowhere"}).code, 74);
    EXPECT_EQ(run_suffuse({"runs", "--sort", "colour"}).code, 2);
}

TEST_F(Cli, FiguresTakeAWidthThatAJournalHas) {
    const ProgramResult narrow = run_suffuse({"figures", "run", "--width", "5mm"});
    EXPECT_EQ(narrow.code, 2);
    EXPECT_NE(narrow.error.find("from 30 mm to 1 m"), std::string::npos) << narrow.error;
    const ProgramResult bare = run_suffuse({"figures", "run", "--width", "85"});
    EXPECT_EQ(bare.code, 2);
    EXPECT_NE(bare.error.find("--width"), std::string::npos) << bare.error;
}

} // namespace
} // namespace suffuse
