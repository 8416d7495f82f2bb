#include "suffuse/figures/figures_strength.hpp"

#include "suffuse/figures/figure_guide.hpp"

#include <gtest/gtest.h>

namespace suffuse::figures {
namespace {

std::vector<triaxial::PathRow> rising_to(double peak) {
    std::vector<triaxial::PathRow> rows(2);
    rows[1].axial_strain = 0.05;
    rows[1].deviator_stress = peak;
    return rows;
}

TEST(StrengthFigure, LaysTheTestBeforeAndAfterOverEachOtherSampleBySample) {
    casefile::Study study;
    const casefile::Stage before{.name = "shear-1", .spec = triaxial::TriaxialSpec{}};
    const casefile::Stage after{.name = "shear-2", .spec = triaxial::TriaxialSpec{}};
    const casefile::Stage other{.name = "shear-3", .spec = triaxial::TriaxialSpec{}};
    std::vector<casefile::Variant> variants(2);
    variants[1].replicate = 2;
    std::vector<record::FinishedStage> stages;
    for (const casefile::Variant& variant : variants) {
        for (const casefile::Stage* stage : {&before, &after, &other}) {
            stages.push_back({&study, &variant, stage, {}, {}});
            stages.back().findings.curve = rising_to(stage == &before ? 300e3 : 200e3);
        }
    }
    study::StrengthChange change;
    change.study = &study, change.variant = variants.data(), change.before = &before, change.after = &after;
    EXPECT_FALSE(strength_before_and_after({change}, stages)) << "a change that is undecided";
    change.peak_deviator = {
        study::scatter_of({300e3, 300e3}), study::scatter_of({200e3, 200e3}), study::scatter_of({-0.33, -0.33})};
    const Figure figure = strength_before_and_after({change}, stages).value();
    EXPECT_EQ(figure.table.rows(), 8U) << "two samples, two tests, two points: the third test is none of the pair";
    EXPECT_EQ(figure.table.numbers("stress")[1], 300);
    EXPECT_EQ(figure.table.words("state")[2], "after");
    EXPECT_EQ(figure.table.words("sample").back(), "sample 2");
    EXPECT_NE(figure.caption.find("Peak: 300 kPa before, 200 kPa after, means of 2 samples"), std::string::npos);
    EXPECT_TRUE(explain_figure(figure.id));
    EXPECT_EQ(figure.claim, "Peak strength falls from 300 to 200 kPa");
    study.sweep = {{"fines_content", {0.1, 0.2}}};
    for (casefile::Variant& variant : variants) {
        variant.values["fines_content"] = 0.2;
    }
    EXPECT_EQ(
        strength_before_and_after({change}, stages).value().claim, "Peak strength falls from 300 to 200 kPa, FC 20 %"
    ) << "which value of the sweep";
}

} // namespace
} // namespace suffuse::figures
