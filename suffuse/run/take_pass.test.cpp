#include "suffuse/run/take_pass.hpp"

#include "suffuse/erosion/loop.hpp"

#include <gtest/gtest.h>

namespace {

using namespace suffuse;

template <class Error>
std::string text_of(const char* message) {
    try {
        run::take_pass([&]() -> bool { throw Error(message); });
    } catch (const StateError& error) {
        return error.what();
    }
    return "";
}

TEST(TakePass, SaysWhichKeysHelp) {
    EXPECT_EQ(
        text_of<erosion::NoSkeleton>("all are fines"), "all are fines; leave this fines content out (key `only`)"
    );
    EXPECT_EQ(text_of<StateError>("too fast"), "too fast");
}

TEST(TakePass, HandsOnWhetherThereIsAnother) {
    EXPECT_TRUE(run::take_pass([] { return true; }));
    EXPECT_FALSE(run::take_pass([] { return false; }));
}

} // namespace
