#include "suffuse/figures/figures_fines.hpp"

#include <gtest/gtest.h>

#include "tests/support/sample_study.hpp"
#include <algorithm>
#include <map>
#include <set>

namespace suffuse::figures {
namespace {

using nlohmann::json;

/// Value of one row of a figure over the fines content.
double value_at(const Figure& figure, const std::string& column, const std::string& quantity, double percent) {
    const auto& quantities = figure.table.words("quantity");
    for (std::size_t row = 0; row < figure.table.rows(); ++row) {
        if (quantities[row].starts_with(quantity) && figure.table.numbers("fines_content")[row] == percent) {
            return figure.table.numbers(column)[row];
        }
    }
    return std::nan("");
}

TEST(FinesFigures, VoidRatiosAreTheMeansOverTheSeedsWithTheirScatter) {
    const study::FinesStudy study = test::sample_fines_study();
    const Figure figure = *void_ratios(study);
    EXPECT_EQ(figure.id, "fig03");
    const study::SweepPoint& at_30 = study.loose.points[6];
    EXPECT_DOUBLE_EQ(value_at(figure, "void_ratio", "e_g", 30), at_30.number.at("intergranular_void_ratio").mean);
    EXPECT_DOUBLE_EQ(value_at(figure, "void_ratio", "e_eq", 30), at_30.number.at("equivalent_void_ratio").mean);
    EXPECT_DOUBLE_EQ(value_at(figure, "void_ratio", "e_min", 30), study.dense.points[6].number.at("void_ratio").mean);
    EXPECT_NEAR(value_at(figure, "standard_deviation", "e_g", 30), 0.01, 1e-12); // of 3 evenly spaced values
    EXPECT_EQ(value_at(figure, "samples", "e_g", 30), 3);
    EXPECT_TRUE(figure.claim.starts_with("The loose state has its lowest void ratio at FC = 40 % (")) << figure.claim;
    EXPECT_NE(figure.caption.find("FC = 25 %"), std::string::npos) << figure.caption;
}

TEST(FinesFigures, APureSoilHasWhatItsDefinitionSays) {
    const study::FinesStudy study = test::sample_fines_study();
    const Figure ratios = *void_ratios(study), classes = *contact_classes(study), strong = *strong_contacts(study);
    const double e = study.loose.points[0].number.at("void_ratio").mean;
    EXPECT_EQ(value_at(ratios, "void_ratio", "e_g", 0), e);
    EXPECT_EQ(value_at(ratios, "void_ratio", "e_eq", 0), e);
    EXPECT_TRUE(std::isnan(value_at(ratios, "void_ratio", "e_g", 100))) << "infinite, so not drawn";
    EXPECT_EQ(value_at(classes, "share_of_contacts", "LL", 0), 100);
    EXPECT_EQ(value_at(classes, "share_of_contacts", "SS", 100), 100);
    EXPECT_EQ(value_at(strong, "strong_share", "LS", 0), 0);
    EXPECT_TRUE(std::isnan(value_at(*active_fines(study), "active_fines", "b", 0))) << "no fines, no share of them";
}

TEST(FinesFigures, SharesOfContactsAddUpToAll) {
    const Figure figure = *contact_classes(test::sample_fines_study());
    std::map<double, double> sum;
    for (std::size_t row = 0; row < figure.table.rows(); ++row) {
        sum[figure.table.numbers("fines_content")[row]] += figure.table.numbers("share_of_contacts")[row];
    }
    EXPECT_EQ(sum.size(), 13U);
    for (const auto& [fines, all] : sum) {
        EXPECT_NEAR(all, 100, 1e-9) << fines; // rounding
    }
}

TEST(FinesFigures, ThresholdsAreMarkedWithTheirRangeAndWithoutThemNothingIs) {
    study::FinesStudy study = test::sample_fines_study();
    const auto marks = [](const json& panel) {
        json found = json::array();
        for (const json& layer : panel["layer"]) {
            if (layer.contains("data") && layer["data"]["values"][0].contains("threshold")) {
                found = layer["data"]["values"];
            }
        }
        return found;
    };
    const json shown = marks(void_ratios(study)->chart["vconcat"][0]);
    ASSERT_EQ(shown.size(), 2U);
    EXPECT_EQ(shown[0]["at"], 25);
    EXPECT_EQ(shown[0]["from"], 20);
    EXPECT_EQ(shown[0]["to"], 30);
    EXPECT_LT(shown[0]["row"], shown[1]["top"]) << "the rule to the right begins below the name to its left";
    EXPECT_EQ(marks(active_fines(study)->chart).size(), 1U);
    study.density.clear();
    study.activity.clear();
    EXPECT_TRUE(marks(void_ratios(study)->chart["vconcat"][0]).empty());
    EXPECT_TRUE(marks(strong_contacts(study)->chart).empty());
}

TEST(FinesFigures, AStudyThatMeasuredNothingMakesNone) {
    const study::FinesStudy nothing;
    EXPECT_FALSE(void_ratios(nothing) || active_fines(nothing) || contact_classes(nothing) || strong_contacts(nothing));
    EXPECT_FALSE(mixture_gradings({}) || loose_compression({}) || test_paths({}));
}

TEST(FinesFigures, OneSampleAPointHasNoBarsAndSharesEndAtAHundredPercent) {
    study::FinesStudy study = test::sample_fines_study();
    const std::size_t with_bars = strong_contacts(study)->chart["layer"].size();
    for (study::SweepPoint& point : study.loose.points) {
        point.seed.resize(1);
        for (auto& [name, scatter] : point.number) {
            scatter = study::scatter_of({scatter.mean});
        }
        point.number["strong_contact_share.LS"] = study::scatter_of({0.7});
    }
    const Figure figure = *strong_contacts(study);
    EXPECT_EQ(figure.chart["layer"].size() + 3, with_bars);
    EXPECT_EQ(figure.chart.dump().find("\"low\""), std::string::npos);
    for (const json& layer : figure.chart["layer"]) {
        if (layer["encoding"].contains("y") && layer["encoding"]["y"].value("field", "") == "strong_share") {
            EXPECT_EQ(layer["encoding"]["y"]["axis"]["values"].back(), 100);
        }
    }
}

TEST(FinesFigures, ASweepThatEndsEarlyEndsItsAxisEarly) {
    study::FinesStudy study = test::sample_fines_study();
    study.fines_content.resize(4);
    study.loose.points.resize(4);
    study.dense.points.clear();
    const Figure figure = *void_ratios(study);
    EXPECT_EQ(figure.chart["vconcat"][0]["encoding"]["x"]["scale"]["domain"], (json{0, 20}));
    EXPECT_GT(figure.chart["vconcat"][0]["encoding"]["x"]["scale"]["padding"], 0) << "for half a point at the ends";
    EXPECT_EQ(figure.caption.find("e_min"), std::string::npos);
}

TEST(MixtureFigure, HasALineForEachMixtureAndDotsForItsSample) {
    const Figure figure = *mixture_gradings(test::sample_mixtures());
    const auto& names = figure.table.words("mixture");
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), 13U);
    const auto& passing = figure.table.numbers("passing");
    EXPECT_NEAR(*std::max_element(passing.begin(), passing.end()), 100, 1e-12); // rounding
    // The gap between the two fractions is flat at the fines content.
    for (std::size_t row = 0; row < figure.table.rows(); ++row) {
        const double d = figure.table.numbers("diameter")[row];
        if (d > 0.13 && d < 0.19 && figure.table.words("kind")[row] == "specified") {
            EXPECT_NEAR(passing[row], figure.table.numbers("fines_content")[row], 1e-9); // rounding
        }
    }
    EXPECT_NE(figure.caption.find("0.5 %"), std::string::npos) << figure.caption; // 0.005 of the fines at FC = 100 %
}

/// A color as deuteranopes see it (Machado et al. 2009), linear light.
std::array<double, 3> as_without_green(const std::string& hex) {
    std::array<double, 3> light{}, seen{};
    for (std::size_t c = 0; c < 3; ++c) {
        light[c] = std::pow(std::stoi(hex.substr(1 + 2 * c, 2), nullptr, 16) / 255.0, 2.2);
    }
    constexpr std::array<std::array<double, 3>, 3> machado = {
        {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
    for (std::size_t c = 0; c < 3; ++c) {
        seen[c] = std::pow(
            std::clamp(machado[c][0] * light[0] + machado[c][1] * light[1] + machado[c][2] * light[2], 0.0, 1.0),
            1 / 2.2
        );
    }
    return seen;
}

TEST(MixtureFigure, ColorsOfFinesContentsInOneDrawingStayApartAlsoForTheColorBlind) {
    const std::vector<std::string> colors = study::fines_colors({0.05, 0.1, 0.15, 0.2, 0.3, 0.1});
    EXPECT_EQ(colors[5], colors[1]) << "one content, one color";
    for (std::size_t a = 0; a < 5; ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            const auto first = as_without_green(colors[a]), second = as_without_green(colors[b]);
            double distance = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                distance += std::abs(first[c] - second[c]);
            }
            EXPECT_GT(distance, 0.18) << colors[a] << " and " << colors[b]; // 0.13 is one green next to another
        }
    }
    EXPECT_EQ(study::fines_colors({0.2}).size(), 1U);
}

TEST(AverageResponse, OfExtensionsReachesAsFarBelowZeroAsAllOfThem) {
    std::vector<study::StressStrainRow> far, near;
    for (const double strain : {0.0, -0.02, -0.04, -0.08}) {
        far.push_back({.axial_strain = strain, .deviator_stress = 1e6 * strain});
    }
    for (const double strain : {0.0, -0.05}) {
        near.push_back({.axial_strain = strain, .deviator_stress = 3e6 * strain});
    }
    const study::ResponseCurve mean = study::average_response("m", {far, near});
    ASSERT_EQ(mean.rows.size(), 3U);
    EXPECT_NEAR(mean.rows[2].axial_strain, -0.04, 1e-12);
    EXPECT_NEAR(mean.rows[2].deviator_stress, -8e4, 1e-6);
}

TEST(AverageResponse, OfCurvesOnDifferentStrainsIsTheMeanOfTheirLines) {
    std::vector<study::StressStrainRow> coarse, fine;
    for (int k = 0; k <= 10; ++k) {
        coarse.push_back({0.01 * k, 0, 1000.0 * k, 0, 0}); // q = 1e5 e1
    }
    for (int k = 0; k <= 33; ++k) {
        fine.push_back({0.003 * k, 0, 900.0 * k, 0, 0}); // q = 3e5 e1, ends at 9.9 %
    }
    const study::ResponseCurve mean = study::average_response("m", {coarse, fine, {}});
    EXPECT_EQ(mean.samples, 2);
    ASSERT_EQ(mean.rows.size(), 10U) << "as far as both reach";
    for (std::size_t k = 0; k < mean.rows.size(); ++k) {
        // Both within rounding, of stresses of some 1e4 Pa.
        EXPECT_NEAR(mean.rows[k].deviator_stress, 2e5 * mean.rows[k].axial_strain, 1e-9);
        EXPECT_NEAR(mean.deviation[k].deviator_stress, std::sqrt(2.0) * 1e5 * mean.rows[k].axial_strain, 1e-9);
    }
    EXPECT_TRUE(study::average_response("one", {coarse}).deviation.empty());
}

TEST(ResponseFigures, BandsAreDrawnForReplicatesOnly) {
    const Figure replicated = *loose_compression(test::sample_loose_tests());
    EXPECT_TRUE(replicated.chart["vconcat"][0].contains("layer"));
    EXPECT_NE(replicated.caption.find("bands"), std::string::npos);
    study::ResponseCurve alone = test::sample_loose_tests()[0];
    alone.deviation.clear();
    alone.samples = 1;
    const Figure single = *loose_compression({alone});
    EXPECT_FALSE(single.chart["vconcat"][0].contains("layer"));
    EXPECT_EQ(single.caption.find("bands"), std::string::npos);
}

TEST(ResponseFigures, TestsOfAMixtureInSeveralStagesHaveItsColorAndDashesOfTheirStage) {
    std::vector<study::ResponseCurve> tests;
    for (const char* stage : {"shear", "shear-emptied"}) {
        for (study::ResponseCurve test : test::sample_loose_tests()) {
            test.name += std::string(", ") + stage;
            tests.push_back(test);
        }
    }
    const json encoding = test_paths(tests)->chart["vconcat"][0]["encoding"];
    EXPECT_EQ(encoding["color"]["scale"]["domain"], (json{"FC 0 %", "FC 5 %", "FC 10 %", "FC 15 %"}));
    EXPECT_EQ(encoding["color"]["scale"]["range"], (json(study::fines_colors({0, 0.05, 0.1, 0.15}))));
    EXPECT_EQ(encoding["strokeDash"]["scale"]["domain"], (json{"shear", "shear-emptied"}));
    tests.resize(4);
    EXPECT_EQ(test_paths(tests)->chart["vconcat"][0]["encoding"]["color"]["field"], "test");
}

TEST(ResponseFigures, OneLineOfStressThatAllTestsMoveAlongIsReportedAndNotDrawn) {
    // Drained, at a lateral stress of 100 kPa: p = 100 kPa + q/3, within what a servo lets go of.
    study::ResponseCurve first{"before", {{0, 0, 0, 100e3, 0.7}, {0.02, 0.01, 300e3, 202e3, 0.68}}};
    study::ResponseCurve second{"after", {{0, 0, 0, 100e3, 0.9}, {0.02, 0.01, 150e3, 149e3, 0.88}}};
    const Figure drained = *test_paths({first, second});
    ASSERT_EQ(drained.chart["vconcat"].size(), 1U);
    EXPECT_EQ(drained.chart["vconcat"][0]["encoding"]["y"]["field"], "void_ratio");
    EXPECT_NE(drained.caption.find("q = 3 (p − 100 kPa)"), std::string::npos) << drained.caption;
    second.rows[1].mean_stress = 100e3; // at a constant mean stress
    const Figure both = *test_paths({first, second});
    ASSERT_EQ(both.chart["vconcat"].size(), 2U);
    EXPECT_EQ(both.chart["vconcat"][0]["encoding"]["y"]["field"], "deviator_stress");
    EXPECT_EQ(both.caption.find("is not drawn"), std::string::npos);
}

TEST(ResponseFigures, AtConstantVolumeRoundingIsNoResponse) {
    study::ResponseCurve test{"FC 10 %", {{0.001, 1e-9, 10e3, 100e3, 0.8}, {0.05, 4e-8, 1, 0.01, 0.8}}};
    const Figure undrained = *triaxial_response({test});
    EXPECT_TRUE(undrained.chart["vconcat"][1]["encoding"]["y"].contains("scale"));
    EXPECT_EQ(undrained.chart["vconcat"][1]["encoding"]["x"]["scale"]["domainMin"], 0);
    const Figure paths = *test_paths({test});
    EXPECT_EQ(paths.chart["vconcat"][1]["transform"][0]["filter"], "datum.mean_stress >= 1"); // of 100 kPa
    EXPECT_NE(paths.caption.find("liquefied"), std::string::npos);
    test.rows[1].volumetric_strain = 0.02;
    EXPECT_FALSE(triaxial_response({test})->chart["vconcat"][1]["encoding"]["y"].contains("scale"));
}

TEST(ResponseFigures, LongTestsAreThinnedAndKeepTheirEnd) {
    study::ResponseCurve test{"long", {}};
    for (int k = 0; k <= 5000; ++k) {
        test.rows.push_back({1e-5 * k, 0, 1.0 * k, 1, 1});
    }
    const Table table = triaxial_response({test})->table;
    EXPECT_LE(table.rows(), 241U);
    EXPECT_NEAR(table.numbers("axial_strain").back(), 5, 1e-12); // rounding of 100 x 0.05
}

} // namespace
} // namespace suffuse::figures
