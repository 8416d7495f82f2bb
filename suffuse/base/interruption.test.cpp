#include "suffuse/base/interruption.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace suffuse {
namespace {

struct Threads {
    explicit Threads(int count) { set_thread_count(count); }

    ~Threads() { set_thread_count(1); }

    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;
};

TEST(Interruption, WithoutOneNothingIsLookedAt) {
    EXPECT_FALSE(Interruption::is_possible());
    EXPECT_NO_THROW(Interruption::look_up());
}

TEST(Interruption, ALoopLooksBetweenItsBlocksOnItsOwnThread) {
    for (const int count : {1, 3}) {
        const Threads threads(count);
        int looks = 0;
        bool is_elsewhere = false;
        std::atomic<int> rows = 0;
        const auto here = std::this_thread::get_id();
        const Interruption interruption([&] {
            ++looks;
            is_elsewhere |= std::this_thread::get_id() != here;
        });
        parallel_for(100, 10, [&](std::size_t begin, std::size_t end) { rows += static_cast<int>(end - begin); });
        EXPECT_EQ(rows, 100);
        EXPECT_GE(looks, 1) << count; // others may have done all blocks before this thread came to look
        EXPECT_FALSE(is_elsewhere);
        if (count == 1) {
            EXPECT_EQ(looks, 10);
        }
    }
}

TEST(Interruption, ALoopEndsSoonAfterALookThatThrows) {
    for (const int count : {1, 2}) {
        const Threads threads(count);
        std::atomic<bool> is_over = false;
        std::atomic<int> after = 0;
        const auto loop = [&] {
            const Interruption interruption([&] {
                is_over = true;
                throw Interrupted("enough");
            });
            parallel_for(1'000'000, 1, [&](std::size_t, std::size_t) {
                after += is_over ? 1 : 0;
                while (!is_over) { // until this thread has looked
                    std::this_thread::yield();
                }
            });
        };
        EXPECT_THROW(loop(), Interrupted);
        EXPECT_LT(after, 1'000) << count;
        EXPECT_NO_THROW(parallel_for(1, 1, [](std::size_t, std::size_t) {})) << "the pool is as before";
    }
}

TEST(Interruption, TheInnermostCountsAndEndsWithItsScope) {
    int outer = 0, inner = 0;
    const Interruption one([&] { ++outer; });
    {
        const Interruption two([&] { ++inner; });
        Interruption::look_up();
    }
    Interruption::look_up();
    EXPECT_EQ(outer, 1);
    EXPECT_EQ(inner, 1);
}

} // namespace
} // namespace suffuse
