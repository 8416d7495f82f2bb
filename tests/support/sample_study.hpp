#pragma once
// An invented study over the fines content, for tests of the report only: shapes as a real study has them, numbers from
// a formula.

#include "suffuse/figures/figures_fines.hpp"
#include "suffuse/grains/grading.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace suffuse::test {

inline const std::vector<double>& sample_fines_contents() {
    static const std::vector<double> contents = {0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.5, 0.6, 0.8, 1};
    return contents;
}

inline study::Scatter around(double mean, double spread) {
    return study::scatter_of({mean - spread, mean, mean + spread});
}

/// Void ratio: falls to `least` at `threshold`, then rises to that of the fines.
inline double sample_void_ratio(double f, double pure, double least, double threshold) {
    const double t = f < threshold ? f / threshold : (1 - f) / (1 - threshold);
    return pure - (pure - least) * t * t * (3 - 2 * t);
}

/// Smooth step from 0 to 1 around `at`.
inline double rises(double f, double at, double width) {
    return 1 / (1 + std::exp(-(f - at) / width));
}

inline study::FinesStudy sample_fines_study() {
    study::FinesStudy study;
    study.study = "fines-sweep";
    study.fines_content = sample_fines_contents();
    study.loose.stage = "loose";
    study.dense.stage = "dense";
    for (const double f : study.fines_content) {
        study::SweepPoint loose{{f}, {study::percent_name(f)}, {1, 2, 3}, {}}, dense = loose;
        const double e = sample_void_ratio(f, 0.86, 0.52, 0.4), b = rises(f, 0.27, 0.035);
        loose.number["void_ratio"] = around(e, 0.008);
        dense.number["void_ratio"] = around(sample_void_ratio(f, 0.62, 0.42, 0.25), 0.004);
        if (f > 0 && f < 1) { // as measure_state leaves them
            loose.number["fines_content"] = around(f, 1e-4);
            loose.number["intergranular_void_ratio"] = around((e + f) / (1 - f), 0.01);
            loose.number["equivalent_void_ratio"] = around((e + (1 - b) * f) / (1 - (1 - b) * f), 0.01);
            loose.number["active_fines_fraction"] = around(b, 0.02);
            const double ll = (1 - f) * (1 - b), ss = f * b, ls = 1 - ll - ss;
            loose.number["contact_share.LL"] = around(ll, 0.01);
            loose.number["contact_share.LS"] = around(ls, 0.01);
            loose.number["contact_share.SS"] = around(ss, 0.01);
            loose.number["strong_contact_share.LS"] = around(0.5 * rises(f, 0.25, 0.05) * (1 - f), 0.015);
        }
        study.loose.points.push_back(std::move(loose));
        study.dense.points.push_back(std::move(dense));
    }
    study.density = {{"FC_threshold, e", 0.4, 0.35, 0.45}, {"FC_threshold, e_min", 0.25, 0.2, 0.3}};
    study.activity = {{"FC_active", 0.22, 0.2, 0.25}};
    return study;
}

inline std::vector<study::Mixture> sample_mixtures() {
    const grains::Grading sand{{2e-4, 3e-4, 4e-4}, {0, 0.5, 1}, "sand"},
        silt{{6e-5, 9e-5, 1.2e-4}, {0, 0.5, 1}, "silt"};
    std::vector<study::Mixture> mixtures;
    for (const double f : sample_fines_contents()) {
        mixtures.push_back({f, grains::mixture(sand, silt, f), grains::mixture(sand, silt, 0.995 * f)});
    }
    return mixtures;
}

inline std::vector<study::ResponseCurve> sample_loose_tests() {
    std::vector<study::ResponseCurve> tests;
    for (const double f : {0.0, 0.05, 0.1, 0.15}) {
        std::vector<std::vector<study::StressStrainRow>> of_sample;
        for (const double scale : {0.95, 1.0, 1.05}) {
            auto& rows = of_sample.emplace_back();
            for (int k = 0; k <= 400; ++k) {
                const double e1 = 5e-4 * k, q = scale * (1.5e5 - 2e5 * f) * (1 - std::exp(-e1 / 0.02));
                const double ev = scale * (0.02 + 0.05 * f) * (1 - std::exp(-e1 / 0.05));
                rows.push_back({e1, ev, q, 1e5 + q / 3, 0.8 - 1.8 * ev});
            }
        }
        tests.push_back(study::average_response("FC " + study::percent_name(f), of_sample));
        tests.back().fines_content = f;
    }
    return tests;
}

} // namespace suffuse::test
