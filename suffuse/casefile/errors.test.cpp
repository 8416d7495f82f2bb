// Every class of error in a case, at its exact place.
#include "suffuse/casefile/case_for_tests.hpp"
#include "suffuse/casefile/explain.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace {

using namespace suffuse;
using namespace suffuse::casefile;
using namespace suffuse::casefile::testing;

struct Wrong {
    std::string code;
    int line, column, length;
    std::string expected; ///< part of message, help or label
    std::string text;
};

std::ostream& operator<<(std::ostream& out, const Wrong& wrong) {
    return out << wrong.code << " " << wrong.expected;
}

/// `good_case` with one line replaced; lines from 1.
std::string with_line(int line, const std::string& text) {
    std::string result;
    int number = 0;
    std::istringstream in(good_case);
    for (std::string one; std::getline(in, one);) {
        result += (++number == line ? text : one) + "\n";
    }
    return result;
}

std::string with_stage(const std::string& body) {
    return good_case + "[[study.one.stage]]\nname = \"x\"\n" + body;
}

class CaseErrors : public ::testing::TestWithParam<Wrong> {};

TEST_P(CaseErrors, StandAtTheirPlace) {
    const Wrong& wrong = GetParam();
    const Diagnostic found = find_problem(problems_of(wrong.text), wrong.code);
    EXPECT_EQ(found.line, wrong.line) << found.message;
    EXPECT_EQ(found.column, wrong.column);
    EXPECT_EQ(found.length, wrong.length);
    EXPECT_EQ(found.file, "case.toml");
    EXPECT_NE((found.message + " " + found.help + " " + found.label).find(wrong.expected), std::string::npos)
        << found.message << " " << found.help;
    EXPECT_TRUE(explain(found.code)) << found.code;
}

const std::vector<Wrong> reading = {
    {"E101", 2, 5, 1, "", "schema = 1\na = = 2\n"},
    {"E101", 2, 2, 1, "", "schema = 1\n[.a]\n"},
    {"E101", 1, 1, 1, "plain ASCII", "\u00e9 = 1\n"},
    {"E101", 2, 5, 1, "plain ASCII", "schema = 1\na = \ufeca\n"},
    {"E101", 2, 9, 1, "straight quote", "schema = 1\ntitle = \u201cx\"\n"},
    {"E101", 3, 8, 1, "redefine", "schema = 1\nseed = 1\nseed = 2\n"},
    {"E101", 1, 31, 1, "goes up to", "seed = 99999999999999999999999\n"},
    {"E101", 2, 16, 1, "write pressure = \"100 kPa\"", "schema = 1\npressure = 100 kPa # effective\n"},
    {"E101", 2, 9, 1, "quotes write title = \"sand\"", "schema = 1\ntitle = sand\n"},
    {"E101", 2, 13, 1, "decimal point", "schema = 1\ngradient = 0,05\n"},
    {"E101", 2, 11, 1, "not closed", "schema = 1\ntitle = \"x\nseed = 1\n"},
    {"E101", 2, 11, 1, "not closed", "schema = 1\ntitle = \"x"},
    {"E101", 2, 11, 1, "small letters", "schema = 1\nrestore = True\n"},
    {"E101", 2, 11, 1, "write / for", "schema = 1\npsd = \"C:\\sand.csv\"\n"},
};

const std::vector<Wrong> keys = {
    {"E203", 2, 1, 5, "`title`", with_line(1, "schema = 1\ntitel = \"x\"")},
    {"E203", 4, 11, 11, "`finer_than`", with_line(4, "fines = { finer_thann = \"1 mm\" }")},
    {"E203", 11, 1, 9, "`porosity`", with_line(10, "do = \"pack\"\nporosityy = 0.6")},
    {"E203", 15, 1, 6, "a stage that does \"erode\"", good_case + "passes = 2\n"},
    {"E203", 15, 2, 8, "unknown key `nonsense`", good_case + "[nonsense]\n"},
    {"E203", 8, 1, 12, "belongs in a soil or `prepared_as`", with_line(7, "particles = 500\nfines_contnt = \"20 %\"")},
    {"E203", 16, 1, 9, "belongs in [fluid]", good_case + "[contact]\nviscosity = \"1 Pa*s\"\n"},
    {"E201", 2, 7, 4, "needs a grading", with_line(3, "")},
    {"E207", 11, 1, 19, "`start_porosity`, and its protocol",
     with_line(14, "pressure = \"100 kPa\"\nstart_porosity = 0.4")},
    {"E207", 11, 1, 19, "the servo of protocol \"slow\" cannot",
     with_line(14, "pressure = \"100 kPa\"\nprotocol = \"slow\"\nshear_stresses = \"released\"")},
    {"E207", 15, 1, 19, "holds no stress", with_stage("do = \"settle\"\nshear_stresses = \"released\"\n")},
    {"E207", 15, 1, 19, "its inertial servo cannot",
     with_stage("do = \"settle\"\npressure = \"1 kPa\"\nshear_stresses = \"released\"\n"
                "servo = { kind = \"inertial\", mass = \"1 kg/m\" }\n")},
    {"E207", 15, 1, 19, "keeps to a `strain_ratio`, and gives none",
     with_stage("do = \"triaxial\"\npath = \"proportional\"\n")},
    {"E207", 15, 1, 19, "its path keeps to none", with_stage("do = \"triaxial\"\nstrain_ratio = 1\n")},
    {"E207", 15, 1, 19, "at a `deviator_stress` and at a `stress_ratio`",
     with_stage("do = \"triaxial\"\ndeviator_stress = \"50 kPa\"\nstress_ratio = 0.5\n")},
    {"E207", 15, 1, 19, "holds the deviator stress, and stops at another",
     with_stage("do = \"triaxial\"\npath = \"constant-deviator\"\ndeviator_stress = \"50 kPa\"\n")},
    {"E207", 15, 1, 19, "a drained test to a strain", with_stage("do = \"triaxial\"\npath = \"undrained\"\nb = 0.5\n")},
    {"E207", 15, 1, 19, "holds the deviator stress, and extends",
     with_stage("do = \"triaxial\"\npath = \"constant-deviator\"\ndirection = \"extension\"\n")},
    {"E207", 15, 1, 19, "gives no amplitude", with_stage("do = \"cyclic\"\n")},
    {"E207", 15, 1, 19, "a stress and a strain as its amplitude",
     with_stage("do = \"cyclic\"\ncsr = 0.2\nstrain_amplitude = \"1 %\"\n")},
    {"E207", 15, 1, 19, "imposes 6 % of strain from turn to turn, and would end at 5 % of it",
     with_stage("do = \"cyclic\"\nstrain_amplitude = \"3 %\"\n")},
    {"E312", 18, 7, 1, "`csr`", with_stage("do = \"cyclic\"\ncsr = 0\n")},
    {"E201", 15, 1, 19, "`stresses`", with_stage("do = \"oedometer\"\n")},
    {"E201", 11, 1, 19, "needs `pressure`", with_line(14, "")},
    {"E201", 5, 8, 3, "`particles`", with_line(7, "")},
    {"E201", 5, 8, 3, "needs `soil`", with_line(6, "")},
    {"E204", 12, 8, 7, "\"cloud\"", with_line(12, "name = \"cloud\"")},
    {"E209", 9, 8, 6, "cannot be the name", with_line(9, "name = \"../x\"")},
    {"E209", 9, 8, 12, "leave the .pvd out", with_line(9, "name = \"grains.pvd\"")},
    {"E209", 9, 8, 9, "leave the .py out", with_line(9, "name = \"view.py\"")},
    {"E401", 13, 8, 7, "\"cloud\"", with_line(13, "from = \"cluod\"\ndo = \"compact\"")},
    {"E401", 13, 8, 2, "starts from \"\", which is no stage", with_line(13, "from = \"\"\ndo = \"compact\"")},
    {"E402", 6, 8, 6, "known are sand", with_line(6, "soil = \"clay\"")},
    {"E403", 13, 8, 9, "does not come before", with_line(13, "from = \"initial\"\ndo = \"compact\"")},
    {"E403", 9, 8, 7, "nothing to start from", with_line(10, "do = \"settle\"")},
    {"E404", 2, 10, 6, "known are standard", with_line(1, "schema = 1\npreset = \"fast\"")},
    {"E407", 14, 27, 15, "can measure void-ratios",
     with_line(14, "measure = [\"void-ratios\", \"stress-strain\"]\npressure = \"100 kPa\"")},
    {"E206", 14, 12, 12, "\"void-ratios\"", with_line(14, "measure = [\"void-ratio\"]\npressure = \"100 kPa\"")},
    {"E501", 3, 7, 10, "no file", with_line(3, "psd = \"nope.csv\"")},
    {"E501", 16, 54, 10, "no file",
     good_case + "[report]\noverlay = { figure-2 = \"data/points.csv\", figure-3 = \"nope.csv\" }\n"},
};

const std::vector<Wrong> values = {
    {"E205", 7, 13, 6, "a whole number", with_line(7, "particles = \"many\"")},
    {"E205", 7, 13, 3, "a whole number", with_line(7, "particles = 2.5")},
    {"E205", 9, 8, 1, "a text in quotes", with_line(9, "name = 7")},
    {"E205", 4, 9, 2, "`fines` needs", with_line(4, "fines = 12")},
    {"E205", 18, 11, 3, "true or false", with_stage("do = \"flow\"\nrestore = \"x\"\ngradient = 0.1\n")},
    {"E206", 10, 6, 6, "\"pack\"", with_line(10, "do = \"pakc\"")},
    {"E206", 13, 6, 10, "known are", with_line(13, "do = \"percolat\"")},
    {"E206", 13, 6, 7, "\"triaxial\"", with_line(13, "do = \"triax\"")}, // begun, and not ended
    {"E203", 15, 2, 8, "[contact]", good_case + "[contacts]\n"},
    {"E312", 18, 11, 10, "compression is positive",
     with_stage("do = \"settle\"\nstress = [\"-100 kPa\", \"1 kPa\", \"-\"]\n")},
    {"E301", 14, 12, 9, "\"kPa\"", with_line(14, "pressure = \"100 kPq\"")},
    {"E301", 14, 12, 9, "decimal comma", with_line(14, "pressure = \"1,5 kPa\"")},
    {"E310", 14, 12, 3, "write \"100 kPa\" (or \"100 Pa\")", with_line(14, "pressure = 100")},
    {"E310", 14, 12, 5, "has no unit", with_line(14, "pressure = \"100\"")},
    {"E310", 16, 13, 5, "write \"0.001 Pa*s\" (or \"0.001 mPa*s\")", good_case + "[fluid]\nviscosity = 0.001\n"},
    {"E310", 16, 13, 1, "write \"1 mPa*s\" (or \"1 Pa*s\")", good_case + "[fluid]\nviscosity = 1\n"},
    {"E310", 16, 11, 1, "write \"1 g/cm^3\"; ", good_case + "[fluid]\ndensity = 1\n"},
    {"E310", 16, 11, 4, "write \"1000 kg/m^3\"; ", good_case + "[fluid]\ndensity = 1000\n"},
    {"E310", 16, 11, 4, "write \"2.65 g/cm^3\"; ", good_case + "[grain]\ndensity = 2.65\n"},
    {"E310", 16, 12, 3, "write \"0.6 rad\"", good_case + "[contact]\nfriction = 0.6\n"},
    {"E311", 14, 12, 8, "a length", with_line(14, "pressure = \"100 mm\"")},
    {"E312", 14, 12, 8, "above 0", with_line(14, "pressure = \"-10 Pa\"")},
    {"E312", 7, 13, 1, "at least 1", with_line(7, "particles = 0")},
    {"E312", 19, 10, 2, "20 percent is \"20 %\"", with_stage("do = \"triaxial\"\nfrom = \"initial\"\nstrain = 20\n")},
    {"E312", 1, 10, 1, "exactly 1", with_line(1, "schema = 2")},
    {"E313", 11, 12, 3, "finite", with_line(10, "do = \"pack\"\nporosity = nan")},
    {"E313", 11, 12, 3, "finite", with_line(10, "do = \"pack\"\nporosity = inf")},
    {"E312", 19, 13, 9, "no length", with_stage("do = \"flow\"\ngradient = 0.1\ndirection = [0, 0, 0]\n")},
    {"E205", 19, 13, 6, "three values", with_stage("do = \"flow\"\ngradient = 0.1\ndirection = [0, 0]\n")},
};

const std::vector<Wrong> contradictions = {
    {"E207", 4, 9, 46, "either `psd` or `finer_than`",
     with_line(4, "fines = { finer_than = \"1 mm\", psd = \"data/silt.csv\" }")},
    {"E205", 4, 9, 8, "the finest and the coarsest", with_line(4, "sizes = [\"1 mm\"]")},
    {"E205", 4, 9, 16, "the finest and the coarsest", with_line(4, "sizes = [\"1 mm\", \"1 mm\"]")},
    {"E507", 4, 9, 16, "there is no mass between", with_line(4, "sizes = [\"5 mm\", \"9 mm\"]")},
    {"E508", 4, 13, 23, "does not show the median", with_line(4, "surrogate = { finer_than = \"9 mm\" }")},
    {"E201", 4, 13, 18, "`finer_than`", with_line(4, "surrogate = { size_ratio = 5 }")},
    {"E207", 4, 13, 25, "also `fines_content`",
     with_line(4, "surrogate = { finer_than = \"0.3 mm\" }\nfines_content = \"20 %\"")},
    {"E207", 2, 7, 4, "no `psd`", with_line(3, "sizes = [\"1 um\", \"9 mm\"]\ncoarse = { psd = \"data/sand.csv\" }")},
    {"E207", 2, 7, 4, "second grading", with_line(4, "fines = { psd = \"data/silt.csv\" }")},
    {"E201", 2, 7, 4, "`fines_content`", with_line(3, "coarse = { psd = \"data/sand.csv\" }")},
    {"E207", 5, 17, 6, "which fixes its fines content", with_line(5, "fines_content = \"20 %\"")},
    {"E207", 7, 28, 6, "which fixes its fines content",
     with_line(7, "sweep = { fines_content = [\"20 %\"] }\nparticles = 20000")},
    {"E207", 17, 8, 9, "makes its own sample", with_stage("from = \"initial\"\ndo = \"pack\"\n")},
    {"E207", 19, 10, 23, "both `pressure` and `stress`",
     with_stage("do = \"settle\"\npressure = \"1 kPa\"\nstress = [\"1 kPa\", \"-\", \"1 kPa\"]\n")},
    {"E207", 15, 1, 19, "neither a stress nor a strain rate along y",
     with_stage("do = \"advance\"\nsteps = 1\nstress = [\"1 kPa\", \"-\", \"1 kPa\"]\n")},
    {"E207", 15, 1, 19, "does not say how the cell moves", with_stage("do = \"advance\"\nsteps = 1\n")},
    {"E207", 15, 1, 19, "both a stress and a strain rate along x",
     with_stage("do = \"advance\"\nsteps = 1\nstress = [\"1 kPa\", \"1 kPa\", \"1 kPa\"]\nstrain_rate = [\"1 1/s\", "
                "\"-\", \"-\"]\n")},
    {"E201", 18, 9, 21, "`mass`", with_stage("do = \"settle\"\nservo = { kind = \"inertial\" }\n")},
    {"E207", 18, 12, 40, "`rule` belongs to by = \"velocity\"",
     with_stage("do = \"erode\"\ndetached = { by = \"displacement\", rule = \"rising\" }\n")},
    {"E201", 18, 12, 18, "needs a speed", with_stage("do = \"erode\"\ndetached = { rule = \"above\" }\n")},
    {"E301", 18, 37, 5, "`over`", with_stage("do = \"erode\"\ndetached = { rule = \"above\", over = \"1 d\" }\n")},
    {"E203", 8, 11, 10, "cannot be swept", with_line(7, "particles = 20000\nsweep = { gradientss = [1] }")},
    {"E203", 8, 11, 21, "cannot be swept",
     with_line(7, "particles = 20000\nsweep = { \"stage.none.gradient\" = [1] }")},
    {"E312", 8, 33, 6, "above 0", with_line(7, "particles = 20000\nsweep = { finer_than = [\"1 mm\", \"0 mm\"] }")},
};

INSTANTIATE_TEST_SUITE_P(Reading, CaseErrors, ::testing::ValuesIn(reading));
INSTANTIATE_TEST_SUITE_P(Keys, CaseErrors, ::testing::ValuesIn(keys));
INSTANTIATE_TEST_SUITE_P(Values, CaseErrors, ::testing::ValuesIn(values));
INSTANTIATE_TEST_SUITE_P(Contradictions, CaseErrors, ::testing::ValuesIn(contradictions));

TEST(CaseErrors, TheGoodCaseHasNone) {
    EXPECT_EQ(render(problems_of(good_case)), "no problems\n");
}

TEST(CaseErrors, AllComeAtOnceInTheOrderOfTheFile) {
    const auto list = problems_of(R"(schema = 1
titel = "x"
[contact]
modulus = 356
dampnig = 0.2
[soil.dyke]
psd = "nope.csv"
[study.erosion]
soil = "dike"
particles = 0
[[study.erosion.stage]]
name = "cloud"
do = "pakc"
[[study.erosion.stage]]
name = "cloud"
do = "compact"
pressure = "100 mm"
from = 3
)");
    std::vector<int> lines;
    for (const Diagnostic& d : list) {
        lines.push_back(d.line);
    }
    EXPECT_EQ(lines, (std::vector<int>{2, 4, 5, 7, 9, 10, 13, 15, 17, 18})) << render(list);
}

TEST(CaseErrors, ElasticSpheresNeedTheirModulusAndHaveNoShearRatioNorAdhesion) {
    const auto expected = [](const std::string& contact, const std::string& code) {
        return find_problem(problems_of(good_case + "[contact]\nlaw = \"hertz-mindlin\"\n" + contact), code).message;
    };
    EXPECT_NE(expected("", "E201").find("modulus"), std::string::npos);
    const std::string glass = "modulus = \"70 GPa\"\n";
    EXPECT_NE(expected(glass + "shear_ratio = 0.8\n", "E207").find("`shear_ratio`"), std::string::npos);
    EXPECT_NE(expected(glass + "adhesion.normal = \"1 MPa\"\n", "E207").find("adhere"), std::string::npos);
    EXPECT_NE(expected(glass + "poisson = 0.6\n", "E205").find("poisson"), std::string::npos);
    EXPECT_EQ(problems_of(good_case + "[contact]\nlaw = \"hertz-mindlin\"\n" + glass + "poisson = 0.2\n").size(), 0U);
    const std::string linear = good_case + "[contact]\npoisson = 0.2\n";
    EXPECT_NE(find_problem(problems_of(linear), "E207").message.find("`poisson`"), std::string::npos);
}

TEST(CaseErrors, TheExceptionCarriesTextListFileAndLine) {
    try {
        load("schema = 1\nx = 1\n");
        FAIL() << "nothing was thrown";
    } catch (const CaseError& error) {
        EXPECT_EQ(error.file, "case.toml");
        EXPECT_NE(std::string(error.what()).find("unknown key `x`"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("nothing was run"), std::string::npos);
        EXPECT_FALSE(dynamic_cast<const CaseProblems&>(error).problems.empty());
    }
}

TEST(HostileInput, IsAnErrorAndNothingWorse) {
    const std::string deep_table = "[" + std::string(200'000, 'a') + "]\n";
    std::string dotted = "a", arrays = "a = ", tables = "a = ";
    for (int k = 0; k < 100'000; ++k) {
        dotted += ".a";
        arrays += "[";
        tables += "{a=";
    }
    const std::vector<std::string> texts{
        "",
        "\n\n",
        "# only a comment\n",
        std::string("schema = 1\0x", 12),
        "\xFF\xFEs\0c\0",
        "a = \"\xFF\"\n",
        "\xEF\xBB",
        "[.a]",
        "a = \ufeca",
        "a = \u202e1",
        "[",
        "]",
        "=",
        "\"",
        "'''",
        "\"\"\"",
        "a = \"\\",
        "a.b = 1\na.b.c = 2\n",
        deep_table,
        dotted + " = 1",
        "[" + dotted + "]",
        "[[" + dotted + "]]",
        arrays,
        tables,
        "a = 1e999999\n",
        "schema = 99999999999999999999\n",
        "seed = -9223372036854775808\nschema = 1\n",
        "schema = 1979-05-27\n",
        "study = 1\nsoil = [1]\npresets = \"x\"\nschema = 1\n",
        "schema = 1\n[study]\na = 1\n[soil]\nb = []\n",
        "schema = 1\n[study.a]\nstage = [1, [2], {}]\n",
        "schema = 1\n[[study.a]]\n[[soil.a]]\n[[contact]]\n",
        "schema = 1\n[study.a]\nsweep = { particles = [[1], {}, 1979-05-27] }\nstage = []\n",
        "schema = 1\n[soil.\"\\u0000\"]\npsd = \"\\u0000\"\n[study.\"\"]\n[study.\"a/b\"]\n",
        "schema = 1\n[soil.a]\npsd = { d = [1, \"x\"], passing = [\"0 %\"] }\nfines = {}\ncoarse = {}\n",
        "schema = 1\n[soil.a]\npsd = \"/dev/zero\"\n",
        "schema = 1\n[soil.a]\npsd = \"data\"\n",
        good_case + "[presets.x]\nparticles = 1e30\nwatch = -1\n[presets]\ny = 1\n",
        "schema = 1\n[study.a]\nreplicates = 10000\nsweep = { particles = [1, 2, 3, 4], seed = [1, 2, 3] "
        "}\n[[study.a.stage]]\nname = \"a\"\ndo = \"pack\"\n",
    };
    for (const std::string& text : texts) {
        EXPECT_THROW(load(text), CaseProblems) << text.substr(0, 60);
    }
}

TEST(HostileInput, DeepKeysAreReportedWithTheirPlace) {
    std::string text = "schema = 1\nx = 1\n[a";
    for (int k = 0; k < 100'000; ++k) {
        text += ".a";
    }
    const Diagnostic found = find_problem(problems_of(text + "]\n"), "E101");
    EXPECT_EQ(found.line, 3);
    EXPECT_NE(found.message.find("32 parts"), std::string::npos);
}

TEST(HostileInput, ByteOrderMarkAndWindowsLinesAreFine) {
    std::string text;
    for (const char c : good_case) {
        text += c == '\n' ? std::string("\r\n") : std::string(1, c);
    }
    EXPECT_NO_THROW(load(text));
    EXPECT_NO_THROW(load("# \u00e9\u4e2d \u202e comment\ntitle = \"\u00e9\u4e2d\"\n" + good_case));
    EXPECT_NO_THROW(load("title = '''\n\u00e9 \"'''\n" + good_case));
}

} // namespace
