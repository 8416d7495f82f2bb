#include "suffuse/answer/answer_fines.hpp"

#include "suffuse/answer/report_answer.hpp"
#include "suffuse/study/fines_findings.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::answer {
namespace {

study::SweepPoint point_at(double content, const char* number, double value) {
    study::SweepPoint point;
    point.value = {content};
    point.seed = {1};
    point.number[number] = study::scatter_of({value});
    return point;
}

TEST(FinesFindings, AThresholdThatCannotBeLocatedIsReportedAsNone) {
    study::FinesResults results;
    results.loose.stage = "poured";
    for (const double content : {0.0, 0.1, 0.2, 0.3, 1.0}) {
        results.loose.points.push_back(point_at(content, "void_ratio", (content - 0.35) * (content - 0.35)));
    }
    results.thresholds = study::find_thresholds(results.loose, nullptr);
    EXPECT_EQ(
        thresholds_sentence(results),
        "Through 5 fines contents, by a parabola at its lowest points, the least void ratio of the state “poured” "
        "cannot be placed by these fines contents; active fines show no onset, strong contacts between coarse and fine "
        "grains show no onset."
    );
    results.thresholds.front().at = study::scatter_of({0.38, 0.42});
    EXPECT_NE(thresholds_sentence(results).find("is at FC = 40.0 ± 2.8 %;"), std::string::npos)
        << thresholds_sentence(results);
}

TEST(FinesAnswer, ALeastVoidRatioAtTheFirstFinesContentIsNoFall) {
    const auto reported = [](const std::vector<double>& void_ratios, bool with_dense = true) {
        casefile::Study study;
        study::FinesSweep sweep{.study = &study};
        sweep.curves.loose.stage = "poured";
        sweep.curves.dense.points.resize(with_dense ? 1 : 0);
        double content = 0.4;
        for (const double e : void_ratios) {
            sweep.curves.fines_content.push_back(content);
            sweep.curves.loose.points.push_back(point_at(content, "void_ratio", e));
            content += 0.2;
        }
        return answer_of_fines(sweep).front();
    };
    EXPECT_EQ(
        reported({0.9, 0.8, 1}),
        "The void ratio of the loose state falls from 0.9 at FC = 40 % to its least, 0.8, at FC = "
        "60 %."
    );
    EXPECT_EQ(
        reported({0.8, 0.9, 1}),
        "The void ratio of the loose state is 1 at FC = 80 % and has its least, 0.8, at FC = 40 "
        "%."
    );
}

} // namespace
} // namespace suffuse::answer
