#include "suffuse/base/loop_meter.hpp"

#include "suffuse/base/parallel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

namespace suffuse {
namespace {

double now = 0; ///< by the clock of these tests [s], which only `work` moves

void work(double seconds) {
    now += seconds;
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

TEST(LoopMeter, DistinguishesWhatIsOutsideOfLoopsFromWhatIsWithin) {
    LoopMeter meter(4, [] { return now; });
    EXPECT_EQ(thread_count(), 4);
    {
        MeteredPhase phase("loops");
        work(0.5);
        parallel_for(16, 1, [](std::size_t begin, std::size_t) { work(begin < 4 ? 4 : 1); });
        work(0.25);
        phase.next("alone");
        work(32);
    }
    const std::vector<LoopMeter::Phase> phases = meter.phases();
    const LoopMeter::Phase *loops = named(phases, "loops"), *alone = named(phases, "alone");
    ASSERT_TRUE(loops != nullptr && alone != nullptr);
    EXPECT_EQ(loops->loops, 1);
    EXPECT_EQ(loops->serial, 0.75);
    EXPECT_EQ(loops->parallel, 28);
    EXPECT_EQ(loops->shared, 7) << "each of four threads has a block of 4 s and three of 1 s";
    EXPECT_EQ(alone->parallel, 0);
    EXPECT_EQ(alone->serial, 32);
}

TEST(LoopMeter, HasAClockThatMovesWhereNoneIsGiven) {
    LoopMeter meter(1);
    double sum = 0;
    const auto seconds = [&] { return meter.phases().front().serial; };
    for (const double before = seconds(); seconds() == before;) { // until the clock moves
        sum += std::sin(sum + 1);
    }
    EXPECT_TRUE(std::isfinite(sum));
    EXPECT_GT(seconds(), 0);
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
