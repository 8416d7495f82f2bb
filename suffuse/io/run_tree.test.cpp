#include "suffuse/io/run_tree.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/own_file.hpp"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace suffuse::io {
namespace {

namespace fs = std::filesystem;
using test::read_all;
using test::TempFolder;

void write(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

/// What is refused, empty where nothing is.
std::string refused(const fs::path& run, Purpose purpose) {
    try {
        look_into_run(run, purpose);
        return "";
    } catch (const IoError& error) {
        return error.what();
    }
}

void make_socket(const fs::path& path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.string().copy(address.sun_path, sizeof address.sun_path - 1);
    const int made = socket(AF_UNIX, SOCK_STREAM, 0);
    ASSERT_EQ(bind(made, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    close(made);
}

TEST(RunTree, APipeASocketOrADeviceIsRefusedByNameAlsoBehindALink) {
    for (const Purpose purpose : {Purpose::Read, Purpose::Work}) {
        for (const std::string kind : {"pipe", "socket", "device"}) {
            const TempFolder run;
            const fs::path file = run / "studies/s/x";
            write(run / "studies/s/stage.json", "{}");
            EXPECT_EQ(refused(run.path(), purpose), "");
            if (kind == "pipe") {
                ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
            } else if (kind == "socket") {
                make_socket(file);
            } else {
                fs::create_symlink("/dev/zero", file);
            }
            EXPECT_NE(refused(run.path(), purpose).find("studies/s/x is a "), std::string::npos);
            EXPECT_NE(
                refused(run.path(), Purpose::Read).find(kind == "device" ? "is a device" : "is a " + kind),
                std::string::npos
            );
        }
    }
}

TEST(RunTree, ALinkIsReadThroughAndNotWrittenThrough) {
    for (const bool to_folder : {false, true}) {
        const TempFolder run, elsewhere;
        write(elsewhere / "a", "mine");
        write(run / "studies/x/stage.json", "{}");
        fs::create_symlink(to_folder ? elsewhere.path() : elsewhere / "a", run / "studies/x/link");
        EXPECT_EQ(refused(run.path(), Purpose::Read), "");
        EXPECT_NE(refused(run.path(), Purpose::Work).find("studies/x/link is a link"), std::string::npos);
    }
}

TEST(RunTree, ARunThatIsNotThereYetIsNothingToComplainOf) {
    EXPECT_EQ(refused("/nowhere", Purpose::Work), "");
    EXPECT_EQ(look_into_run("/nowhere", Purpose::Read), "");
}

TEST(RunTree, FilesOfAnotherUserAreReadWithARemark) {
    const TempFolder run;
    write(run / "studies/x/stage.json", "{}");
    EXPECT_EQ(look_into_run(run.path(), Purpose::Read), "");
    if (geteuid() != 0) {
        GTEST_SKIP() << "only root can give a file away";
    }
    ASSERT_EQ(chown((run / "studies/x/stage.json").c_str(), 65534, 65534), 0);
    EXPECT_NE(look_into_run(run.path(), Purpose::Read).find("1 file belongs to another user"), std::string::npos);
}

TEST(OwnFile, LinesAreAppendedToAFileThatIsMadeWhereItIsMissing) {
    const TempFolder folder;
    append_to(folder / "events.jsonl", "one\n");
    append_to(folder / "events.jsonl", "two\n");
    EXPECT_EQ(read_all(folder / "events.jsonl"), "one\ntwo\n");
}

TEST(OwnFile, NothingIsAppendedThroughALinkOfEitherKindOrToWhatIsNoFile) {
    const TempFolder folder;
    write(folder / "precious", "precious");
    fs::create_symlink(folder / "precious", folder / "link");
    fs::create_symlink(folder / "nothing yet", folder / "dangling");
    fs::create_hard_link(folder / "precious", folder / "hard");
    fs::create_directory(folder / "folder");
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    for (const char* const name : {"link", "dangling", "hard", "pipe", "folder"}) {
        EXPECT_THROW(append_to(folder / name, "line\n"), IoError) << name;
    }
    EXPECT_EQ(read_all(folder / "precious"), "precious");
    EXPECT_FALSE(fs::exists(folder / "nothing yet"));
}

TEST(OwnFile, NothingIsAppendedToAFileOfAnotherUser) {
    if (geteuid() != 0) {
        GTEST_SKIP() << "only root can give a file away";
    }
    const TempFolder folder;
    write(folder / "a", "theirs");
    ASSERT_EQ(chown((folder / "a").c_str(), 65534, 65534), 0);
    EXPECT_THROW(append_to(folder / "a", "line\n"), IoError);
    EXPECT_EQ(read_all(folder / "a"), "theirs");
}

} // namespace
} // namespace suffuse::io
