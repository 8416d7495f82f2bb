// Curves of laboratories and of simulations, brought to one form: the values are known in closed form.

#include "suffuse/job/laboratory_curve.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/laboratory/read_test.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

namespace suffuse::job {
namespace {

using casefile::CalibrateTarget;
using casefile::CalibrateTest;

laboratory::TestRecord parsed(const std::string& text, const CalibrateTarget& target) {
    const bool is_oedometer = target.test == CalibrateTest::Oedometer;
    return laboratory::parse_test(
        std::make_shared<Source>(Source{"t.csv", text}),
        {.kind = is_oedometer ? laboratory::TestKind::Oedometer : laboratory::TestKind::Triaxial,
         .contraction_is_positive = true}
    );
}

LaboratoryCurve curve_of(const std::string& text, const CalibrateTarget& target) {
    return laboratory_curve(parsed(text, target), target);
}

CalibrateTarget target_of(CalibrateTest test) {
    CalibrateTarget target;
    target.name = "t";
    target.file = "t.csv";
    target.test = test;
    target.pressure = 100e3;
    return target;
}

std::string drained(const std::string& name, double slope) {
    std::string text;
    for (int k = 0; k <= 10; ++k) {
        text += fmt::format("{},{},{},{}\n", name, 1 + 2 * k, slope * k, 0.5 * k); // it begins at a strain of 1 %
    }
    return text;
}

const std::string drained_head = "test,axial strain [%],q [kPa],volumetric strain [%]\n";

} // namespace

TEST(LaboratoryCurve, IsOverThePressureAndSinceTheStart) {
    const CalibrateTarget target = target_of(CalibrateTest::Drained);
    const LaboratoryCurve curve = curve_of(drained_head + drained("a", 20), target);
    ASSERT_EQ(curve.form.grid.size(), 12U);
    EXPECT_DOUBLE_EQ(curve.form.grid.back(), 0.1) << "where the comparison ends, not the test";
    ASSERT_EQ(curve.values.size(), 24U);
    for (std::size_t k = 0; k < 12; ++k) {
        EXPECT_NEAR(curve.values[k], 10 * curve.form.grid[k], 1e-12);
        EXPECT_NEAR(curve.values[12 + k], 0.25 * curve.form.grid[k], 1e-12);
        EXPECT_NEAR(curve.deviations[k], 0.03 * 1, 1e-12) << "of the largest stress ratio";
        EXPECT_NEAR(curve.deviations[12 + k], 0.03 * 0.025, 1e-12);
        EXPECT_EQ(curve.rows[12 + k], static_cast<int>(12 + k));
    }
    EXPECT_EQ(curve.begins, std::vector<int>{12});
}

TEST(LaboratoryCurve, HasThePartsThatWereMeasured) {
    std::string text = "axial strain [%],q [kPa]\n";
    for (int k = 0; k <= 5; ++k) {
        text += fmt::format("{},{}\n", k, 30 * k);
    }
    const LaboratoryCurve curve = curve_of(text, target_of(CalibrateTest::Drained));
    EXPECT_EQ(curve.form.measured, std::vector{CurveQuantity::StressRatio});
    EXPECT_EQ(curve.form.parts.size(), 2U) << "simulations have the volumetric strain, too";
    EXPECT_DOUBLE_EQ(curve.form.grid.back(), 0.05) << "the end of the test";
    EXPECT_EQ(curve.values.size(), 12U);
}

TEST(LaboratoryCurve, IsOfTheTestThatTheTargetNames) {
    const std::string text = drained_head + drained("a", 20) + drained("b", 40);
    CalibrateTarget target = target_of(CalibrateTest::Drained);
    EXPECT_THROW(curve_of(text, target), CaseError);
    target.sample = "b";
    EXPECT_NEAR(curve_of(text, target).values[11], 2, 1e-12);
    target.sample = "c";
    try {
        curve_of(text, target);
        FAIL();
    } catch (const CaseError& error) {
        EXPECT_EQ(std::string(error.what()), "target \"t\": t.csv has no test \"c\"; its tests are \"a\" to \"b\"");
    }
}

TEST(LaboratoryCurve, IsRefusedWhereItsTestCannotHaveIt) {
    const auto refusal_of = [](const CalibrateTarget& target) -> std::string {
        try {
            curve_of(drained_head + drained("a", 20), target);
        } catch (const CaseError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_NE(
        refusal_of(target_of(CalibrateTest::Undrained)).find("volumetric strains of up to 5 %"), std::string::npos
    );
    CalibrateTarget target = target_of(CalibrateTest::Drained);
    target.pressure = 4e3; // q reaches 200 kPa
    EXPECT_NE(refusal_of(target).find("200 kPa, 50 times the `pressure` of 4 kPa"), std::string::npos);
    target.pressure = 10.1e3;
    EXPECT_EQ(refusal_of(target), "");
}

std::string refusal_of_text(const std::string& text, CalibrateTest test) {
    try {
        curve_of(text, target_of(test));
    } catch (const CaseError& error) {
        return error.what();
    }
    return "";
}

TEST(LaboratoryCurve, IsRefusedWhereItsTestBeganElsewhere) {
    std::string sheared = "axial strain [%],q [kPa]\n", constant = "axial strain [%],q [kPa],volumetric strain [%]\n";
    for (int k = 0; k <= 10; ++k) {
        sheared += fmt::format("{},{}\n", k, 50 + 5 * k);
        constant += fmt::format("{},{},0\n", k, 10 * k);
    }
    EXPECT_NE(
        refusal_of_text(sheared, CalibrateTest::Drained).find("begins at q = 50 kPa, and the test"), std::string::npos
    );
    EXPECT_NE(
        refusal_of_text(constant, CalibrateTest::Drained).find("has only zeros as volumetric strain where"),
        std::string::npos
    );
    std::string late_stress = "axial strain [%],q [kPa]\n", no_strain = "axial stress [kPa],axial strain [%]\n";
    for (int k = 0; k <= 20; ++k) {
        late_stress += fmt::format("{},{}\n", k, k > 10 ? 10 * k : 0); // beyond the 10 % that are compared
        no_strain += fmt::format("{},{}\n", 50 + 50 * k, k == 0 ? -1 : 0);
    }
    EXPECT_NE(
        refusal_of_text(late_stress, CalibrateTest::Drained).find("has only zeros as stress ratio where"),
        std::string::npos
    );
    EXPECT_NE(
        refusal_of_text(no_strain, CalibrateTest::Oedometer).find("has only zeros as axial strain where"),
        std::string::npos
    );
    const std::string late = "axial stress [kPa],axial strain [%]\n150,0\n300,1\n600,2\n";
    EXPECT_NE(
        refusal_of_text(late, CalibrateTest::Oedometer).find("begins at 150 kPa, above the `pressure` of 100 kPa"),
        std::string::npos
    );
}

TEST(LaboratoryCurve, IsRefusedWhereItsLateralStressIsNotThePressure) {
    const auto with_mean = [](double pressure, double slope) { // of q over p'
        std::string text = "axial strain [%],q [kPa],p' [kPa]\n";
        for (int k = 0; k <= 10; ++k) {
            text += fmt::format("{},{},{}\n", k, 12 * k, pressure + 12 * k / slope);
        }
        return text;
    };
    EXPECT_EQ(refusal_of_text(with_mean(100, 3), CalibrateTest::Drained), "");
    EXPECT_NE(
        refusal_of_text(with_mean(400, 3), CalibrateTest::Drained)
            .find("lateral stress of 400 kPa at an axial strain of 0"),
        std::string::npos
    );
    EXPECT_NE(
        refusal_of_text(with_mean(400, 3), CalibrateTest::Undrained).find("lateral stress of 400"), std::string::npos
    );
    EXPECT_NE(
        refusal_of_text(with_mean(100, 1e9), CalibrateTest::Drained)
            .find("lateral stress of 88 kPa at an axial strain of 3"),
        std::string::npos
    ) << "at a constant mean stress";
    EXPECT_EQ(refusal_of_text(with_mean(100, -3), CalibrateTest::Undrained), "");
}

TEST(LaboratoryCurve, OfAnOedometerUnderTotalStressesNeedsThePorePressure) {
    const std::string text = "total axial stress [kPa],axial strain [%]\n100,0\n200,1\n400,2\n";
    EXPECT_NE(
        refusal_of_text(text, CalibrateTest::Oedometer).find("has no column of pore pressure"), std::string::npos
    );
}

TEST(LaboratoryCurve, OfTotalAndEffectiveStressesIsThatOfTheEffectiveOnes) {
    std::string text =
        "axial strain [%],effective axial stress [kPa],total radial stress [kPa],pore pressure u [kPa]\n";
    std::string loaded = "total axial stress [kPa],axial strain [%],pore pressure u [kPa]\n";
    for (int k = 0; k <= 10; ++k) {
        text += fmt::format("{},{},300,200\n", k, 100 + 20 * k);
        loaded += fmt::format("{},{},50\n", 150 + 40 * k, 0.1 * k);
    }
    const LaboratoryCurve curve = curve_of(text, target_of(CalibrateTest::Drained));
    EXPECT_NEAR(curve.values[11], 2, 1e-12) << "q = 200 kPa over 100 kPa";
    EXPECT_NEAR(curve_of(loaded, target_of(CalibrateTest::Oedometer)).form.grid.back(), 500e3, 1e-6);
}

TEST(LaboratoryCurve, OfAnUndrainedTestHasTheEffectiveMeanStressThatWaterLeaves) {
    std::string text = "axial strain [%],q [kPa],pore pressure u [kPa]\n";
    for (int k = 0; k <= 10; ++k) {
        text += fmt::format("{},{},{}\n", k, 6 * k, 200 + 5 * k);
    }
    const LaboratoryCurve curve = curve_of(text, target_of(CalibrateTest::Undrained));
    ASSERT_EQ(curve.form.measured.back(), CurveQuantity::MeanStressRatio);
    EXPECT_NEAR(curve.values[23], 1 + 0.6 / 3 - 0.5, 1e-12); // p0 + q/3 - u, over p0
}

TEST(LaboratoryCurve, OfAnUndrainedTestHasTheMeasuredMeanStressWhereTheRadialStressChanges) {
    for (const char* stress : {"total p", "total sigma3", "total sigma1", "p'", "sigma3'", "sigma1'"}) {
        std::string text = fmt::format("axial strain [%],q [kPa],pore pressure u [kPa],{} [kPa]\n", stress);
        for (int k = 0; k <= 10; ++k) {
            const int u = 200 + 4 * k, q = 9 * k, p = 300; // both p = 300 kPa and p' = 100 - 4 k
            const std::string_view name = stress;
            const int total = name.ends_with("1") || name.ends_with("1'")   ? p + 2 * q / 3
                              : name.ends_with("3") || name.ends_with("3'") ? p - q / 3
                                                                            : p;
            text += fmt::format("{},{},{},{}\n", k, q, u, name.ends_with("'") ? total - u : total);
        }
        const LaboratoryCurve curve = curve_of(text, target_of(CalibrateTest::Undrained));
        ASSERT_EQ(curve.form.measured.back(), CurveQuantity::MeanStressRatio);
        EXPECT_NEAR(curve.values[23], 0.6, 1e-12) << stress;
    }
}

TEST(LaboratoryCurve, OfAnOedometerIsThatOfItsFirstLoading) {
    std::string text = "axial stress [kPa],axial strain [%]\n";
    for (const int stress : {10, 20, 40, 80, 160, 320, 640}) {
        text += fmt::format("{},{}\n", stress, std::log10(stress / 10.0));
    }
    text += "100,1.7\n10,1.6\n"; // unloaded
    const LaboratoryCurve curve = curve_of(text, target_of(CalibrateTest::Oedometer));
    EXPECT_NEAR(curve.form.grid.front(), 100e3, 1e-6);
    EXPECT_NEAR(curve.form.grid.back(), 640e3, 1e-6);
    EXPECT_NEAR(curve.values.front(), 0, 1e-15);
    EXPECT_NEAR(curve.values.back(), 0.01 * std::log10(6.4), 1e-12);
    CalibrateTarget high = target_of(CalibrateTest::Oedometer);
    high.pressure = 600e3;
    EXPECT_THROW(curve_of(text, high), CaseError);
}

TEST(SimulatedCurve, HasStrainsOverTheLengthOfTheStart) {
    const CalibrateTarget target = target_of(CalibrateTest::Drained);
    const LaboratoryCurve laboratory = curve_of(drained_head + drained("a", 20), target);
    std::vector<triaxial::PathRow> rows;
    for (int k = 0; k <= 200; ++k) { // the same test as a simulation records it: fine enough that chords are arcs
        const double strain = 0.0006 * k;
        triaxial::PathRow& row = rows.emplace_back();
        row.axial_strain = -std::log1p(-strain);
        row.volumetric_strain = -std::log1p(-0.25 * strain);
        row.deviator_stress = 10 * strain * target.pressure;
    }
    const std::vector<double> curve = simulated_curve(rows, laboratory.form, target);
    ASSERT_EQ(curve.size(), laboratory.values.size());
    for (std::size_t k = 0; k < curve.size(); ++k) {
        EXPECT_NEAR(curve[k], laboratory.values[k], 1e-10);
    }
}

TEST(SimulatedCurve, OfAnOedometerBeginsAtThePressure) {
    CurveForm form;
    form.grid = {100e3, 200e3, 400e3};
    form.parts = form.measured = {CurveQuantity::AxialStrain};
    std::vector<triaxial::PathRow> rows;
    for (const double stress : {100e3, 200e3, 400e3, 800e3}) {
        triaxial::PathRow& row = rows.emplace_back();
        row.stress(2, 2) = stress;
        row.axial_strain = -std::log1p(-1e-7 * stress);
    }
    const std::vector<double> curve = simulated_curve(rows, form, target_of(CalibrateTest::Oedometer));
    EXPECT_NEAR(curve[0], 0, 1e-15);
    EXPECT_NEAR(curve[1], 0.01, 1e-12);
    EXPECT_NEAR(curve[2], 0.03, 1e-12);
}

} // namespace suffuse::job
