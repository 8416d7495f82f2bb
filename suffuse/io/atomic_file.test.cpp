#include "suffuse/io/atomic_file.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/leftovers.hpp"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sched.h>
#include <string>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace suffuse::io {
namespace {

using test::read_all;
using test::TempFolder;

/// As `ulimit -f` does it: the system lets no file grow beyond `bytes`.
class SizeLimit {
public:
    explicit SizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }

    ~SizeLimit() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

    SizeLimit(const SizeLimit&) = delete;
    SizeLimit& operator=(const SizeLimit&) = delete;

private:
    void (*handler_)(int);
    rlimit before_{};
};

TEST(AtomicFile, HasItsNameOnlyWhenItIsComplete) {
    const TempFolder folder;
    AtomicFile file(folder / "a.txt");
    file.write("one ");
    file.write("two");
    EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
    file.commit();
    EXPECT_EQ(read_all(folder / "a.txt"), "one two");
    EXPECT_EQ(folder.entries(), 1);
}

TEST(AtomicFile, LeavesNothingWithoutCommit) {
    const TempFolder folder;
    { AtomicFile(folder / "a.txt").write("one"); }
    EXPECT_EQ(folder.entries(), 0);
}

TEST(AtomicFile, WritesMoreThanItsBufferHoldsInOrder) {
    const TempFolder folder;
    std::string all;
    AtomicFile file(folder / "a.txt");
    for (int k = 0; k < 40; ++k) {
        const std::string piece(static_cast<std::size_t>(1 + k * k * 500), static_cast<char>('a' + k % 26));
        file.write(piece);
        all += piece;
    }
    file.commit();
    EXPECT_EQ(read_all(folder / "a.txt"), all);
}

TEST(AtomicFile, TwoWritersOfOneFileDoNotMeet) {
    const TempFolder folder;
    AtomicFile first(folder / "a.txt"), second(folder / "a.txt");
    EXPECT_EQ(folder.entries(), 2);
    first.write("first");
    second.write("second, longer");
    second.commit();
    EXPECT_EQ(read_all(folder / "a.txt"), "second, longer");
    first.commit();
    EXPECT_EQ(read_all(folder / "a.txt"), "first");
    EXPECT_EQ(folder.entries(), 1);
}

TEST(AtomicFile, WhatAKilledProgramLeftGoesWithTheNextWriting) {
    const TempFolder folder;
    const AtomicFile other(folder / "a.txt.csv"); // another file's, and alive
    const pid_t child = fork();
    if (child == 0) {
        AtomicFile file(folder / "a.txt");
        file.write(std::string(1'000'000, 'x'));
        _exit(0);
    }
    waitpid(child, nullptr, 0);
    ASSERT_EQ(folder.entries(), 2);
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
        EXPECT_TRUE(is_partial(entry.path().filename().string())) << entry.path();
    }
    write_file(folder / "a.txt", "whole");
    EXPECT_EQ(folder.entries(), 2);
    EXPECT_EQ(read_all(folder / "a.txt"), "whole");
}

TEST(AtomicFile, WhatAKilledProgramLeftGoesWithoutAWritingToo) {
    const TempFolder folder;
    std::ofstream(folder / "plan.json.partial-1-2") << "{";
    std::ofstream(folder / "plan.json") << "{}";
    AtomicFile another(folder / "summary.json");
    ASSERT_EQ(folder.entries(), 3);
    remove_leftovers(folder.path(), [](std::string_view name) { return name.ends_with(".json"); });
    EXPECT_EQ(folder.entries(), 2) << "the whole file and that which is being written stay";
    another.commit();
    EXPECT_TRUE(std::filesystem::exists(folder / "plan.json") && std::filesystem::exists(folder / "summary.json"));
}

TEST(Leftovers, OnlyTheWholeFormOfANameOfTheProgramIsOne) {
    EXPECT_EQ(name_of_leftover("plan.json.partial-12-3"), "plan.json");
    for (const char* const name :
         {"movie.mkv.partial", "thesis.partial-2024-", "a.partial--1", "a.partial-1", "a.partial-1-2x",
          "a.partial-1-2-3", ".partial-1-2", "partial.h5"}) {
        EXPECT_EQ(name_of_leftover(name), "") << name;
    }
}

TEST(Leftovers, FilesOfTheUserStayAndSoDoLinksAndFolders) {
    const TempFolder folder;
    for (const char* const name : {"movie.mkv.partial", "thesis.partial-2024-11", "plan.json.partial", "precious"}) {
        std::ofstream(folder / name) << "mine";
    }
    std::filesystem::create_symlink(folder / "precious", folder / "plan.json.partial-1-1");
    std::filesystem::create_directory(folder / "plan.json.partial-1-2");
    std::ofstream(folder / "plan.json.partial-1-3") << "{";
    ASSERT_EQ(folder.entries(), 7);
    remove_leftovers(folder.path(), [](std::string_view name) { return name == "plan.json"; });
    EXPECT_EQ(folder.entries(), 6);
    EXPECT_FALSE(std::filesystem::exists(folder / "plan.json.partial-1-3"));
    EXPECT_FALSE(is_leftover_of(folder / "plan.json.partial-1-1", "plan.json"));
    EXPECT_FALSE(is_leftover_of(folder / "plan.json.partial-1-2", "plan.json"));
}

TEST(AtomicFile, NamesOfFilesThatAreWholeAreNotTakenForHalfWrittenOnes) {
    for (const char* const name : {"partial.h5", "a.partial.csv", "grains.csv", "a.partial-x"}) {
        EXPECT_FALSE(is_partial(name)) << name;
    }
    EXPECT_TRUE(is_partial("partial.h5.partial-12-3"));
    EXPECT_TRUE(is_partial("report.html.partial"));
}

TEST(AtomicFile, AFileBeyondTheLimitIsAnErrorAndTheOldFileRemains) {
    const TempFolder folder;
    write_file(folder / "a.txt", "old");
    std::string message;
    {
        const SizeLimit limit(100'000);
        try {
            write_file(folder / "a.txt", std::string(1'000'000, 'x'));
        } catch (const IoError& error) {
            message = error.what();
        }
    }
    EXPECT_NE(message.find("a.txt"), std::string::npos) << message;
    EXPECT_NE(message.find("ulimit -f"), std::string::npos) << message;
    EXPECT_EQ(read_all(folder / "a.txt"), "old");
    EXPECT_EQ(folder.entries(), 1);
}

/// In a child: the root of a disk of 64 kB that is mounted nowhere, so that nobody else sees it, and that a process in
/// a chroot may make, too. Empty where the system does not allow it.
std::filesystem::path make_small_disk() {
    if (geteuid() != 0 && unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) {
        return {};
    }
    const int settings = fsopen("tmpfs", FSOPEN_CLOEXEC);
    if (settings < 0 || fsconfig(settings, FSCONFIG_SET_STRING, "size", "64k", 0) != 0 ||
        fsconfig(settings, FSCONFIG_CMD_CREATE, nullptr, nullptr, 0) != 0) {
        return {};
    }
    const int disk = fsmount(settings, FSMOUNT_CLOEXEC, 0);
    return disk < 0 ? "" : "/proc/self/fd/" + std::to_string(disk);
}

TEST(AtomicFile, AFullDiskIsAnErrorThatSaysWhatHelpsAndTheOldFileRemains) {
    enum Outcome : int { AsItShould, Otherwise, NotAllowed };

    const pid_t child = fork();
    if (child == 0) {
        const std::filesystem::path disk = make_small_disk();
        if (disk.empty()) {
            _exit(NotAllowed);
        }
        std::string message;
        try {
            write_file(disk / "a.txt", "old");
            write_file(disk / "a.txt", std::string(1'000'000, 'x'));
        } catch (const IoError& error) {
            message = error.what();
        }
        const bool names_cause =
            message.find("a.txt") != std::string::npos && message.find("free some space") != std::string::npos;
        const auto files = std::distance(std::filesystem::directory_iterator(disk), {});
        _exit(names_cause && read_all(disk / "a.txt") == "old" && files == 1 ? AsItShould : Otherwise);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == NotAllowed) {
        GTEST_SKIP() << "the system lets no test make a disk of its own";
    }
    EXPECT_EQ(WEXITSTATUS(status), AsItShould);
}

TEST(AtomicFile, ALinkUnderTheNameOfAHalfWrittenFileIsNotFollowed) {
    const TempFolder folder;
    write_file(folder.path() / "precious", "precious");
    for (const std::string name : {"shown.partial", "shown.partial-1-1"}) {
        std::filesystem::create_symlink(folder.path() / "precious", folder.path() / name);
    }
    EXPECT_TRUE(show_file(folder.path() / "shown", "shown"));
    EXPECT_EQ(read_all(folder.path() / "shown"), "shown");
    EXPECT_EQ(read_all(folder.path() / "precious"), "precious");
    EXPECT_FALSE(show_file(folder.path() / "not there/shown", "shown"));
}

TEST(AtomicFile, WhatIsNoFileIsWrittenToAndNotReplaced) {
    write_file("/dev/null", "gone");
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
    EXPECT_THROW(write_file("/dev/full", "no room"), IoError);
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST(AtomicFile, FolderThatIsNotThereIsAnErrorThatSaysSo) {
    const TempFolder folder;
    try {
        write_file(folder / "missing/a.txt", "x");
        FAIL() << "expected an IoError";
    } catch (const IoError& error) {
        EXPECT_NE(std::string(error.what()).find("create the folder first"), std::string::npos) << error.what();
    }
    write_file(folder / "file", "x");
    EXPECT_THROW(write_file(folder / "file/a.txt", "x"), IoError);
    EXPECT_EQ(folder.entries(), 1);
}

} // namespace
} // namespace suffuse::io
