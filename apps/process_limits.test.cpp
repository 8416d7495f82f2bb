// Limits of the process: too low ones end in words, low ones that may be raised are.

#include "suffuse/base/memory_bound.hpp"

#include "tests/support/program.hpp"
#include <sys/resource.h>

namespace suffuse {
namespace {

using namespace test;

class ProcessLimits : public Cli {
protected:
    void SetUp() override {
        if (!memory_is_bound) {
            GTEST_SKIP() << "a sanitizer takes more of the stack";
        }
        for (const char* const name : {"case.toml", "packing.csv"}) {
            write_to(folder / "soil" / name, read_all(std::filesystem::path(examples) / "replay" / name));
        }
    }

    /// @param least that the program may not raise, either, unless `is_soft`
    ProgramResult
    run_within(decltype(RLIMIT_STACK) kind, rlim_t least, bool is_soft, const std::vector<std::string>& words) {
        return wait_for(start(words, {}, [&] {
            close_range(STDERR_FILENO + 1, ~0U, 0); // what the tests were started with
            rlimit limit{};
            getrlimit(kind, &limit);
            limit = {least, is_soft ? limit.rlim_max : least};
            setrlimit(kind, &limit);
        }));
    }

    const std::vector<std::vector<std::string>> readers{
        {"check", "soil/case.toml"},
        {"plan", "soil/case.toml"},
        {"run", "soil/case.toml", "-o", "run", "--no-cache", "--until", "start"},
    };
};

TEST_F(ProcessLimits, AStackThatIsTooSmallIsRefused) {
    for (const rlim_t kilobytes : {64, 256}) {
        std::vector<std::vector<std::string>> all = readers;
        all.push_back({"--version"});
        for (const std::vector<std::string>& words : all) {
            const ProgramResult result = run_within(RLIMIT_STACK, kilobytes << 10U, false, words);
            EXPECT_EQ(result.code, 74) << words.front();
            expect_in("the stack may only take " + std::to_string(kilobytes) + " kB", result.error);
            expect_in("ulimit -s 8192", result.error);
        }
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "run"));
}

TEST_F(ProcessLimits, TooFewFilesAreRefusedWhereACaseIsRead) {
    for (const rlim_t files : {6, 15}) {
        for (const std::vector<std::string>& words : readers) {
            const ProgramResult result = run_within(RLIMIT_NOFILE, files, false, words);
            EXPECT_EQ(result.code, 74) << words.front();
            expect_in("only " + std::to_string(files) + " files may be open at once", result.error);
            expect_in("ulimit -n 256", result.error);
        }
        EXPECT_EQ(run_within(RLIMIT_NOFILE, files, false, {"--version"}).code, 0);
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "run"));
}

TEST_F(ProcessLimits, WhatMayBeRaisedIsRaised) {
    for (const auto& [kind, low] : {std::pair{RLIMIT_STACK, rlim_t{80U << 10U}}, std::pair{RLIMIT_NOFILE, rlim_t{6}}}) {
        for (const std::vector<std::string>& words : readers) {
            const ProgramResult result = run_within(kind, low, true, words);
            EXPECT_EQ(result.code, 0) << words.front() << result.error;
        }
        std::filesystem::remove_all(folder / "run");
    }
}

TEST_F(ProcessLimits, FewestFilesThatAreAllowedAreEnough) {
    const ProgramResult result =
        run_within(RLIMIT_NOFILE, 16, false, {"run", "soil/case.toml", "-o", "run", "--no-cache"});
    EXPECT_EQ(result.code, 0) << result.error;
}

} // namespace
} // namespace suffuse
