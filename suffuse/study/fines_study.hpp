#pragma once
// A study over the fines content of its soil: what Figures 1 to 6 of the paper are drawn from. Numbers carry the names
// of stage.json; what a pure soil has by definition stands in where a stage does not measure it.

#include "suffuse/grains/soil.hpp"
#include "suffuse/study/study_curves.hpp"

#include <string>
#include <vector>

namespace suffuse::study {

/// A fines content at which something changes, read off the curves.
struct Threshold {
    std::string name;         ///< "e lowest"
    double at = 0;            ///< [-]
    double low = 0, high = 0; ///< its range over the replicates and between the points of the sweep [-]
};

struct FinesStudy {
    std::string study;
    std::vector<double> fines_content; ///< requested, increasing [-]
    StageCurve loose;                  ///< a point for each fines content
    StageCurve dense;                  ///< the same; without points where the study has no densest state
    std::vector<Threshold> density;    ///< FC_threshold, marked in Figure 3
    std::vector<Threshold> activity;   ///< FC_active, marked in Figures 4 to 6
};

/// "loose state"; "state “initial”" of a study without a dense one: nobody knows how loose it is.
std::string name_of_loose(const StageCurve& loose, const StageCurve& dense);

/// The mixture at one fines content.
struct Mixture {
    double fines_content = 0; ///< requested [-]
    grains::Grading specified;
    grains::Grading sampled; ///< of one sample; without points where there is none
};

/// A number of `point` by its name in stage.json; for a soil without fines, or of fines alone, what the definition says
/// where nothing was measured: e_g = e_eq = e and LL = 1 at FC = 0, SS = 1 at FC = 1. Without seeds where it is
/// unknown.
Scatter number_of(const SweepPoint& point, double fines_content, const std::string& name);

/// "10 %" for 0.1.
std::string percent_name(double fraction);

/// The color of each of the fines contents that stand in one drawing, in their order: from blue by magenta to sage, as
/// far apart as their number allows, also for color-blind readers, on white and on black paper.
std::vector<std::string> fines_colors(const std::vector<double>& contents);

} // namespace suffuse::study
