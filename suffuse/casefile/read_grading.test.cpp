#include "suffuse/gradings/read_grading.hpp"

#include "suffuse/casefile/case_for_tests.hpp"

#include <gtest/gtest.h>

#include "tests/support/reference.hpp"

namespace {

using namespace suffuse;
using namespace suffuse::casefile;
using namespace suffuse::gradings;
using namespace suffuse::casefile::testing;

struct Parsed {
    std::optional<grains::Grading> grading;
    std::vector<Diagnostic> problems;
};

Parsed parse(const std::string& text) {
    Problems problems;
    Parsed parsed;
    parsed.grading = parse_grading(std::make_shared<Source>(Source{"sand.csv", text}), problems);
    parsed.problems = problems.sorted();
    return parsed;
}

TEST(ReadGrading, MillimetersAndPercentUnlessTheHeaderSaysOtherwise) {
    const std::vector<double> sizes{1e-4, 2e-4, 4e-4}, shares{0, 0.5, 1};
    for (const char* text :
         {"d,passing\n0.1,0\n0.2,50\n0.4,100\n", "d [mm],passing [%]\n0.1,0\n0.2,50\n0.4,100",
          "# a comment\r\n\r\npassing [-] ; d [um] ; remark\r\n0;100;a\r\n0.5;200;b # half\r\n1;400;\r\n",
          "d [m]\tpassing [%]\n4e-4\t100\n2e-4\t50\n1e-4\t0\n"}) {
        const Parsed parsed = parse(text);
        ASSERT_TRUE(parsed.grading) << render(parsed.problems);
        EXPECT_EQ(parsed.grading->diameter, sizes) << text;
        EXPECT_EQ(parsed.grading->passing, shares) << text;
        EXPECT_EQ(parsed.grading->origin, "sand.csv");
    }
}

TEST(ReadGrading, SieveAnalysesAsLaboratoriesWriteThemGiveTheSameCurve) {
    const std::vector<double> sizes{1e-4, 2e-4, 4e-4}, shares{0, 0.5, 1};
    for (const char* text : {
             "D [MM];PASSING [%]\n0,1;0\n0,2;50,0\n0,4;100\n",                    // decimal comma, capitals
             "Sieve size (mm)\t% passing\n0,4\t100\n0,2\t50\n0,1\t0\n",           // tabs, descending
             "Sieve (\u00b5m),Percent finer\n100,0%\n200,50 %\n400,100%\n",       // percent signs
             "\"Sieve, no.\",Size (mm),Passing\n1,0.1,0\n2,0.2,50\n3,0.4,100\n",  // quotes
             "Grain size;Finer by mass\n100 um;0 %\n200 um;50 %\n0.4 mm;100 %\n", // units at every number
             "sieve [um];Cumulative retained [%]\r\n400;0\r\n200;50\r\n100;100\r\n",
             "d [mm];retained [%];passing [%];;\n0,4;0;100;;\n0,2;50;50;;\n0,1;50;0;;\n",     // empty cells
             ";\r\nd [mm];passing [%]\r\n0,4;100\r\n; \r\n0,2;50\r\n0,1;0\r\n;\r\n\"\";\r\n", // empty rows
             "sieve [mm],retained on sieve [%]\n0.4,0\n0.2,50\n0.1,50\npan,0\n",
             "sieve [mm],retained on sieve [g]\n0.4,0\n0.2,150\n0.1,150\npan,0\n", // weighed
             "Sieve (mm);Mass retained on sieve (kg)\nPan;0\n0,1;0,15\n0,2;0,15\n0,4;0\n",
             "size_mm,mass_retained_on_sieve_g\n0.4,0\n0.2,150\n0.1,150\npan,0\n",
             "sieve [mm],cumulative mass retained [g]\n0.4,0\n0.2,150\n0.1,300\npan,300\n",
             "sieve [mm],cumulative retained [%]\n0.4,0\n0.2,50\n0.1,100\npan,100\n",
             "Sieve (mm);Individual retained (%)\n0,1;50,004\n0,2;50\n0,4;0\n", // rounded
             "d [um],passing\n0.1 mm,0\n200,50\n400,100\n",                     // a number's own unit counts
             "d_mm,passing_percent\n0.1,0\n0.2,50\n0.4,100\n",                  // as scripts name columns
             "particle size um,finer pct\n100,0\n200,50\n400,100\n",
             "\"d [mm]\";\"passing [%]\"\n\"0,1\";\"0\"\n\"0,2\";\"50\"\n\"0,4\";\"100\"\n",
         }) {
        const Parsed parsed = parse(text);
        ASSERT_TRUE(parsed.grading) << text << render(parsed.problems);
        EXPECT_EQ(parsed.grading->diameter, sizes) << text;
        EXPECT_EQ(parsed.grading->passing, shares) << text;
    }
    const std::string path = data_folder() + "/data/marked.csv";
    std::ofstream(path) << "\xEF\xBB\xBF"
                        << "d [mm],passing [%]\n0.1,0\n0.2,50\n0.4,100\n"; // a byte order mark
    EXPECT_EQ(read_grading(path).diameter, sizes);
}

struct WrongGrading {
    std::string code;
    int line, column;
    std::string words, text;
};

TEST(ReadGrading, ErrorsNameFileLineValueAndExpectation) {
    const std::vector<WrongGrading> wrongs{
        {"E503", 4, 6, "30 % passes 0.4 mm, but 50 % passes the smaller 0.2 mm",
         "d,passing\n0.1,0\n0.2,50\n0.40,30\n0.5,100\n"},
        {"E503", 2, 5, "cumulative retained [%]", "d,passing\n0.1,90\n0.2,50\n0.4,0\n"},
        {"E504", 4, 5, "-20 % passing", "d,retained on sieve\n0.4,20\n0.2,50\n0.1,50\n"},
        {"E503", 4, 1, "0.15 mm is next to 0.2 mm", "d,passing\n0.1,0\n0.2,50\n0.15,60\n0.5,100\n"},
        {"E503", 3, 1, "each once", "d,passing\n0.1,0\n0.1,50\n0.2,100\n"},
        {"E504", 2, 1, "-0.1 mm", "d,passing\n-0.1,0\n0.2,100\n"},
        {"E504", 2, 1, "sizes are above 0", "d,passing\n0,5\n0.2,100\n"},
        {"E504", 3, 5, "120 %", "d,passing\n0.1,0\n0.2,120\n"},
        {"E504", 2, 5, "-5 %", "d,passing\n0.1,-5\n0.2,100\n"},
        {"E504", 2, 5, "nothing passes", "d,passing\n0.1,5\n0.2,100\n"},
        {"E504", 3, 5, "everything passes", "d,passing\n0.1,0\n0.2,95\n"},
        {"E504", 2, 1, "`d [um]`", "d,passing\n63,0\n4000,100\n"},
        {"E504", 3, 3, "`passing [-]`", "d,passing [%]\n0.1,0\n4,1\n"},
        {"E502", 3, 5, "\"nan\" is not a number", "d,passing\n0.1,0\n0.2,nan\n"},
        {"E502", 3, 1, "\"abc\" is not a number", "d,passing\n0.1,0\nabc,50\n"},
        {"E505", 0, 0, "at least two points", "d,passing\n0.1,0\n0.2,\n"},
        {"E502", 3, 1, "3 values where the header names 2 columns", "d,passing\n0.1,0\n0,2,50\n"},
        {"E502", 2, 1, "has its own unit", "d,passing\n100 um,0\n0.2,100\n"}, // the other line has none
        {"E502", 3, 5, "has its own unit", "d,passing [-]\n0.1,0\n0.2,100 %\n"},
        {"E502", 2, 3, "a pressure", "d,passing\n1,0 kPa\n2,100 kPa\n"},
        {"E502", 2, 1, "decimal comma, columns are separated by ;", "d,passing\n0,1,0,5\n0,2,100,0\n"},
        {"E502", 3, 1, "write a decimal point", "d,passing\n0.1,0\n\"1,000\",100\n"},
        {"E502", 3, 1, "the same mark everywhere", "d;passing\n0.1;0\n1,000;100\n"},
        {"E505", 0, 0, "at least two points", "d;passing\n4;100\npan;0\n"},
        {"E506", 1, 12, "with [g] where masses", "sieve [mm],retained [g]\n0.2,10\n0.1,30\n"},
        {"E504", 3, 1, "no line `pan`", "sieve [mm],retained on sieve [g]\n0.2,0\n0.1,30\n"},
        {"E504", 4, 1, "0 or more", "sieve [mm],retained on sieve [g]\n0.2,-1\n0.1,30\npan,0\n"},
        {"E504", 4, 1, "not all 0", "sieve [mm],retained on sieve [g]\n0.2,0\n0.1,0\npan,0\n"},
        {"E504", 3, 5, "starts at 40 % passing",
         "sieve [mm],cumulative retained [g]\n0.2,0\n0.1,30\npan,20\n"}, // of its own mass
        {"E504", 3, 5, "starts at 40 % passing", "sieve [mm],retained on sieve [g]\n0.2,0\n0.1,60\npan,40\n"},
        {"E506", 1, 3, "`d` and `size` mean the same", "d,size,passing\n0.1,1,0\n"},
        {"E506", 1, 3, "is a mass", "d,passing [g]\n0.1,0\n0.2,100\n"},
        {"E505", 0, 0, "empty", ""},
        {"E505", 0, 0, "empty", "# nothing\n\n"},
        {"E505", 0, 0, "at least two points", "d,passing\n0.1,0\n"},
        {"E506", 1, 1, "do not show which are the sizes", "0.1,0\n0.2,60\n"},
        {"E506", 1, 1, "the first line names the columns", "Borehole 3\nfoo,bar\n0.1,0\n0.2,100\n"},
        {"E506", 1, 1, "`passing` is missing", "d,note\n0.2,good\n"},
        {"E506", 1, 1, "is a pressure", "d [kPa],passing\n0.2,100\n"},
        {"E505", 0, 0, "empty", "\xFF\xFE"},
        {"E100", 0, 0, "UTF-16", "\xFF\xFE\x64"},
        {"E100", 1, 3, "zero bytes", std::string("d,\0", 3)},
    };
    for (const WrongGrading& wrong : wrongs) {
        const Parsed parsed = parse(wrong.text);
        EXPECT_FALSE(parsed.grading);
        const Diagnostic found = find_problem(parsed.problems, wrong.code);
        EXPECT_EQ(found.line, wrong.line) << wrong.text << found.message;
        EXPECT_EQ(found.column, wrong.column) << wrong.text;
        EXPECT_EQ(found.file, "sand.csv");
        EXPECT_NE((found.message + " " + found.help).find(wrong.words), std::string::npos)
            << found.message << found.help;
    }
}

TEST(ReadGrading, AllBadLinesAreReportedAtOnce) {
    const Parsed parsed = parse("d [mm],passing\nx,0\n0.2,y\n0.3,100,7\n");
    ASSERT_EQ(parsed.problems.size(), 3U);
    EXPECT_EQ(parsed.problems[2].line, 4);
}

TEST(ReadGrading, ABadCurveOfACaseIsReportedInItsOwnFile) {
    std::ofstream(data_folder() + "/data/bad.csv") << "d [mm],passing\n0.1,0\n0.2,70\n0.3,60\n0.4,100\n";
    std::string text = good_case;
    text.replace(text.find("sand.csv"), 8, "bad.csv");
    const auto list = problems_of(text + "[contact]\nmodulus = 1\n");
    EXPECT_EQ(list.size(), 2U) << render(list);
    const Diagnostic found = find_problem(list, "E503");
    EXPECT_TRUE(found.file.ends_with("data/bad.csv")) << found.file;
    EXPECT_EQ(found.line, 4);
    EXPECT_EQ(found.source_line, "0.3,60");
}

TEST(ReadGrading, ACaseNamesTheColumnsOfAFile) {
    std::ofstream(data_folder() + "/data/named.csv") << "A,B,C\n100,1,0\n200,7,50\n400,3,100\n";
    std::string text = good_case;
    text.replace(text.find("\"data/sand.csv\""), 15, R"({ file = "data/named.csv", size = "A:um", passing = "C" })");
    EXPECT_TRUE(problems_of(text).empty()) << render(problems_of(text));
    text.replace(text.find("A:um"), 4, "D:um");
    EXPECT_NE(render(problems_of(text)).find("there is no column `D`"), std::string::npos);
    text.replace(text.find("size ="), 6, "sizs =");
    EXPECT_NE(render(problems_of(text)).find("`sizs` of a grading in a file"), std::string::npos);
}

TEST(ReadGrading, ReadsTheExamplesCurve) {
    const auto grading = read_grading(test::in_checkout("examples/fontainebleau-2016/data/fontainebleau.csv"));
    EXPECT_EQ(grading.diameter.front(), 1e-4);
    EXPECT_EQ(grading.diameter.size(), 7U);
    EXPECT_THROW(read_grading("/nowhere.csv"), IoError);
}

} // namespace
