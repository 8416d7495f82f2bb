#include "suffuse/job/print_report.hpp"

#include "suffuse/base/error.hpp"

#include <gtest/gtest.h>

#include "tests/support/run_text.hpp"
#include "tests/support/temp_folder.hpp"
#include <fstream>
#include <utility>
#include <vector>

namespace suffuse::job {
namespace {

namespace fs = std::filesystem;

/// A stand-in for the browser: writes the words that it was given where the PDF should be.
std::string stand_in(const test::TempFolder& folder, const char* what) {
    const fs::path program = folder / "browser";
    std::ofstream(program) << "#!/bin/sh\nfor word; do case $word in --print-to-pdf=*) out=${word#*=};; esac; done\n"
                           << what << '\n';
    fs::permissions(program, fs::perms::owner_all);
    return program.string();
}

TEST(PrintReport, HandsTheBrowserTheAddressOfThePageWhateverItIsCalled) {
    const test::TempFolder folder;
    fs::create_directories(folder / "a b");
    std::ofstream(folder / "a b/report #1.html") << "<p>";
    print_report(folder / "a b/report #1.html", folder / "r.pdf", stand_in(folder, "echo \"$@\" > \"$out\""));
    const std::string words = test::read_all(folder / "r.pdf");
    EXPECT_NE(words.find("/a%20b/report%20%231.html"), std::string::npos) << words;
    EXPECT_NE(words.find("--no-pdf-header-footer"), std::string::npos);
}

TEST(PrintReport, SaysWhatTheBrowserComplainedOf) {
    const test::TempFolder folder;
    std::ofstream(folder / "report.html") << "<p>";
    try {
        print_report(folder / "report.html", folder / "r.pdf", stand_in(folder, "echo no display >&2; exit 3"));
        FAIL() << "no error";
    } catch (const IoError& error) {
        EXPECT_NE(std::string(error.what()).find("no display"), std::string::npos) << error.what();
    }
    EXPECT_EQ(folder.entries(), 2) << "nothing half-printed";
    EXPECT_THROW(print_report(folder / "nothing.html", folder / "r.pdf", "true"), IoError);
}

TEST(PrintReport, APdfThatWasThereStaysWhereTheBrowserFailsAndTheMessageSaysWhy) {
    const test::TempFolder folder;
    std::ofstream(folder / "report.html") << "<p>";
    std::ofstream(folder / "r.pdf") << "old";
    for (const auto& [browser, why] : std::vector<std::pair<const char*, const char*>>{
             {"exit 1", "it ended with code 1 and no message"},
             {"echo half > \"$out\"; echo no display >&2; exit 3", "no display"},
             {"exit 0", "wrote nothing"},
             {"kill -9 $$", "signal 9 ended it"}}) {
        try {
            print_report(folder / "report.html", folder / "r.pdf", stand_in(folder, browser));
            FAIL() << browser;
        } catch (const IoError& error) {
            EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
            EXPECT_NE(std::string(error.what()).find("was left unchanged"), std::string::npos) << error.what();
        }
        EXPECT_EQ(test::read_all(folder / "r.pdf"), "old");
        EXPECT_EQ(folder.entries(), 3) << "nothing half-printed";
    }
}

TEST(PrintReport, IsNotWrittenThroughALink) {
    const test::TempFolder folder;
    std::ofstream(folder / "report.html") << "<p>";
    std::ofstream(folder / "precious") << "precious";
    fs::create_symlink(folder / "precious", folder / "r.pdf");
    print_report(folder / "report.html", folder / "r.pdf", stand_in(folder, "echo pdf > \"$out\""));
    EXPECT_EQ(test::read_all(folder / "precious"), "precious");
    EXPECT_EQ(test::read_all(folder / "r.pdf"), "pdf\n");
}

} // namespace
} // namespace suffuse::job
