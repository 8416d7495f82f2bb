#include "suffuse/base/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <thread>

namespace suffuse {
namespace {

double sum_of_roots(std::size_t rows) {
    return parallel_sum(rows, 100, 0.0, [](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t k = begin; k < end; ++k) {
            sum += std::sqrt(static_cast<double>(k));
        }
        return sum;
    });
}

class Parallel : public testing::Test {
protected:
    void TearDown() override { set_thread_count(1); }
};

TEST_F(Parallel, SumsHaveTheSameBitsForAnyNumberOfThreads) {
    set_thread_count(1);
    const double alone = sum_of_roots(12345);
    for (const int threads : {2, 3, 4, 7}) {
        set_thread_count(threads);
        for (int repeat = 0; repeat < 50; ++repeat) {
            ASSERT_EQ(sum_of_roots(12345), alone);
        }
    }
}

TEST_F(Parallel, EveryRowIsVisitedOnce) {
    set_thread_count(4);
    std::vector<int> visits(1000, 0);
    parallel_for(visits.size(), 7, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            ++visits[k];
        }
    });
    EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), 0), 1000);
    EXPECT_EQ(*std::max_element(visits.begin(), visits.end()), 1);
}

TEST_F(Parallel, AThreadThatIsHeldUpIsHelpedAtOnceOrLate) {
    for (const Help help : {Help::AtOnce, Help::Late}) {
        for (const std::size_t held_up : {std::size_t{0}, std::size_t{2}}) { // the first block of one thread's share
            set_thread_count(2); // new threads, which have not been late yet
            std::atomic<int> done = 0;
            const auto body = [&](std::size_t begin, std::size_t) {
                while (begin == held_up && done < 3) {
                    std::this_thread::yield();
                }
                ++done;
            };
            parallel_for(4, 1, help, body);
            EXPECT_EQ(done, 4);
        }
    }
}

TEST_F(Parallel, AnErrorInAWorkerReachesTheCaller) {
    set_thread_count(2);
    const auto body = [](std::size_t begin, std::size_t) {
        if (begin == 3) {
            throw std::runtime_error("row 3");
        }
    };
    EXPECT_THROW(parallel_for(4, 1, body), std::runtime_error);
    EXPECT_EQ(sum_of_roots(10), [] {
        set_thread_count(1);
        return sum_of_roots(10);
    }()); // the pool still works
}

TEST_F(Parallel, ALoopWithinALoopRuns) {
    set_thread_count(2);
    std::vector<double> sums(8);
    parallel_for(8, 1, [&](std::size_t begin, std::size_t) { sums[begin] = sum_of_roots(500); });
    EXPECT_EQ(sums[0], sums[7]);
}

TEST_F(Parallel, ColumnsGetTheirRowsAndKeepWhatTheyHold) {
    set_thread_count(3);
    std::vector<double> one, other = {7};
    std::vector<char> third(20, 'c');
    resize_columns(3, one, other, third);
    EXPECT_EQ(one, (std::vector<double>{0, 0, 0}));
    EXPECT_EQ(other, (std::vector<double>{7, 0, 0}));
    EXPECT_EQ(third, std::vector<char>(3, 'c'));
}

TEST_F(Parallel, TasksSideBySideRunOnceEachOnTheirShareOfTheThreads) {
    set_thread_count(5);
    for (const int at_once : {1, 2, 3, 9}) {
        std::vector<int> visits(7, 0), shares(7, 0);
        std::vector<double> sums(7, 0);
        run_side_by_side(7, at_once, [&](std::size_t task) {
            ++visits[task];
            shares[task] = thread_count();
            sums[task] = sum_of_roots(1000 * (task + 1));
        });
        EXPECT_EQ(visits, std::vector<int>(7, 1));
        for (const int share : shares) { // more where other workers had run out of tasks
            EXPECT_GE(share, std::max(1, 5 / std::min(at_once, 7)));
        }
        EXPECT_EQ(thread_count(), 5) << "of the caller";
        set_thread_count(1);
        for (std::size_t task = 0; task < 7; ++task) {
            EXPECT_EQ(sums[task], sum_of_roots(1000 * (task + 1)));
        }
        set_thread_count(5);
    }
}

TEST_F(Parallel, ThreadsThatLoopAtOnceHaveTheSameBits) {
    set_thread_count(1);
    const double alone = sum_of_roots(20000);
    set_thread_count(2);
    std::atomic<int> wrong{0};
    {
        std::vector<std::jthread> callers;
        for (int caller = 0; caller < 3; ++caller) {
            callers.emplace_back([&] {
                for (int repeat = 0; repeat < 2000; ++repeat) {
                    wrong += sum_of_roots(20000) != alone ? 1 : 0;
                }
            });
        }
    }
    EXPECT_EQ(wrong, 0);
}

TEST_F(Parallel, TheNumberOfThreadsMayChangeWhileAnotherThreadLoops) {
    set_thread_count(1);
    const double alone = sum_of_roots(20000);
    std::atomic<bool> over{false};
    std::atomic<int> wrong{0}, loops{0};
    {
        const std::jthread caller([&] {
            while (!over) {
                wrong += sum_of_roots(20000) != alone ? 1 : 0;
                ++loops;
            }
        });
        for (int repeat = 0; repeat < 200 || loops < 20; ++repeat) {
            set_thread_count(1 + repeat % 3);
        }
        over = true;
    }
    EXPECT_EQ(wrong, 0);
}

TEST_F(Parallel, TheLastTaskSideBySideGetsTheThreadsOfThoseThatHaveEnded) {
    set_thread_count(4);
    double sum = 0;
    int threads = 0;
    run_side_by_side(2, 2, [&](std::size_t task) {
        const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(2);
        while (task == 0 && thread_count() < 4 && std::chrono::steady_clock::now() < deadline) {
            sum = sum_of_roots(5000); // on two threads, then on four
        }
        if (task == 0) {
            threads = thread_count();
            sum = sum_of_roots(5000);
        }
    });
    EXPECT_EQ(threads, 4);
    set_thread_count(1);
    EXPECT_EQ(sum, sum_of_roots(5000));
}

TEST_F(Parallel, AfterATaskThatThrowsNoFurtherOneBegins) {
    set_thread_count(2);
    for (const int at_once : {1, 2}) {
        std::atomic<int> begun{0};
        const auto task = [&](std::size_t number) {
            ++begun;
            if (number == 3) {
                throw std::runtime_error("the fourth");
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        };
        constexpr std::size_t many = 120'000; // no thread that throws is held up while another runs them for minutes
        EXPECT_THROW(run_side_by_side(many, at_once, task), std::runtime_error);
        EXPECT_LT(begun, static_cast<int>(many));
    }
}

} // namespace
} // namespace suffuse
