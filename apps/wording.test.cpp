#include "apps/wording.hpp"

#include <gtest/gtest.h>

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
}

TEST(Wording, SizesAndCounts) {
    EXPECT_EQ(size_text(0), "0 B");
    EXPECT_EQ(size_text(999), "999 B");
    EXPECT_EQ(size_text(1.4e6), "1.4 MB");
    EXPECT_EQ(size_text(4.1e8), "410 MB");
    EXPECT_EQ(count_text(-1200), "-1,200");
    EXPECT_EQ(count_text(999), "999");
    EXPECT_EQ(count_text(1234567), "1,234,567");
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
}

} // namespace
} // namespace suffuse::apps
