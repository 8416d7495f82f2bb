#include "suffuse/base/loop_meter.hpp"

#include "suffuse/base/parallel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numeric>
#include <vector>

namespace suffuse {
namespace {

/// Work that a processor cannot leave out. @return what came of it
double work_a_while(int turns) {
    double sum = 0;
    for (int k = 1; k <= turns; ++k) {
        sum += std::sin(static_cast<double>(k));
    }
    return sum;
}

const LoopMeter::Phase* named(const std::vector<LoopMeter::Phase>& phases, const char* name) {
    for (const LoopMeter::Phase& phase : phases) {
        if (std::strcmp(phase.name, name) == 0) {
            return &phase;
        }
    }
    return nullptr;
}

TEST(LoopMeter, SharesBlocksAsFreeThreadsTakeThem) {
    const std::vector<double> equal(8, 1.0), one_long = {1, 1, 1, 5};
    EXPECT_EQ(shared_time(equal, 1), 8);
    EXPECT_EQ(shared_time(equal, 4), 2);
    EXPECT_EQ(shared_time(equal, 3), 3);
    EXPECT_EQ(shared_time(equal, 64), 1);
    EXPECT_EQ(shared_time(one_long, 2), 6) << "the long block comes last and is not cut";
    EXPECT_EQ(shared_time({}, 2), 0);
}

TEST(LoopMeter, TellsWhatIsOutsideOfLoopsFromWhatIsWithin) {
    constexpr std::size_t blocks = 16;
    LoopMeter meter(4);
    EXPECT_EQ(thread_count(), 4);
    std::vector<double> results(blocks);
    double outside = 0;
    {
        MeteredPhase phase("loops");
        parallel_for(blocks, 1, [&](std::size_t begin, std::size_t) { results[begin] = work_a_while(20'000); });
        phase.next("alone");
        outside = work_a_while(320'000);
    }
    const std::vector<LoopMeter::Phase> phases = meter.phases();
    ASSERT_TRUE(std::isfinite(outside + std::accumulate(results.begin(), results.end(), 0.0)));
    const LoopMeter::Phase *loops = named(phases, "loops"), *alone = named(phases, "alone");
    ASSERT_TRUE(loops != nullptr && alone != nullptr);
    EXPECT_EQ(loops->loops, 1);
    EXPECT_GT(loops->parallel, 10 * loops->serial);
    EXPECT_GE(loops->shared, 0.25 * loops->parallel);
    EXPECT_LT(loops->shared, 0.6 * loops->parallel) << "sixteen blocks over four threads, however uneven";
    EXPECT_EQ(alone->parallel, 0);
    EXPECT_GT(alone->serial, 0.1 * loops->parallel) << "as much work as in the loop";
}

TEST(LoopMeter, MeasuresNothingWhereNoneLives) {
    EXPECT_EQ(LoopMeter::of_this_thread(), nullptr);
    const MeteredPhase phase("of nobody");
    double sum = 0;
    parallel_for(3, 1, [&](std::size_t begin, std::size_t) { sum += static_cast<double>(begin); });
    {
        const LoopMeter meter(2);
        EXPECT_EQ(LoopMeter::of_this_thread(), &meter);
    }
    EXPECT_EQ(LoopMeter::of_this_thread(), nullptr);
}

TEST(LoopMeter, ALoopWithinALoopIsPartOfIt) {
    LoopMeter meter(1);
    parallel_for(2, 1, [&](std::size_t, std::size_t) { parallel_for(4, 1, [](std::size_t, std::size_t) {}); });
    EXPECT_EQ(meter.phases().front().loops, 1);
}

} // namespace
} // namespace suffuse
