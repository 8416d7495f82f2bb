#include "suffuse/job/scratch_folder.hpp"

#include "suffuse/base/error.hpp"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"
#include <cstdlib>
#include <string>

namespace suffuse::job {
namespace {

namespace fs = std::filesystem;

/// The place of temporary files, as a user sets it, until the end of a test.
class TemporaryFiles {
public:
    explicit TemporaryFiles(const fs::path& place) {
        const char* const before = std::getenv("TMPDIR");
        before_ = before == nullptr ? "/tmp" : before;
        setenv("TMPDIR", place.c_str(), 1);
    }

    ~TemporaryFiles() { setenv("TMPDIR", before_.c_str(), 1); }

    TemporaryFiles(const TemporaryFiles&) = delete;
    TemporaryFiles& operator=(const TemporaryFiles&) = delete;

private:
    std::string before_;
};

TEST(ScratchFolder, IsMadeWhereTemporaryFilesBelongAndGoesAtTheEnd) {
    const test::TempFolder temporary, run;
    const TemporaryFiles place(temporary.path());
    {
        const ScratchFolder scratch(run.path());
        EXPECT_EQ(scratch.path().parent_path(), temporary.path());
    }
    EXPECT_EQ(temporary.entries(), 0);
}

TEST(ScratchFolder, IsMadeInTheFolderOfTheRunWhereTemporaryFilesHaveNoPlace) {
    const test::TempFolder run;
    for (const char* const nowhere : {"/nowhere", "/proc", "/dev/null"}) {
        const TemporaryFiles place(nowhere);
        {
            const ScratchFolder scratch(run.path());
            EXPECT_EQ(scratch.path().parent_path(), run.path()) << nowhere;
        }
        EXPECT_EQ(run.entries(), 0);
        EXPECT_THROW(ScratchFolder("/proc"), IoError);
    }
}

} // namespace
} // namespace suffuse::job
