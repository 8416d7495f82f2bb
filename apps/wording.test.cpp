#include "apps/wording.hpp"

#include "suffuse/base/amounts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <sstream>
#include <vector>

namespace suffuse::apps {
namespace {

TEST(Wording, DurationsReadAsPeopleSayThem) {
    EXPECT_EQ(duration_text(0.42), "0.4 s");
    EXPECT_EQ(duration_text(12.3), "12 s");
    EXPECT_EQ(duration_text(59.7), "1 min 0 s"); // not "60 s"
    EXPECT_EQ(duration_text(432), "7 min 12 s");
    EXPECT_EQ(duration_text(3599.7), "1 h 0 min");
    EXPECT_EQ(duration_text(5760), "1 h 36 min");
}

TEST(Wording, ARangeHasOneUnitAndIsNeverNarrowerThanATenth) {
    EXPECT_EQ(duration_range_text({0, 0.4}), "under 1 s");
    EXPECT_EQ(duration_range_text({20, 40}), "20-40 s");
    EXPECT_EQ(duration_range_text({240, 360}), "4-6 min");
    EXPECT_EQ(duration_range_text({3600 * 6, 3600 * 6}), "6-7 h");
    EXPECT_EQ(duration_range_text({50, 50}), "50-55 s");
    EXPECT_EQ(duration_range_text({86400 * 3, 86400 * 5}), "3-5 days");
    EXPECT_EQ(duration_range_text({20, 3600 * 12}), "up to 12 h"); // not "0.0-12 h"
    EXPECT_EQ(duration_range_text({0, std::nan("")}), "an unknown time");
}

TEST(Wording, SizesAndCounts) {
    EXPECT_EQ(size_text(0), "0 B");
    EXPECT_EQ(size_text(999), "999 B");
    EXPECT_EQ(size_text(1.4e6), "1.4 MB");
    EXPECT_EQ(size_text(4.1e8), "410 MB");
    EXPECT_EQ(count_text(-1200), "-1,200");
    EXPECT_EQ(count_text(999), "999");
    EXPECT_EQ(count_text(1234567), "1,234,567");
    EXPECT_EQ(digits_text(1283.4, 3), "1283");
    EXPECT_EQ(digits_text(-12.34, 3), "-12.3");
    EXPECT_EQ(steps_text({2000, 2000}), "2,000");
    EXPECT_EQ(steps_text({2.1e6, 3.2e6}), "2.1e6-3.2e6");
    EXPECT_EQ(plural(1, "stage"), "1 stage");
    EXPECT_EQ(plural(12, "study"), "12 studies");
}

TEST(Wording, ClippingCountsCharactersAndNeverCutsOne) {
    const std::string text = "a\u2588\u2591b";
    EXPECT_EQ(columns_of(text), 4U);
    EXPECT_EQ(clipped(text, 2), "a\u2588");
    EXPECT_EQ(clipped(text, 9), text);
    EXPECT_EQ(clipped(text, 0), "");
    EXPECT_EQ(columns_of("\x1b[1;31merror\x1b[0m: x"), 8U);
    EXPECT_EQ(clipped("\x1b[1merror\x1b[0m", 5), "\x1b[1merror\x1b[0m");
}

TEST(Wording, LongLinesGoOnBelowTheirLastColumn) {
    EXPECT_EQ(folded("one two three\nfour\n", 80), "one two three\nfour\n");
    EXPECT_EQ(
        folded("  plan    what a case would cost in time", 26),
        "  plan    what a case\n          would cost in\n          time"
    );
    EXPECT_EQ(folded("warning: one two three", 14), "warning: one\n    two three");
    EXPECT_EQ(folded("a-word-that-is-longer-than-a-line", 10), "a-word-that-is-longer-than-a-line");
    EXPECT_EQ(folded("", 10), "");
    EXPECT_EQ(folded("  prose of a screen", 12), "  prose of a\n  screen");
    EXPECT_EQ(folded("initial  compact  2-10 s  from a porosity", 32), "initial  compact  2-10 s\n    from a porosity");
}

TEST(Wording, FoldingLosesNoWordAndKeepsToTheWidth) {
    const std::string text = "erosion/probe   detach  10,000   relaxation, 4 gradients \u2588\u2588 and a twin";
    const auto words = [](const std::string& from) {
        std::istringstream in(from);
        return std::vector<std::string>(std::istream_iterator<std::string>(in), {});
    };
    for (std::size_t columns = 28; columns < 70; ++columns) {
        const std::string lines = folded(text, columns);
        EXPECT_EQ(words(lines), words(text));
        std::istringstream in(lines);
        for (std::string line; std::getline(in, line);) {
            EXPECT_LE(columns_of(line), columns) << line;
        }
    }
}

TEST(Wording, SourceUnderItsCaretAndCommandsKeepTheirLines) {
    for (const char* line : {"48 | particles = 10_000 # many", "suffuse resume runs/fontainebleau-2016-0001"}) {
        EXPECT_EQ(folded(line, 12), line);
    }
}

} // namespace
} // namespace suffuse::apps
