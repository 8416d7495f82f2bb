// A bound on the memory of a run: what does not fit is refused before anything is made, what outgrows it ends in words.

#include "suffuse/base/memory_bound.hpp"

#include "tests/support/program.hpp"
#include <sys/resource.h>

namespace suffuse {
namespace {

using namespace test;

class Memory : public Cli {
protected:
    Memory() {
        for (const char* const name : {"case.toml", "packing.csv"}) {
            write_to(folder / "soil" / name, read_all(std::filesystem::path(examples) / "replay" / name));
        }
    }
};

TEST_F(Memory, ACaseThatNeedsMoreIsRefusedBeforeItStarts) {
    const ProgramResult result = run_suffuse({"run", "soil/case.toml", "-o", "run", "--no-cache", "--memory", "41MB"});
    EXPECT_EQ(result.code, 74);
    for (const char* const part : {"needs up to 4", "the run may use 41 MB", "lower `particles`", "--memory 4"}) {
        expect_in(part, result.error);
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "run"));
    const ProgramResult planned = run_suffuse({"plan", "soil/case.toml", "--memory", "41MB"});
    EXPECT_EQ(planned.code, 0);
    expect_in("run will refuse this case: ", planned.error);
}

TEST_F(Memory, AnAmountIsWrittenWithItsUnit) {
    for (const char* const amount : {"16", "much", "-1GB"}) {
        const ProgramResult result = run_suffuse({"run", "soil/case.toml", "-o", "run", "--memory", amount});
        EXPECT_EQ(result.code, 2) << amount;
        expect_in("GB", result.error);
    }
}

/// The bound of the process stands for an estimate that was too low.
TEST_F(Memory, ARunThatOutgrowsItsBoundEndsInWords) {
    if (!memory_is_bound) {
        GTEST_SKIP() << "a sanitizer's own memory would count";
    }
    write_to(folder / "soil/case.toml", R"(schema = 1
[soil.s]
psd = { d = ["0.2 mm", "0.3 mm"], passing = ["0 %", "100 %"] }
[study.s]
soil      = "s"
particles = 200000
[[study.s.stage]]
name = "cloud"
do   = "pack"
)");
    const auto bound = [] {
        const rlimit limit{75'000'000, 75'000'000};
        setrlimit(RLIMIT_DATA, &limit);
    };
    const ProgramResult result =
        wait_for(start({"run", "soil/case.toml", "-o", "run", "--no-cache", "-j", "1"}, {}, bound));
    EXPECT_EQ(result.code, 74) << result.error;
    expect_in("s, stage cloud: out of memory; suffuse plan CASE shows how much a case needs", result.error);
    EXPECT_TRUE(std::filesystem::exists(folder / "run/studies/s/cloud/failed.json"));
}

} // namespace
} // namespace suffuse
