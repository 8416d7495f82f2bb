// What a machine grants, as files say it, and a bound that is kept.

#include "suffuse/base/memory_bound.hpp"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"
#include <fstream>
#include <limits>
#include <new>
#include <vector>

namespace suffuse {
namespace {

namespace fs = std::filesystem;

void write_to(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

TEST(MachineMemory, IsTheLeastLimitOfAGroupAndOfThoseAboveIt) {
    const test::TempFolder place;
    write_to(place / "membership", "0::/job/step\n");
    write_to(place / "groups/job/step/memory.max", "max\n");
    EXPECT_FALSE(group_memory(place / "membership", place / "groups").has_value());
    write_to(place / "groups/job/memory.max", "3000000000\n");
    EXPECT_EQ(group_memory(place / "membership", place / "groups"), 3e9);
    write_to(place / "groups/job/step/memory.max", "2000000000\n");
    EXPECT_EQ(group_memory(place / "membership", place / "groups"), 2e9);
    write_to(place / "groups/memory.max", "1000000000\n"); // the root that a container sees
    EXPECT_EQ(group_memory(place / "membership", place / "groups"), 1e9);
}

TEST(MachineMemory, ReadsTheFirstVersionOfControlGroupsToo) {
    const test::TempFolder place;
    write_to(place / "membership", "5:cpu,cpuacct:/a\n4:memory:/a\n");
    write_to(place / "groups/memory/a/memory.limit_in_bytes", "500000000\n");
    write_to(place / "groups/a/memory.max", "1\n"); // of no group of this process
    EXPECT_EQ(group_memory(place / "membership", place / "groups"), 5e8);
}

TEST(MachineMemory, WithoutGroupsIsTheMachines) {
    EXPECT_FALSE(group_memory("/nowhere/membership", "/nowhere").has_value());
    EXPECT_GT(machine_memory(), 1e8);
    EXPECT_LT(machine_memory(), 1e15);
}

TEST(MemoryBound, RefusesMoreInsteadOfTakingIt) {
    if (!memory_is_bound) {
        GTEST_SKIP() << "a sanitizer's own memory would count";
    }
    const double before = bound_memory(300e6);
    EXPECT_THROW(std::vector<char>(std::size_t{400'000'000}), std::bad_alloc);
    EXPECT_EQ(bound_memory(std::numeric_limits<double>::infinity()), 300e6);
    EXPECT_NO_THROW(std::vector<char>(std::size_t{400'000'000}));
    bound_memory(before);
}

} // namespace
} // namespace suffuse
