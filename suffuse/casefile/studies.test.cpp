// Stages that start from stages, sweeps and replicates.
#include "suffuse/base/constants.hpp"
#include "suffuse/casefile/bind.hpp"
#include "suffuse/casefile/case_for_tests.hpp"
#include "suffuse/casefile/dependencies.hpp"
#include "suffuse/casefile/prepared_as.hpp"

#include <gtest/gtest.h>

namespace {

using namespace suffuse;
using namespace suffuse::casefile;
using namespace suffuse::casefile::testing;

std::vector<int> parents(const Variant& variant) {
    std::vector<int> rows;
    for (const Stage& stage : variant.stages) {
        rows.push_back(stage.parent);
    }
    return rows;
}

std::string stage(const std::string& name, const std::string& verb, const std::string& rest = "") {
    return "[[study.one.stage]]\nname = \"" + name + "\"\ndo = \"" + verb + "\"\n" + rest;
}

std::vector<std::string> folders(const Study& study) {
    std::vector<std::string> list;
    for (const Variant& variant : study.variants) {
        list.push_back(variant.folder);
    }
    return list;
}

TEST(Studies, AStageStartsFromTheOneBeforeUnlessItSaysOtherwise) {
    const Case c = load(
        good_case + stage("probe", "detach", "restore = true\n") + stage("seep", "flow", "gradient = 0.1\n") +
        stage("settled", "settle") + stage("back", "settle", "from = \"cloud\"\nrestore = true\n") +
        stage("after", "settle")
    );
    // detach and flow leave the state as it was, and so does `restore`
    EXPECT_EQ(parents(c.studies[0].variants[0]), (std::vector<int>{-1, 0, 1, 1, 1, 0, 0}));
}

TEST(Studies, SweepsMultiplyAndReplicatesHaveTheirOwnSeeds) {
    const Case c = load(full_case);
    const Study& study = c.studies[0];
    EXPECT_EQ(
        folders(study),
        (std::vector<std::string>{
            "main/fc=10/pressure=50kPa/rep=1", "main/fc=10/pressure=50kPa/rep=2", "main/fc=10/pressure=100kPa/rep=1",
            "main/fc=10/pressure=100kPa/rep=2", "main/fc=20/pressure=50kPa/rep=1", "main/fc=20/pressure=50kPa/rep=2",
            "main/fc=20/pressure=100kPa/rep=1", "main/fc=20/pressure=100kPa/rep=2"})
    );
    EXPECT_EQ(study.variants[0].seed, 42U);
    EXPECT_EQ(study.variants[4].seed, 42U) << "sweep values are compared on the same random numbers";
    EXPECT_NE(study.variants[1].seed, 42U);
    EXPECT_EQ(study.variants[0].soil->fines_content, 0.1);
    EXPECT_EQ(study.variants[4].soil->fines_content, 0.2);
    EXPECT_EQ(std::get<packing::CompactSpec>(study.variants[0].stages[1].spec).pressure, 5e4);
    EXPECT_EQ(std::get<packing::CompactSpec>(study.variants[2].stages[1].spec).pressure, 1e5);
    EXPECT_EQ(std::get<packing::CompactSpec>(study.stages[1].spec).pressure, 1e5) << "as written";
}

TEST(Studies, ValuesThatWouldShareAFolderAreRefusedByName) {
    std::string text = good_case;
    const std::string sweep = "sweep = { particles = [100, 200, 100] }\n";
    text.insert(text.find("particles"), sweep);
    const Diagnostic twice = find_problem(problems_of(text), "E204");
    EXPECT_NE(twice.message.find("100 and 100 of `particles` would share"), std::string::npos) << twice.message;
    text.replace(text.find(sweep), sweep.size(), "sweep = { fines_content = [0.2, 0.2000000001, \"20 %\"] }\n");
    const std::vector<Diagnostic> problems = problems_of(text);
    EXPECT_EQ(std::count_if(problems.begin(), problems.end(), [](const auto& d) { return d.code == "E204"; }), 2);
    EXPECT_TRUE(std::ranges::any_of(problems, [](const Diagnostic& problem) {
        return problem.message == "0.2 and \"20 %\" of `fines_content` would share the folder fc=20";
    }));
    const Diagnostic close = find_problem(problems, "E204");
    EXPECT_NE(close.message.find("0.2 and 0.2000000001 of"), std::string::npos) << close.message;
    EXPECT_EQ(close.column, 33);
}

TEST(Studies, ValuesThatAreTheSameAreRefusedHoweverTheyAreWritten) {
    const std::string sweep = "sweep = { \"stage.initial.pressure\" = [\"50 kPa\", \"0.05 MPa\", \"60 kPa\"] }\n";
    std::string text = good_case;
    text.insert(text.find("particles"), sweep);
    const Diagnostic same = find_problem(problems_of(text), "E204");
    EXPECT_EQ(same.message, "\"50 kPa\" and \"0.05 MPa\" of `stage.initial.pressure` are the same");
    EXPECT_EQ(same.help, "keep one of them");
}

TEST(Studies, ASweptContactKeyHoldsForItsCopyAndOtherKeysStay) {
    std::string text = good_case + "[contact]\nmodulus = \"200 MPa\"\n";
    text.replace(
        text.find("particles"), 0,
        "sweep = { \"contact.friction\" = [\"20 deg\", \"30 deg\"], \"contact.adhesion.normal\" = [\"0 kPa\", \"1 "
        "kPa\"], \"contact.damping\" = [0.3] }\n"
    );
    const Case c = load(text);
    const std::vector<Variant>& copies = c.studies[0].variants;
    EXPECT_EQ(
        folders(c.studies[0]),
        (std::vector<std::string>{
            "one/friction=20deg/normal=0kPa/damping=0.3", "one/friction=20deg/normal=1kPa/damping=0.3",
            "one/friction=30deg/normal=0kPa/damping=0.3", "one/friction=30deg/normal=1kPa/damping=0.3"})
    );
    EXPECT_EQ(copies[1].material.friction, radians(20));
    EXPECT_EQ(copies[2].material.friction, radians(30));
    EXPECT_EQ(copies[1].material.adhesion_normal, 1000);
    EXPECT_EQ(copies[2].material.adhesion_normal, 0);
    EXPECT_EQ(copies[3].material.modulus, 200e6);
    EXPECT_EQ(copies[3].damping, 0.3);
    EXPECT_EQ(c.material.friction, radians(37)) << "of studies that do not sweep it";
    const Stage& compacted = copies[0].stages[1];
    EXPECT_NE(dependencies_of(c, copies[0], compacted), dependencies_of(c, copies[2], compacted)) << "one cache entry";
}

TEST(Studies, ASweptContactKeyIsCheckedLikeAnyOther) {
    const auto problem = [](const std::string& sweep, const std::string& code) {
        std::string text = good_case;
        text.replace(text.find("particles"), 0, "sweep = { " + sweep + " }\n");
        return find_problem(problems_of(text), code);
    };
    EXPECT_EQ(problem("\"contact.frction\" = [0.3]", "E203").line, 7);
    EXPECT_EQ(problem("\"contact.friction\" = [\"95 deg\"]", "E312").line, 7);
    EXPECT_EQ(problem("\"contact.friction\" = [0.3]", "E310").line, 7);
}

TEST(Studies, OnlyRunsAStageForItsValues) {
    const Study study = load(full_case).studies[0];
    EXPECT_EQ(study.variants[0].stages.size(), 16U);
    EXPECT_EQ(study.variants[4].stages.size(), 15U);
    EXPECT_EQ(study.variants[4].stages[2].name, "erosion");
    EXPECT_EQ(parents(study.variants[4]), (std::vector<int>{-1, 0, 1, 2, 1, 4, 4, 1, 1, 1, 1, 1, 1, 1, 1}));
}

TEST(Studies, AStageForAKeyThatIsNotSweptIsRefused) {
    const Diagnostic found = find_problem(
        problems_of(
            replaced(full_case, "only = { fines_content = [0.1] }", "only = { \"contact.friction\" = [\"30 deg\"] }")
        ),
        "E409"
    );
    EXPECT_GT(found.line, 1);
    EXPECT_NE(
        found.message.find("stage \"probe\" would never run: it is for values of `contact.friction`"), std::string::npos
    );
    EXPECT_NE(found.help.find("`fines_content`"), std::string::npos) << found.help;
    const std::string alone = good_case + stage("x", "settle", "only = { fines_content = [0.1] }\n");
    EXPECT_NE(find_problem(problems_of(alone), "E409").help.find("sweeps nothing"), std::string::npos);
}

TEST(Studies, AStageForAValueThatIsNotSweptIsReportedWithThoseThatAre) {
    const auto with = [](const std::string& values) {
        return problems_of(
            replaced(full_case, "only = { fines_content = [0.1] }", "only = { fines_content = " + values + " }")
        );
    };
    const Diagnostic found = find_problem(with("[0.1, \"15 %\"]"), "W409");
    EXPECT_TRUE(found.is_warning);
    EXPECT_NE(found.message.find("\"probe\" is for \"15 %\" of `fines_content`"), std::string::npos) << found.message;
    EXPECT_NE(found.help.find("10 %"), std::string::npos) << found.help;
    EXPECT_EQ(find_problem(with("[\"10 %\", 0.2]"), "W409").message.find("no W409"), 0U) << "however they are written";
}

TEST(Studies, AStudyWithoutSweepHasOneVariant) {
    const Case c = load(good_case);
    EXPECT_EQ(folders(c.studies[0]), (std::vector<std::string>{"one"}));
    EXPECT_EQ(c.studies[0].variants[0].particles, 20'000);
    ASSERT_TRUE(c.studies[0].variants[0].soil);
}

const std::string with_size = R"(schema = 1
[soil.two]
coarse = { psd = "data/sand.csv" }
fines = { psd = "data/silt.csv" }
fines_content = "20 %"
grading_tolerance = "10 %"
[study.one]
soil = "two"
sample_size = { coarse_grains = 3_000, cell_width = 100 }
sweep = { fines_content = ["10 %", "40 %"] }
[[study.one.stage]]
name = "cloud"
do = "pack"
)";

TEST(Studies, SampleSizeGivesEachVariantItsOwnNumberOfGrains) {
    const Study study = load(with_size).studies[0];
    EXPECT_EQ(study.particles, 0);
    ASSERT_EQ(study.variants.size(), 2U);
    for (const Variant& variant : study.variants) {
        EXPECT_EQ(
            variant.particles, grains::size_sample(*variant.soil, {.coarse_grains = 3000, .cell_width = 100}).particles
        );
        EXPECT_EQ(variant.sized_by, grains::SizedBy::CoarseGrains);
    }
    EXPECT_GT(study.variants[1].particles, study.variants[0].particles);
    const Study few = load(with_size + "[presets.few]\ncoarse_grains = 1000\nat_least = 10\n", {"few", {}}).studies[0];
    // Of 3,000 and of 1,000 coarse grains, each with its fines: rounded to whole grains.
    EXPECT_LE(std::abs(3 * few.variants[0].particles - study.variants[0].particles), 3);
}

TEST(Studies, SampleSizeStandsInPlaceOfParticlesAndNeedsTwoFractions) {
    std::string both = with_size;
    both.replace(both.find("sample_size"), 0, "particles = 100\n");
    EXPECT_NE(find_problem(problems_of(both), "E207").message.find("both"), std::string::npos);
    std::string one = good_case;
    one.replace(one.find("particles = 20000"), 17, "sample_size = { coarse_grains = 200 }");
    EXPECT_NE(find_problem(problems_of(one), "E207").message.find("one grading"), std::string::npos);
    std::string none = good_case;
    none.replace(none.find("particles = 20000"), 17, "");
    EXPECT_NE(find_problem(problems_of(none), "E201").help.find("sample_size"), std::string::npos);
}

TEST(Sweeps, OfASettlingsPressureSurviveWritingAndReading) {
    for (const std::string table : {"sweep", "rows"}) {
        std::string text = good_case + "[study.swept]\nsoil = \"sand\"\nparticles = 3000\n";
        text += table + " = { \"stage.rest.pressure\" = [\"100 kPa\", \"9 kPa\"] }\n"
                        "[[study.swept.stage]]\nname = \"cloud\"\ndo = \"pack\"\n"
                        "[[study.swept.stage]]\nname = \"rest\"\ndo = \"settle\"\n"
                        "pressure = \"50 kPa\"\n";
        const std::string once = resolved_toml(load(text, {"", {}, {"swept"}}));
        const Case back = load(once);
        EXPECT_EQ(resolved_toml(back), once);
        const auto& rest = std::get<dem::SettleSpec>(back.studies[0].variants[1].stages[1].spec);
        EXPECT_EQ(rest.loading.axis[2].value, 9e3);
    }
}

TEST(Sweeps, OverTheSoilNeedNoOtherAndGiveEachSampleItsOwn) {
    const std::string text = good_case + "[soil.silt]\npsd = { d = [\"0.1 mm\", \"0.2 mm\"], passing = [\"0 %\", "
                                         "\"100 %\"] }\n[study.swept]\nparticles = 3000\n"
                                         "sweep = { soil = [\"sand\", \"silt\"] }\n"
                                         "[[study.swept.stage]]\nname = \"cloud\"\ndo = \"pack\"\n";
    const Case c = load(text, {"", {}, {"swept"}});
    ASSERT_EQ(c.studies[0].variants.size(), 2U);
    EXPECT_EQ(c.studies[0].variants[0].soil_name, "sand");
    EXPECT_EQ(c.studies[0].variants[1].soil_name, "silt");
    EXPECT_EQ(c.studies[0].variants[1].soil->whole->diameter.back(), 0.2e-3);
}

TEST(Studies, RequestedByNameAreTheOnlyOnes) {
    const std::string two = good_case + "[study.two]\nsoil = \"sand\"\nparticles = 3000\n[[study.two.stage]]\nname = "
                                        "\"cloud\"\ndo = \"pack\"\n";
    ASSERT_EQ(load(two).studies.size(), 2U);
    const Case one = load(two, {"", {}, {"two"}});
    ASSERT_EQ(one.studies.size(), 1U);
    EXPECT_EQ(one.studies[0].name, "two");
    EXPECT_EQ(load(resolved_toml(one)).studies.size(), 1U);
    EXPECT_EQ(load(two, {"", {}, {"two", "one"}}).studies.size(), 2U);
}

TEST(Studies, RequestedThatTheCaseDoesNotHaveAreReported) {
    const Diagnostic found = find_problem(problems_of(good_case, {"", {}, {"one", "three"}}), "E408");
    EXPECT_EQ(found.file, "--study");
    EXPECT_EQ(found.message, "there is no study \"three\"");
    EXPECT_EQ(found.help, "known are one");
}

const std::string prepared_as = R"([[study.one.stage]]
name = "loose"
do = "compact"
pressure = "100 kPa"
intergranular_void_ratio = 0.9
prepared_as = { fines_content = "10 %" }
)";

TEST(Studies, ASampleIsPreparedAsOneThatTheSweepHas) {
    const Study study = load(with_size + prepared_as).studies[0];
    const Variant &by = study.variants[0], &other = study.variants[1];
    EXPECT_FALSE(is_prepared_as_another(by, by.stages[1]));
    EXPECT_TRUE(is_prepared_as_another(other, other.stages[1]));
    EXPECT_EQ(sample_to_prepare_by(study, other, other.stages[1]), &by);
    const std::string missing = replaced(with_size + prepared_as, "= \"10 %\" }", "= \"15 %\" }");
    const Diagnostic problem = find_problem(problems_of(missing), "E406");
    EXPECT_NE(problem.message.find("15 %"), std::string::npos) << problem.message;
    EXPECT_EQ(problem.line, 19);
}

TEST(Studies, APreparationThatNobodySearchesCannotBeTaken) {
    const std::string bare = replaced(with_size + prepared_as, "intergranular_void_ratio = 0.9\n", "");
    EXPECT_NE(find_problem(problems_of(bare), "E207").message.find("there is no search"), std::string::npos);
}

TEST(Studies, ASkeletonMadeFirstExcludesWhatPushesAllGrainsTogether) {
    const auto with = [](const std::string& more) {
        return with_size + "[[study.one.stage]]\nname = \"loose\"\ndo = \"compact\"\npressure = \"100 kPa\"\n" +
               "prepare = { skeleton_first = true }\n" + more;
    };
    EXPECT_EQ(load(with("intergranular_void_ratio = 0.9\n")).studies[0].variants.size(), 2U);
    for (const std::string more :
         {"protocol = \"swift\"\n", "void_ratio = 0.6\n",
          "intergranular_void_ratio = 0.9\nprepared_as = { fines_content = \"10 %\" }\n"}) {
        EXPECT_EQ(find_problem(problems_of(with(more)), "E207").code, "E207") << more;
    }
}

TEST(Studies, TheSizeRatioOfASurrogateCanBeSwept) {
    const std::string text = std::string(good_case).replace(
        good_case.find("fines ="), std::string("fines = { finer_than = \"0.15 mm\" }").size(),
        "surrogate = { finer_than = \"0.2 mm\" }"
    );
    const std::string swept = std::string(text).replace(
        text.find("particles = 20000"), 17, "particles = 20000\nsweep = { size_ratio = [2, 3] }"
    );
    const Case c = load(swept);
    ASSERT_EQ(c.studies[0].variants.size(), 2U);
    EXPECT_EQ(c.studies[0].variants[0].soil->surrogate->size_ratio, 2);
    EXPECT_EQ(c.studies[0].variants[1].soil->surrogate->size_ratio, 3);
    EXPECT_EQ(c.studies[0].variants[1].folder, "one/size_ratio=3");
    EXPECT_EQ(load(resolved_toml(c)).studies[0].variants[1].soil->surrogate->size_ratio, 3) << "and is written";
}

} // namespace
