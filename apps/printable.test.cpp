#include "apps/printable.hpp"

#include <gtest/gtest.h>

namespace suffuse::apps {
namespace {

TEST(Printable, ControlCharactersAndThoseThatTurnTheDirectionAreShown) {
    EXPECT_EQ(printable("a\x1b]0;title\x07 b", false), "a\\u{1b}]0;title\\u{7} b");
    EXPECT_EQ(
        printable("\u202Efdp.exe \u2066x\u2069 \u200F\u061C\u0085", false),
        "\\u{202e}fdp.exe \\u{2066}x\\u{2069} \\u{200f}\\u{61c}\\u{85}"
    );
    EXPECT_EQ(printable("\r\x7f", false), "\\u{d}\\u{7f}");
}

TEST(Printable, WordsOfAnyLanguageLinesAndTabsStay) {
    for (const char* const text :
         {"\u00e9 \u5927\u8239 \u0627\u0644 \U0001F600", "two\nlines\tand a tab", "caf\xe9", ""}) {
        EXPECT_EQ(printable(text, false), text);
    }
}

TEST(Printable, ColorsStayWhereThereAreAnyAndNothingElseOfATerminal) {
    EXPECT_EQ(printable("\x1b[1;31mred\x1b[0m", true), "\x1b[1;31mred\x1b[0m");
    EXPECT_EQ(printable("\x1b[1;31mred", false), "\\u{1b}[1;31mred");
    EXPECT_EQ(printable("\x1b[2J\x1b[", true), "\\u{1b}[2J\\u{1b}[");
}

} // namespace
} // namespace suffuse::apps
