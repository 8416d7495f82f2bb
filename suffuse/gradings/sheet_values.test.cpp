#include "suffuse/gradings/sheet_values.hpp"

#include <gtest/gtest.h>

#include <string>

namespace suffuse::gradings {
namespace {

TEST(RowWords, AMinusBeforeASieveNumberSaysThatItIsPassed) {
    for (const char* const number : {"21", "25", "60", "200"}) {
        const SizeText found = split_size_text(std::string("-") + number);
        EXPECT_EQ(found.sense, SizeSense::Finer) << number;
        EXPECT_EQ(found.text, number);
    }
    for (const char* const phi : {"-20", "-4", "-1.5"}) { // sizes of their own
        const SizeText found = split_size_text(phi);
        EXPECT_EQ(found.sense, SizeSense::At) << phi;
        EXPECT_EQ(found.text, phi);
    }
}

} // namespace
} // namespace suffuse::gradings
