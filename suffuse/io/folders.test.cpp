// Folders on the way to the disk; that their names outlive a power cut is tested by tests/crash/power_loss.py.

#include "suffuse/io/folders.hpp"

#include "suffuse/base/error.hpp"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"
#include <fstream>

namespace suffuse::io {
namespace {

namespace fs = std::filesystem;

TEST(Folders, AreMadeWithThoseAboveThemAndFoundAgain) {
    const test::TempFolder place;
    make_folders(place / "a" / "b" / "c");
    EXPECT_TRUE(fs::is_directory(place / "a" / "b" / "c"));
    EXPECT_NO_THROW(make_folders(place / "a" / "b" / "c"));
    EXPECT_NO_THROW(make_folders(place / "a" / "d" / ""));
    EXPECT_TRUE(fs::is_directory(place / "a" / "d"));
}

TEST(Folders, OfOneNameAreMadeOnce) {
    const test::TempFolder place;
    EXPECT_TRUE(make_folder(place / "a"));
    EXPECT_FALSE(make_folder(place / "a"));
}

TEST(Folders, AreRefusedWhereAFileHasTheirName) {
    const test::TempFolder place;
    std::ofstream(place / "a") << "text";
    EXPECT_THROW(make_folders(place / "a"), IoError);
    EXPECT_THROW(make_folders(place / "a" / "b"), IoError);
}

TEST(Folders, LoseAFileThatIsRemovedAndMindNoneThatIsNotThere) {
    const test::TempFolder place;
    std::ofstream(place / "a") << "text";
    remove_file(place / "a");
    EXPECT_FALSE(fs::exists(place / "a"));
    EXPECT_NO_THROW(remove_file(place / "a"));
}

} // namespace
} // namespace suffuse::io
