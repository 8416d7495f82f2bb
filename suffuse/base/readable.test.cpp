#include "suffuse/base/readable.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace suffuse {
namespace {

TEST(Readable, AShortMessageStays) {
    for (const char* const message :
         {"", "\n", "pressure: found \"3 kg\", expected a pressure\nhelp: write \"100 kPa\"\n", "an open \"quotation",
          "a \\\" mark, \"a text with \\\" in it\""}) {
        EXPECT_EQ(readable(message), message);
    }
}

TEST(Readable, ALongQuotationIsCutInItsMiddle) {
    for (const std::string& long_text : {std::string(1'000'000, 'x'), std::string(100'000, ' ') + "end"}) {
        const std::string message = readable("key: found \"" + long_text + "\", expected a length");
        EXPECT_TRUE(message.starts_with("key: found \"" + long_text.substr(0, 100))) << message;
        EXPECT_TRUE(message.ends_with("\", expected a length")) << message;
        EXPECT_NE(message.find("…"), std::string::npos);
        EXPECT_LT(message.size(), 250U);
    }
}

TEST(Readable, TwoHundredBytesStayAndOfOneMoreTheFirst150AndTheLast50) {
    EXPECT_EQ(readable(std::string(200, 'a')), std::string(200, 'a'));
    EXPECT_EQ(
        readable(std::string(151, 'a') + std::string(50, 'b')), std::string(150, 'a') + "…" + std::string(50, 'b')
    );
    EXPECT_EQ(
        readable(std::string(149, 'a') + "é" + std::string(50, 'b')), std::string(149, 'a') + "…" + std::string(50, 'b')
    );
}

TEST(Readable, ALongWordKeepsItsEndAsAPathNeedsIt) {
    const std::string message = readable("cannot read /data/" + std::string(5000, 'a') + "/case.toml: no such file");
    EXPECT_TRUE(message.starts_with("cannot read /data/aaa"));
    EXPECT_TRUE(message.ends_with("/case.toml: no such file"));
    EXPECT_LT(message.size(), 250U);
}

TEST(Readable, QuotationMarksInAForeignTextDoNotMakeItLonger) {
    std::string marks;
    for (int k = 0; k < 100'000; ++k) {
        marks += "a \" b ";
    }
    EXPECT_LT(readable("found " + marks + ", expected a number").size(), 2'010U);
    std::erase(marks, ' ');
    EXPECT_LT(readable("found \"" + marks + "\", expected a number").size(), 250U);
}

TEST(Readable, ManyLinesStayEachForItself) {
    const std::string message = readable("one\n" + std::string(300, 'y') + "\nthree");
    EXPECT_TRUE(message.starts_with("one\ny"));
    EXPECT_TRUE(message.ends_with("y\nthree"));
    EXPECT_EQ(std::ranges::count(message, '\n'), 2);
}

TEST(Readable, CharactersStayWhole) {
    std::string text;
    for (int k = 0; k < 300; ++k) {
        text += "ä";
    }
    for (std::size_t before = 0; before < 4; ++before) {
        const std::string message = readable(std::string(before, 'x') + text);
        EXPECT_EQ((message.size() - before - 3) % 2, 0U) << "the mark itself has three bytes";
    }
}

} // namespace
} // namespace suffuse
