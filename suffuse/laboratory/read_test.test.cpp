// Records of laboratory tests: what is understood of them, and what is refused. Karlsruhe fine sand: tests/laboratory.

#include "suffuse/laboratory/read_test.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/laboratory/test_heading.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include "tests/support/temp_folder.hpp"
#include <algorithm>
#include <string>

namespace suffuse::laboratory {
namespace {

using enum TestKind;

TestRecord parse(const std::string& text, TestKind kind, std::optional<bool> contraction = {}) {
    return parse_test(
        std::make_shared<const Source>(Source{"t.csv", text}), {.kind = kind, .contraction_is_positive = contraction}
    );
}

std::string refusal(const std::string& text, TestKind kind) {
    try {
        parse(text, kind);
    } catch (const CaseError& error) {
        return error.what();
    }
    return "";
}

void expect_words(const std::string& words, const std::string& text) {
    EXPECT_NE(text.find(words), std::string::npos) << text;
}

std::string findings(const TestRecord& record, bool assumed) {
    std::string text;
    for (const Finding& finding : record.findings) {
        text += finding.is_assumed == assumed ? finding.text + "\n" : "";
    }
    return text;
}

double value(const TestRecord& record, Quantity quantity, std::size_t row) {
    const TestColumn* column = record.find(quantity);
    return column == nullptr || row >= column->values.size() ? -999 : column->values[row];
}

TestRecord read_form(const std::string& name, TestKind kind) {
    return read_test(test::in_checkout("tests/laboratory/" + name), {.kind = kind});
}

TEST(ReadTest, DrainedTriaxialTestsOfKarlsruheFineSand) {
    const TestRecord record = read_form("karlsruhe-drained.csv", Triaxial);
    ASSERT_EQ(record.tests.size(), 2U);
    EXPECT_EQ(record.tests[0].name, "TMD1");
    EXPECT_EQ(record.tests[1].end, record.rows());
    EXPECT_DOUBLE_EQ(value(record, Quantity::AxialStrain, 1), 0.0481e-2); // second row of the file
    EXPECT_DOUBLE_EQ(value(record, Quantity::VolumetricStrain, 1), 0.0266e-2);
    EXPECT_DOUBLE_EQ(value(record, Quantity::VoidRatio, 1), 0.9956);
    EXPECT_DOUBLE_EQ(value(record, Quantity::DeviatorStress, 1), 9.68e3);
    EXPECT_DOUBLE_EQ(value(record, Quantity::MeanStress, 1), 53.82e3);
    expect_words(
        "\"epsv [%]\" is positive in contraction: the void ratio falls where it rises", findings(record, false)
    );
    expect_words("\"eps1 [%]\" is positive in compression", findings(record, false));
    expect_words("agree: q rises by 3 with p", findings(record, false));
    EXPECT_EQ(findings(record, true), "\"p [kPa]\" is effective\n");
}

TEST(ReadTest, UndrainedTriaxialTestsOfKarlsruheFineSand) {
    const TestRecord record = read_form("karlsruhe-undrained.csv", Triaxial);
    ASSERT_EQ(record.tests.size(), 2U); // TMU1 compression, TMU7 extension
    EXPECT_DOUBLE_EQ(value(record, Quantity::PorePressure, 0), 199.51e3);
    EXPECT_DOUBLE_EQ(value(record, Quantity::RadialStress, 0), 100.355e3);
    EXPECT_EQ(record.find(Quantity::MeanStress)->is_effective, true);
    expect_words("\"p [kPa]\" is \"sigma3' [kPa]\" + \"q [kPa]\"/3", findings(record, false));
    EXPECT_EQ(findings(record, true), "");
}

TEST(ReadTest, OedometerTestsOfKarlsruheFineSand) {
    const TestRecord record = read_form("karlsruhe-oedometer.csv", Oedometer);
    ASSERT_EQ(record.tests.size(), 2U);
    EXPECT_DOUBLE_EQ(value(record, Quantity::AxialStress, 2), 0.445e3);
    EXPECT_DOUBLE_EQ(value(record, Quantity::AxialStrain, 2), 0.371e-2);
    expect_words("\"eps1 [%]\" is positive in contraction: the void ratio", findings(record, false));
    EXPECT_EQ(findings(record, true), "\"sigma1 [kPa]\" is effective\n");
}

TEST(ReadTest, APermeameterTestWithDischargeAndMass) {
    const TestRecord record = read_form("permeameter.csv", Permeameter);
    ASSERT_EQ(record.tests.size(), 1U);
    EXPECT_DOUBLE_EQ(value(record, Quantity::Time, 1), 600); // 10 min
    EXPECT_DOUBLE_EQ(value(record, Quantity::Gradient, 2), 0.2);
    EXPECT_NEAR(value(record, Quantity::Discharge, 1), 30e-6 / 60, 1e-18); // 30 mL/min
    EXPECT_DOUBLE_EQ(value(record, Quantity::Mass, 3), 1.4e-3);
    expect_words("counts from the beginning: by its heading", findings(record, false));
    EXPECT_EQ(record.titles.size(), 1U);
}

TEST(ReadTest, HeadingsAreWrittenInManyWays) {
    const auto quantity = [](std::string_view text, TestKind kind = Triaxial) {
        return read_test_heading(text, kind).quantity;
    };
    for (const char* text : {"eps1 [%]", "Axial strain (%)", "ε1 [%]", "eps_1, %", "axial strain eps1 (%)", "ε₁ [-]"}) {
        EXPECT_EQ(quantity(text), Quantity::AxialStrain) << text;
    }
    for (const char* text : {"p' [kPa]", "Mean effective stress p' (kPa)", "p_kPa", "mean stress [MPa]"}) {
        EXPECT_EQ(quantity(text), Quantity::MeanStress) << text;
    }
    for (const char* text : {"q [kPa]", "Deviator stress, kPa", "σ1 − σ3 (kPa)", "(sigma1 - sigma3) [kPa]"}) {
        EXPECT_EQ(quantity(text), Quantity::DeviatorStress) << text;
    }
    EXPECT_EQ(quantity("sigma1' \u2013 sigma3' [kPa]"), Quantity::DeviatorStress);
    EXPECT_EQ(quantity("deviator stress / q [kPa]"), Quantity::DeviatorStress);
    for (const char* text : {"σ1+σ3 [kPa]", "σ1'/σ3' [-]", "(sigma1 + sigma3) (kPa)", "sigma1:sigma3", "σ1 / σ3 [1]"}) {
        EXPECT_EQ(quantity(text), std::nullopt) << text;
    }
    EXPECT_EQ(quantity("Q [mL/min]", Permeameter), Quantity::Discharge);
    EXPECT_EQ(quantity("cumulative eroded mass (g)", Permeameter), Quantity::Mass);
    EXPECT_EQ(quantity("remarks"), std::nullopt);
    EXPECT_TRUE(read_test_heading("sigma3' [kPa]", Triaxial).is_effective);
    EXPECT_TRUE(read_test_heading("total mean stress [kPa]", Triaxial).is_total);
    EXPECT_EQ(read_test_heading("q_kPa", Triaxial).unit, "kPa");
    EXPECT_TRUE(read_test_heading("Test No.", Triaxial).names_tests);
}

TEST(ReadTest, ARatioOfStressesIsNotRead) {
    const TestRecord record = parse("eps1 [%],q [kPa],p' [kPa],σ1'/σ3' [-]\n0,0,100,1\n1,100,133.33,2\n", Triaxial);
    EXPECT_EQ(record.unread, std::vector<std::string>{"σ1'/σ3' [-]"});
    expect_words(
        "a triaxial test has a column of deviator stress or axial stress; found none",
        refusal("eps1 [%],σ1+σ3 [kPa],e\n0,200,0.7\n1,300,0.7\n", Triaxial)
    );
}

TEST(ReadTest, UnitsMayBeInALineBelowTheHeadings) {
    const TestRecord record = parse("Loose sand\neps1;q\n[%];[kPa]\n0;0\n0,5;10\n", Triaxial); // decimal commas
    EXPECT_DOUBLE_EQ(value(record, Quantity::AxialStrain, 1), 0.5e-2);
    EXPECT_DOUBLE_EQ(value(record, Quantity::DeviatorStress, 1), 10e3);
    expect_words("keep one", refusal("eps1 [%],q [kPa]\n%,MPa\n0,0\n1,5\n", Triaxial));
    EXPECT_NEAR(value(parse("time [h],i,Q [cm³/s]\n0,0.1,1\n2,0.2,2\n", Permeameter), Quantity::Time, 1), 7200, 1e-9);
}

TEST(ReadTest, WhatIsMissingOrUnclearIsRefusedWithItsPlace) {
    expect_words(
        "t.csv:1:10: column \"q\" has no unit; write it in the heading: q [kPa]",
        refusal("eps1 [%],q\n0,0\n1,5\n", Triaxial)
    );
    expect_words(
        "found the unit \"mm\", expected one of deviator stress, such as kPa",
        refusal("eps1 [%],q [mm]\n0,0\n1,5\n", Triaxial)
    );
    expect_words(
        "t.csv:3:3: column \"q [kPa]\": found \"5 MPa\", expected a number",
        refusal("eps1 [%],q [kPa]\n0,0\n1,5 MPa\n", Triaxial)
    );
    expect_words("found no heading with two of: axial strain", refusal("a,b\n1,2\n", Triaxial));
    expect_words("has a column of deviator stress or axial stress", refusal("eps1 [%],u [kPa]\n1,2\n", Triaxial));
    expect_words("two columns are mean stress", refusal("eps1 [%],q [kPa],p [kPa],p' [kPa]\n0,0,1,1\n", Triaxial));
    expect_words("found no row of numbers", refusal("eps1 [%],q [kPa]\n", Triaxial));
    expect_words(
        "t.csv:4:1: test \"A\" goes on behind another one",
        refusal("test,eps1 [%],q [kPa]\nA,0,0\nB,0,0\nA,1,5\n", Triaxial)
    );
    expect_words("it may be in percent or a fraction", refusal("eps1,q [kPa]\n0,0\n0.5,5\n", Triaxial));
    expect_words("sort the rows", refusal("time [s],i,Q [mL/s]\n5,1,1\n4,1,1\n", Permeameter));
}

const std::string strains = "eps1 [%],epsv [%],q [kPa]";

TEST(ReadTest, TheVoidRatioDecidesOnSignAndUnitOfAStrain) {
    // e0 = 1: a contraction of 1 % is a change of 0.02.
    const std::string dilating = "eps1 [%],epsv,q [kPa],e\n0,0,0,1\n1,-1,50,1.02\n2,-2,90,1.04\n";
    const TestRecord negative = parse(dilating, Triaxial);
    EXPECT_DOUBLE_EQ(value(negative, Quantity::VolumetricStrain, 2), -0.02);
    expect_words("is in percent: the void ratio changes as much", findings(negative, false));
    const TestRecord positive = parse("eps1 [%],epsv,q [kPa],e\n0,0,0,1\n1,0.01,50,1.02\n2,.02,90,1.04\n", Triaxial);
    EXPECT_DOUBLE_EQ(value(positive, Quantity::VolumetricStrain, 2), -0.02); // dilation was positive in the file
    expect_words("contradict one another", refusal("eps1 [%],epsv [%],q [kPa],e\n0,0,0,1\n1,1,5,1.3\n", Triaxial));
}

TEST(ReadTest, WithoutAVoidRatioTheHeadingOrTheOptionDecidesOnVolumetricStrain) {
    expect_words("or give --contraction", refusal(strains + "\n0,0,0\n1,1,5\n", Triaxial));
    EXPECT_DOUBLE_EQ(value(parse(strains + "\n0,0,0\n1,1,5\n", Triaxial, false), Quantity::VolumetricStrain, 1), -0.01);
    EXPECT_DOUBLE_EQ(value(parse(strains + "\n0,0,0\n1,1,5\n", Triaxial, true), Quantity::VolumetricStrain, 1), 0.01);
    const TestRecord named = parse("eps1 [%],volumetric strain (dilation) [%],q [kPa]\n0,0,0\n1,1,5\n", Triaxial);
    EXPECT_DOUBLE_EQ(value(named, Quantity::VolumetricStrain, 1), -0.01);
}

TEST(ReadTest, WorkDecidesOnTheSignOfAxialStrain) {
    const TestRecord record = parse("eps1 [%],q [kPa]\n0,0\n-1,50\n-2,90\n", Triaxial);
    EXPECT_DOUBLE_EQ(value(record, Quantity::AxialStrain, 2), 0.02);
    expect_words("is positive in extension", findings(record, false));
    EXPECT_DOUBLE_EQ(value(parse("sigma1' [kPa],eps1 [%]\n10,0\n100,-1\n", Oedometer), Quantity::AxialStrain, 1), 0.01);
}

TEST(ReadTest, UnloadingIsNotTakenForExtension) {
    const std::string rows = "\n5,200\n4.9,120\n4.8,60\n4.7,10\n"; // unloaded from q = 200 kPa
    expect_words("may be positive in compression or in extension", refusal("eps1 [%],q [kPa]" + rows, Triaxial));
    const TestRecord named = parse("eps1 (compression positive) [%],q [kPa]" + rows, Triaxial);
    EXPECT_DOUBLE_EQ(value(named, Quantity::AxialStrain, 3), 0.047);
    expect_words(
        "\"eps1 (compression positive) [%]\" is positive in compression: by its heading", findings(named, false)
    );
    const std::string loading = "eps1 [%],q [kPa]\n0,50\n1,150\n2,200\n"; // from q > 0
    EXPECT_DOUBLE_EQ(value(parse(loading, Triaxial), Quantity::AxialStrain, 2), 0.02);
    expect_words(
        "is positive in extension by its heading, and in compression by the work of \"q [kPa]\"",
        refusal("eps1 [%] (extension positive),q [kPa]\n0,0\n1,50\n", Triaxial)
    );
}

TEST(ReadTest, WorkIsThatOfTheDeviatorStressThatAxialAndRadialStressMake) {
    // A loose undrained sample: its effective axial stress falls while it is compressed.
    const std::string head = "eps1 [%],sigma1' [kPa],sigma3' [kPa],u [kPa]\n",
                      rows = "0,100,100,0\n1,80,40,70\n3,60,20,95\n";
    EXPECT_DOUBLE_EQ(value(parse(head + rows, Triaxial), Quantity::AxialStrain, 2), 0.03);
    const std::string alone = "eps1 [%],sigma1' [kPa],u [kPa]\n0,100,0\n1,80,70\n3,60,95\n";
    EXPECT_DOUBLE_EQ(value(parse(alone, Triaxial), Quantity::AxialStrain, 2), 0.03);
}

TEST(ReadTest, AHeadingSaysItsSignInManyWays) {
    for (const char* text :
         {"volumetric strain (contraction positive) [%]", "Volumetric strain [%] (contraction positive)",
          "epsv, %, contraction positive", "volumetric strain (contraction +ve) [%]", "epsv [%] (dilation negative)",
          "epsv (dilation -ve) [%]", "epsv (expansion -) [%]", "volumetric strain (compression is positive) [%]",
          "epsv [%] (contractive)"}) {
        const TestHeading heading = read_test_heading(text, Triaxial);
        EXPECT_EQ(heading.quantity, Quantity::VolumetricStrain) << text;
        EXPECT_EQ(heading.unit, "%") << text;
        EXPECT_TRUE(heading.contracts && !heading.expands) << text;
    }
    for (const char* text : {"epsv (contraction -) [%]", "volumetric strain (dilation positive) [%]"}) {
        EXPECT_TRUE(read_test_heading(text, Triaxial).expands && !read_test_heading(text, Triaxial).contracts) << text;
    }
    EXPECT_EQ(read_test_heading("p [kPa] (effective)", Triaxial).unit, "kPa");
    EXPECT_EQ(read_test_heading("filter-velocity [mm/s]", Permeameter).quantity, Quantity::Velocity);
}

TEST(ReadTest, ASignThatContradictsTheVoidRatioIsRefused) {
    const std::string rows = "\n0,0,0,1\n1,-1,50,1.02\n2,-2,90,1.04\n";
    expect_words(
        "and in contraction by the void ratio", refusal("eps1 [%],epsv (dilation) [%],q [kPa],e" + rows, Triaxial)
    );
    const auto specified = [&](bool positive) {
        return parse("eps1 [%],epsv [%],q [kPa],e" + rows, Triaxial, positive);
    };
    EXPECT_DOUBLE_EQ(value(specified(false), Quantity::VolumetricStrain, 1), -0.01);
    expect_words("not the specified one", findings(specified(false), true));
    EXPECT_EQ(findings(specified(true), true), "");
}

TEST(ReadTest, NumbersThatNoSoilHasAreRefusedWithTheirPlace) {
    expect_words(
        "t.csv:3:1: column \"eps1 [-]\": found 5.2, and no axial strain of a soil exceeds 1",
        refusal("eps1 [-],q [kPa]\n0,0\n5.2,50\n", Triaxial)
    );
    expect_words("found 250 %, and no volumetric", refusal("eps1 [%],epsv [%],q [kPa]\n0,0,0\n1,250,50\n", Triaxial));
    expect_words(
        "found 150, and no axial strain of a soil exceeds 100", refusal("eps1,q [kPa]\n0,0\n150,5\n", Triaxial)
    );
    expect_words("found 200 MPa, and no deviator stress", refusal("eps1 [%],q [MPa]\n0,0\n1,200\n", Triaxial));
    expect_words("found -2000, and no hydraulic gradient", refusal("i,Q [mL/s]\n1,1\n-2000,1\n", Permeameter));
    EXPECT_EQ(refusal("eps1,q [kPa]\n0,0\n25,5\n", Triaxial), "");
}

TEST(ReadTest, StressesThatBelongTogetherShowWhichAreEffective) {
    const std::string head = "eps1 [%],q [kPa],p [kPa],sigma3 [kPa],u [kPa]\n";
    const TestRecord total = parse(head + "0,0,300,100,200\n1,60,310,90,200\n", Triaxial); // p = s3 + q/3 + u
    EXPECT_EQ(total.find(Quantity::MeanStress)->is_effective, false);
    EXPECT_EQ(total.find(Quantity::RadialStress)->is_effective, true);
    expect_words("may be effective or total", refusal(head + "0,0,100,100,200\n1,60,110,90,200\n", Triaxial));
    expect_words("they are s and t", refusal(head + "0,0,100,100,200\n1,60,160,100,200\n", Triaxial)); // p = s3 + q
    expect_words("contradict one another", refusal(head + "0,0,100,100,200\n1,60,500,100,200\n", Triaxial));
    expect_words("contradict one another", refusal(head + "0,0,100,100,200\n1,60,132,100,200\n", Triaxial)); // 120
    expect_words(
        "they may be half the difference and half the sum",
        refusal("eps1 [%],epsv [%],q [kPa],p [kPa],e\n0,0,0,100,1\n1,1,50,151,0.98\n", Triaxial)
    );
    expect_words(
        "is effective by its heading, and total by \"sigma3' [kPa]\"",
        refusal("eps1 [%],q [kPa],p' [kPa],sigma3' [kPa],u [kPa]\n0,0,300,100,200\n1,60,310,90,200\n", Triaxial)
    );
    expect_words(
        "is total by its heading, and effective by",
        refusal("eps1 [%],q [kPa],p' [kPa],total sigma3 [kPa],u [kPa]\n0,0,100,100,200\n1,60,110,90,200\n", Triaxial)
    );
    expect_words(
        "compression seems to be negative", refusal("eps1 [%],q [kPa],p [kPa]\n0,0,-100\n-1,-60,-120\n", Triaxial)
    );
}

TEST(ReadTest, HalfSumsAndHalfDifferencesOfStressesAreFoundByTheirSlope) {
    const auto with_slope = [](double slope, double volume) {
        std::string text = "eps1 [%],epsv (contraction positive) [%],q [kPa],p [kPa]\n";
        for (int k = 0; k <= 5; ++k) {
            text += fmt::format("{},{},{},{}\n", k, volume * k, slope * 10 * k, 100 + 10 * k);
        }
        return text;
    };
    expect_words("rises by 2 with \"p [kPa]\", and by 3", refusal(with_slope(2, 0.2), Triaxial));
    expect_words("write p = s - q/6", refusal(with_slope(2, 0.2), Triaxial));
    expect_words("write q = 2 t; or", refusal(with_slope(1.5, 0.2), Triaxial));
    EXPECT_EQ(refusal(with_slope(3, 0.2), Triaxial), "");
    const TestRecord between = parse(with_slope(2.5, 0.2), Triaxial);
    expect_words("q rises by 2.5 with p, and by 3 in a drained test", findings(between, true));
    EXPECT_EQ(refusal(with_slope(1.5, 0), Triaxial), "") << "undrained, its path rises along the critical state line";
}

TEST(ReadTest, HeadingsOfHalfSumsAndHalfDifferencesAreTurnedIntoQAndP) {
    const std::string rows = "\n0,0,0,100\n1,0.2,50,150\n2,0.1,80,180\n"; // at a radial stress of 100 kPa
    const TestRecord record = parse("eps1 [%],epsv (contraction) [%],t [kPa],s' [kPa]" + rows, Triaxial);
    EXPECT_DOUBLE_EQ(value(record, Quantity::DeviatorStress, 2), 160e3);
    EXPECT_NEAR(value(record, Quantity::MeanStress, 2), (260e3 + 2 * 100e3) / 3, 1e-6);
    EXPECT_EQ(record.find(Quantity::MeanStress)->is_effective, true);
    expect_words("agree: q rises by 3 with p", findings(record, false));
    expect_words("add a column of q or t", refusal("eps1 [%],sigma1 [kPa],s' [kPa]\n0,100,100\n1,200,150\n", Triaxial));
    EXPECT_EQ(parse("t [min],eps1 [%],q [kPa]\n0,0,0\n1,1,5\n", Triaxial).columns.front().quantity, Quantity::Time);
}

TEST(ReadTest, StressesThatContradictOneAnotherAreRefused) {
    const std::string head = "eps1 [%],q [kPa],sigma3' [kPa],sigma1' [kPa]\n";
    EXPECT_EQ(refusal(head + "0,0,100,100\n1,100,100,200\n5,200,100,301\n", Triaxial), "");
    expect_words(
        "\"sigma1' [kPa]\", \"sigma3' [kPa]\" and \"q [kPa]\" contradict one another",
        refusal(head + "0,0,100,100\n1,100,100,300\n5,200,100,650\n", Triaxial)
    );
    const std::string pore = "eps1 [%],q [kPa],total sigma1 [kPa],sigma3' [kPa],u [kPa]\n";
    EXPECT_EQ(refusal(pore + "0,0,150,100,50\n1,60,220,90,70\n", Triaxial), "");
    for (const std::string other : {"p' [kPa],sigma3' [kPa]", "p' [kPa],q [kPa]"}) {
        expect_words(
            "contradict one another",
            refusal("eps1 [%],sigma1' [kPa]," + other + "\n0,100,100,100\n1,200,300,100\n", Triaxial)
        );
    }
}

TEST(ReadTest, AVoidRatioInPercentNeedsItsUnit) {
    const std::string rows = "\n100,80\n200,75\n400,70\n";
    expect_words(
        "t.csv:2:5: column \"e\": found 80, and no void ratio of a soil exceeds 20",
        refusal("sigma1 [kPa],e" + rows, Oedometer)
    );
    expect_words("void ratios of 0 or less", refusal("sigma1 [kPa],e\n100,0.8\n200,-0.8\n", Oedometer));
    EXPECT_DOUBLE_EQ(value(parse("sigma1 [kPa],e [%]" + rows, Oedometer), Quantity::VoidRatio, 0), 0.8);
    expect_words("an oedometer test has", refusal("e,eps1 [%]\n1,0\n0.9,5\n", Oedometer));
}

TEST(ReadTest, MarksBetweenThousandsAreNoDecimalSigns) {
    const std::string head = "Axial strain (%)\tDeviator stress (kPa)\n", rows = "1\t1,250\n2\t2,500\n5\t3,100\n";
    expect_words(
        "t.csv:3:3: column \"Deviator stress (kPa)\": \"1,250\" may be 1250 or 1.25",
        refusal(head + "0\t0\n" + rows, Triaxial)
    );
    expect_words("may be 1250 or 1.25", refusal("eps1 [%],q [kPa]\n0,0\n1,\"1,250\"\n", Triaxial));
    const TestRecord thousands = parse(head + "0.5\t0\n" + rows, Triaxial);
    EXPECT_DOUBLE_EQ(value(thousands, Quantity::DeviatorStress, 1), 1250e3);
    expect_words("\"1,250\" in \"Deviator stress (kPa)\" is 1250", findings(thousands, false));
    const TestRecord decimals = parse(head + "0,5\t0\n" + rows, Triaxial);
    EXPECT_DOUBLE_EQ(value(decimals, Quantity::DeviatorStress, 1), 1.25e3);
    const TestRecord strain = parse("eps1 [%];q [kPa]\n1,250;100\n2,500;200\n", Triaxial); // no 1250 %
    EXPECT_DOUBLE_EQ(value(strain, Quantity::AxialStrain, 0), 0.0125);
    const TestRecord commas = parse("eps1 [%],q [kPa]\n1,1.250\n2,2.500\n", Triaxial);
    EXPECT_DOUBLE_EQ(value(commas, Quantity::DeviatorStress, 0), 1.25e3);
}

TEST(ReadTest, AMassThatFallsCountsFromReadingToReading) {
    const std::string head = "time [min],i,mass [g]\n";
    const TestRecord parts = parse(head + "0,0.1,0\n1,0.2,2\n2,0.3,1\n", Permeameter);
    EXPECT_DOUBLE_EQ(value(parts, Quantity::Mass, 2), 3e-3);
    const TestRecord whole = parse(head + "0,0.1,0\n1,0.2,2\n2,0.3,3\n", Permeameter);
    EXPECT_DOUBLE_EQ(value(whole, Quantity::Mass, 2), 3e-3);
    expect_words("counts from the beginning: it never falls", findings(whole, true));
    expect_words("cumulative, and falls", refusal("time [min],i,cumulative mass [g]\n0,1,2\n1,1,1\n", Permeameter));
}

TEST(ReadTest, ThePageListsEveryQuantity) {
    const std::string page = test::read_all(test::in_checkout("docs/laboratory-tests.md"));
    for (const QuantityRow& row : quantity_rows()) {
        std::vector<std::string_view> tests;
        for (const TestKind kind : row.tests) {
            tests.push_back(test_kind_names()[static_cast<std::size_t>(kind)]);
        }
        const std::string line = fmt::format(
            "| {} | `{}` | {} | {} |", row.name, fmt::join(row.words, "`, `"), row.usual_unit, fmt::join(tests, ", ")
        );
        EXPECT_NE(page.find("\n" + line + "\n"), std::string::npos) << "docs/laboratory-tests.md lacks\n" << line;
    }
}

} // namespace
} // namespace suffuse::laboratory
