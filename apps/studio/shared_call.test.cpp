#include "apps/studio/shared_call.hpp"

#include <gtest/gtest.h>

#include <future>
#include <stdexcept>
#include <thread>
#include <vector>

namespace suffuse::studio {
namespace {

/// A call that counts itself and waits for its permission to end.
struct SlowCall {
    std::mutex lock;
    std::condition_variable changed;
    int begun = 0, allowed = 0, at_once = 0, most_at_once = 0;

    ProgramCall operator()() {
        std::unique_lock held(lock);
        const int number = ++begun;
        most_at_once = std::max(most_at_once, ++at_once);
        changed.notify_all();
        changed.wait(held, [&] { return allowed >= number; });
        --at_once;
        ProgramCall made;
        made.code = number;
        return made;
    }

    void wait_for(int number) {
        std::unique_lock held(lock);
        changed.wait(held, [&] { return begun >= number; });
    }

    void allow(int number) {
        const std::scoped_lock held(lock);
        allowed = number;
        changed.notify_all();
    }
};

TEST(SharedCall, RequestsOneAfterTheOtherEachHaveACallOfTheirOwn) {
    SlowCall slow;
    slow.allow(2);
    SharedCall shared([&] { return slow(); });
    EXPECT_EQ(shared.answer().code, 1);
    EXPECT_EQ(shared.answer().code, 2);
}

TEST(SharedCall, WhatArrivesDuringACallSharesTheNextOneWhichIsNotOlderThanTheRequest) {
    SlowCall slow;
    SharedCall shared([&] { return slow(); });
    std::future<ProgramCall> first = std::async(std::launch::async, [&] { return shared.answer(); });
    slow.wait_for(1);
    std::vector<std::future<ProgramCall>> later;
    later.reserve(6);
    for (int k = 0; k < 6; ++k) {
        later.push_back(std::async(std::launch::async, [&] { return shared.answer(); }));
    }
    while (shared.waiting() < 6) {
        std::this_thread::yield();
    }
    slow.allow(2);
    EXPECT_EQ(first.get().code, 1);
    for (std::future<ProgramCall>& one : later) {
        EXPECT_EQ(one.get().code, 2);
    }
    EXPECT_EQ(slow.most_at_once, 1);
}

TEST(SharedCall, AnErrorReachesAllThatWaitForItAndTheNextCallBeginsAnew) {
    int count = 0;
    SharedCall shared([&]() -> ProgramCall {
        if (++count == 1) {
            throw std::runtime_error("no process can be started");
        }
        return {};
    });
    EXPECT_THROW(shared.answer(), std::runtime_error);
    EXPECT_NO_THROW(shared.answer());
}

} // namespace
} // namespace suffuse::studio
