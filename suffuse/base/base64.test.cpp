#include "suffuse/base/base64.hpp"

#include <gtest/gtest.h>

namespace suffuse {
namespace {

TEST(Base64, EncodesAsTheStandardSays) { // RFC 4648, section 10
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64(std::string("\xff\xfe\x00", 3)), "//4A");
}

TEST(Base64, BytesComeBackWhateverTheirNumber) {
    std::string bytes;
    for (int k = 0; k < 600; ++k) {
        EXPECT_EQ(from_base64(base64(bytes)), bytes) << k;
        bytes += static_cast<char>(k * k);
    }
}

TEST(Base64, TextsMayFollowEachOtherAndHoldLineBreaks) {
    EXPECT_EQ(from_base64("Zg==Zm8=Zm9v"), "ffofoo");
    EXPECT_EQ(from_base64("\n  Zm9v\r\n\tYmFy\n"), "foobar");
}

TEST(Base64, WhatIsNoneIsRefused) {
    for (const char* const text : {"Zm9", "Zm9!", "Z===", "=m9v", "Zm=v", "Zm9v-mFy", "Zm9vYmFy="}) {
        EXPECT_FALSE(from_base64(text).has_value()) << text;
    }
}

} // namespace
} // namespace suffuse
