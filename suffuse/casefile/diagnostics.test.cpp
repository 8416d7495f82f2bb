#include "suffuse/base/diagnostics.hpp"

#include "suffuse/base/render_within.hpp"
#include "suffuse/casefile/case_for_tests.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace suffuse;
using namespace suffuse::casefile;
using namespace suffuse::casefile::testing;

std::shared_ptr<const Source> source_of(const std::string& text) {
    return std::make_shared<Source>(Source{"dyke/case.toml", text});
}

TEST(Diagnostics, OnANarrowTerminalTheCaretStandsUnderItsWord) {
    Problems problems;
    const std::string line = std::string(70, 'a') + " WRONG " + std::string(30, 'b');
    problems.error("E203", {source_of(line), 1, 72, 5}, "a word");
    for (const std::size_t columns : {40U, 60U, 80U, 200U}) {
        const std::string text = render_within(problems.sorted(), false, columns);
        std::vector<std::string> lines;
        std::istringstream rest(text);
        for (std::string one; std::getline(rest, one);) {
            lines.push_back(one);
        }
        ASSERT_GE(lines.size(), 5U) << text;
        EXPECT_LE(lines[3].size(), columns);
        EXPECT_EQ(lines[3].find("WRONG"), lines[4].find('^')) << text;
    }
}

TEST(Diagnostics, ShowTheLineWithCaretsLabelAndHelp) {
    Problems problems;
    std::string text;
    for (int line = 1; line < 14; ++line) {
        text += "\n";
    }
    problems.error(
        "E203", {source_of(text + "fines_contnet = \"17 %\"\nx"), 14, 1, 13},
        "unknown key `fines_contnet` in [soil.dyke]", "a key with a similar name exists: `fines_content`",
        "not a key of a soil"
    );
    EXPECT_EQ(render(problems.sorted()), R"(error[E203]: unknown key `fines_contnet` in [soil.dyke]
  --> dyke/case.toml:14:1
   |
14 | fines_contnet = "17 %"
   | ^^^^^^^^^^^^^ not a key of a soil
   = help: a key with a similar name exists: `fines_content`

1 error; nothing was run
)");
}

TEST(Diagnostics, CountsErrorsAndWarnings) {
    Problems problems;
    problems.error("E1", {}, "a");
    problems.error("E1", {}, "b");
    problems.warning("W1", {}, "c");
    EXPECT_EQ(count_problems(problems.sorted()), "2 errors, 1 warning");
    EXPECT_TRUE(problems.has_errors());
    EXPECT_EQ(count_problems({}), "no problems");
}

TEST(Diagnostics, TheSameProblemIsReportedOnce) {
    Problems problems;
    const auto source = source_of("a\nb\n");
    problems.error("E1", {source, 2, 1, 1}, "later");
    problems.error("E1", {source, 1, 1, 1}, "first");
    problems.error("E1", {source, 2, 1, 1}, "later");
    const auto list = problems.sorted();
    ASSERT_EQ(list.size(), 2U);
    EXPECT_EQ(list[0].message, "first");
}

TEST(Diagnostics, EachHasItsOwnLineInWhateverOrderTheyCome) {
    Problems problems;
    const auto source = source_of("a\nb\nc\r\n"), other = source_of("x\ny");
    for (const int line : {3, 1, 9, 2, 3}) {
        problems.error("E1", {source, line, 1, 1}, std::to_string(line));
    }
    problems.error("E1", {other, 2, 1, 1}, "of another file");
    std::string lines;
    for (const Diagnostic& d : problems.sorted()) {
        lines += d.source_line + "|";
    }
    EXPECT_EQ(lines, "a|b|y|c||"); // both files have one name
}

TEST(Diagnostics, WarningsOfOneCodeAreShownInFullOnce) {
    Problems problems;
    const auto source = source_of("a\nb\nc\nd\ne\nf\n");
    for (int line = 1; line <= 6; ++line) {
        problems.warning("W1", {source, line, 1, 1}, "number " + std::to_string(line), "do this");
        problems.error("E1", {source, line, 1, 1}, "error " + std::to_string(line));
    }
    const std::string shown = render(problems.sorted());
    EXPECT_EQ(shown.find("warning[W1]"), shown.rfind("warning[W1]")) << shown;
    EXPECT_NE(shown.find("  = also: line 2: number 2\n"), std::string::npos) << shown;
    EXPECT_NE(shown.find("and 2 more"), std::string::npos) << shown;
    EXPECT_NE(shown.find("error 6"), std::string::npos); // each is to be mended
    EXPECT_NE(shown.find("6 errors, 6 warnings"), std::string::npos);
}

TEST(Diagnostics, ManyErrorsWithTheSameAdviceAreShownInFullOnce) {
    const auto shown_of = [](int lines) {
        Problems problems;
        const auto source = source_of("a\nb\nc\nd\ne\nf\n");
        for (int line = 1; line <= lines; ++line) {
            problems.error("E1", {source, line, 1, 1}, "number " + std::to_string(line), "do this");
        }
        problems.error("E1", {source, 6, 1, 1}, "another", "do that");
        return render(problems.sorted());
    };
    const std::string few = shown_of(3), many = shown_of(5);
    EXPECT_EQ(few.find("also:"), std::string::npos) << few;
    EXPECT_NE(many.find("  = also: line 2: number 2\n"), std::string::npos) << many;
    EXPECT_NE(many.find("and 1 more with the same advice"), std::string::npos) << many;
    EXPECT_NE(many.find("error[E1]: another"), std::string::npos) << many;
    EXPECT_NE(many.find("6 errors"), std::string::npos) << many;
}

TEST(Diagnostics, AFurtherWarningOfAnotherFileNamesIt) {
    Problems problems;
    problems.warning("W1", {source_of("a\nb\n"), 2, 1, 1}, "first");
    problems.warning("W1", {std::make_shared<Source>(Source{"--set", "b=1"}), 1, 3, 1}, "second");
    const std::string shown = render(problems.sorted());
    EXPECT_NE(shown.find("  = also: --set:1: second\n"), std::string::npos) << shown;
}

TEST(Diagnostics, CaretsFollowCharactersNotBytes) {
    const auto list = problems_of("schema = 1\ncontact = { \"\u00e9\u4e2d\" = 1, modulus = 3 }\n[study.a]\n");
    const Diagnostic found = find_problem(list, "E310");
    EXPECT_EQ(found.column, 33);
    const std::string shown = render({found});
    EXPECT_NE(shown.find("\n  | " + std::string(32, ' ') + "^\n"), std::string::npos) << shown;
}

TEST(Diagnostics, ControlCharactersDoNotReachTheTerminal) {
    Problems problems;
    problems.error("E1", {source_of("a = \x1b[2J\x07"), 1, 1, 1}, "a \x1b[31m message", "help\x1b", "label\x1b");
    EXPECT_EQ(render(problems.sorted()).find('\x1b'), std::string::npos);
    EXPECT_NE(render(problems.sorted(), true).find("\x1b[1;31merror"), std::string::npos);
}

TEST(Diagnostics, BytesThatAreNoTextAreShownAsQuestionMarks) {
    const Diagnostic found = find_problem(problems_of("schema = 1\ntitle = \"D\xfcne \xe4 \u00e9\"\n"), "E100");
    EXPECT_EQ(found.source_line, "title = \"D?ne ? \u00e9\"");
    EXPECT_EQ(found.column, 11);
}

TEST(Diagnostics, AnEndlessLineIsCutAroundItsPlace) {
    Problems problems;
    problems.error(
        "E1", {source_of(std::string(5'000'000, 'x') + "HERE" + std::string(1000, 'y')), 1, 5'000'001, 4}, "m"
    );
    const std::string shown = render(problems.sorted());
    EXPECT_LT(shown.size(), 1000U);
    EXPECT_NE(shown.find("HERE"), std::string::npos);
    EXPECT_NE(shown.find("^^^^\n"), std::string::npos);
}

} // namespace
