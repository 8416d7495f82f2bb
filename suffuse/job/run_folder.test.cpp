#include "suffuse/job/run_folder.hpp"

#include "suffuse/job/print_report.hpp"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"
#include <array>
#include <filesystem>
#include <fstream>
#include <string>

namespace suffuse::job {
namespace {

namespace fs = std::filesystem;

void make(const fs::path& file) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << "half";
}

TEST(RunFolder, WhatKilledProgramsLeftInItOrInAStageIsRemovedWhenItIsOpened) {
    const test::TempFolder folder;
    for (const char* const left :
         {"report.pdf.partial-1-1", "studies/s/a/state.h5.partial-12-3", "studies/s/fc=20/a/partial.h5.partial-1-1",
          "studies/s/a/grains.csv.partial-7-7"}) {
        make(folder / left);
    }
    const std::array<const char*, 4> others = {
        "studies/s/a/notes.txt.partial-1-1", "studies/s/a/state.h5", "studies/s/a/state.h5.partial",
        "mine/state.h5.partial-1-1"};
    for (const char* const other : others) {
        make(folder / other);
    }
    const FolderLock lock(folder.path(), [](const std::string& text) { ADD_FAILURE() << text; });
    for (const char* const other : others) {
        EXPECT_TRUE(fs::exists(folder / other)) << other;
    }
    int left = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder.path())) {
        left += entry.path().filename().string().find(".partial-") != std::string::npos ? 1 : 0;
    }
    EXPECT_EQ(left, 2) << "those of other names";
}

TEST(RunFolder, AHalfPrintedReportOfAKilledProgramIsRemovedByTheNext) {
    const test::TempFolder folder;
    make(folder / "x.pdf.partial-1-1");
    make(folder / "y.pdf.partial-1-1");
    std::ofstream(folder / "page.html") << "<p>";
    std::ofstream(
        folder / "browser"
    ) << "#!/bin/sh\nfor word; do case $word in --print-to-pdf=*) echo pdf > ${word#*=};; esac; done\n";
    fs::permissions(folder / "browser", fs::perms::owner_all);
    print_report(folder / "page.html", folder / "x.pdf", (folder / "browser").string());
    EXPECT_FALSE(fs::exists(folder / "x.pdf.partial-1-1"));
    EXPECT_TRUE(fs::exists(folder / "y.pdf.partial-1-1"));
}

} // namespace
} // namespace suffuse::job
