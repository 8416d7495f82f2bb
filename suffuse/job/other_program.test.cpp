#include "suffuse/job/other_program.hpp"

#include "suffuse/base/error.hpp"

#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include "tests/support/temp_folder.hpp"
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace suffuse::job {
namespace {

TEST(OtherProgram, ItsComplaintAndItsCodeAreKept) {
    const ProgramEnd end = run_program({"sh", "-c", "echo dropped; echo why >&2; exit 3"});
    EXPECT_EQ(end.code, 3);
    EXPECT_EQ(end.complaint, "why");
    EXPECT_EQ(run_program({"sh", "-c", "kill -TERM $$"}).code, 128 + SIGTERM);
    EXPECT_EQ(run_program({"sh", "-c", "read line || exit 4"}).code, 4) << "there is no input";
}

TEST(OtherProgram, ItsOutputIsKeptWholeWhereItSucceeds) {
    const std::optional<std::string> text = output_of({"sh", "-c", "seq 1 2000; echo dropped >&2"});
    ASSERT_TRUE(text.has_value());
    EXPECT_EQ(text->substr(0, 4), "1\n2\n");
    EXPECT_EQ(text->substr(text->size() - 5), "\n2000");
    EXPECT_EQ(output_of({"sh", "-c", "echo half; exit 1"}), std::nullopt);
    EXPECT_EQ(output_of({"no-such-program-of-suffuse"}), std::nullopt);
}

TEST(OtherProgram, OneThatIsNotThereIsNamed) {
    try {
        run_program({"no-such-program-of-suffuse"});
        FAIL();
    } catch (const IoError& error) {
        EXPECT_STREQ(error.what(), "no-such-program-of-suffuse cannot be started: No such file or directory");
    }
}

TEST(OtherProgram, ItEndsWithWhoWaitsForIt) {
    const test::TempFolder folder;
    const std::string place = (folder / "pid").string();
    prctl(PR_SET_CHILD_SUBREAPER, 1); // what a dead child leaves behind is ours
    const pid_t waiting = fork();
    if (waiting == 0) {
        run_program(
            {"sh", "-c", "echo $$ > " + place + ".new && mv " + place + ".new " + place + " && exec sleep 100000"}
        );
        _exit(0);
    }
    while (!std::filesystem::exists(place)) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    const pid_t other = std::atoi(test::read_all(place).c_str());
    kill(waiting, SIGKILL);
    int status = 0;
    waitpid(waiting, nullptr, 0);
    ASSERT_EQ(waitpid(other, &status, 0), other) << "as long as it lives";
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    prctl(PR_SET_CHILD_SUBREAPER, 0);
}

} // namespace
} // namespace suffuse::job
