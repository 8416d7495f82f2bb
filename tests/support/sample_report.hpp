#pragma once
// An invented report of an erosion run, for tests of the report only.

#include "suffuse/answer/headlines.hpp"
#include "suffuse/report/page.hpp"
#include "suffuse/study/findings.hpp"

#include "tests/support/sample_results.hpp"
#include "tests/support/sample_scene.hpp"
#include <cmath>
#include <string>

namespace suffuse::test {

inline report::ReportData sample_report(const std::string& title) {
    using namespace report;
    const auto probes = sample_probes();
    const auto erosion = sample_erosion();
    ReportData report;
    report.title = title;
    report.run = "synthetic-0001";
    report.paper = "A paper that was never written";
    report.answer = {
        "These numbers are invented: this page exists to test the report.",
        "The sample of 1,000 grains was settled at 100 kPa with a void ratio of 0.672 (porosity 0.402).",
        "At i = 0.05, 13 % of the mass could leave in the first pass and 2 % in the second.",
        "The first pass left stress and volume as they were; the second took active grains, and the mean stress at "
        "constant volume fell by 28 %.",
        "Permeability rose from 5.4e-11 to 1.9e-10 m²; the peak deviator stress fell from 340 to 260 kPa."};
    report.findings = study::judge_erosion(probes, erosion);
    report.findings.back().met = std::nullopt;
    report.opening.verdict = {
        "Water at i = 0.05 carries out 15 % of the mass, in two passes.",
        "The peak strength falls by 24 %, from 340 to 260 kPa."};
    report.opening.confidence = "One sample";
    report.opening.about_confidence = "1,000 grains. No replicate: `--set study.erosion.replicates=3` tells.";
    report.opening.cards = answer::erosion_headlines(erosion, {}, nullptr);
    report.opening.cards[1].lead = "up to";
    report.opening.cards[1].caution = "Known to be too high.";
    report.opening.cards.push_back(answer::findings_headline(report.findings).value());
    report.opening.disagreement = {"One rule calls the soil stable, the other does not."};
    report.opening.pictures = {"own-triaxial", "own-permeability"};
    report.warnings = {
        "The cell is 9.7 times as wide as the largest grain; ten is the least for a representative sample."};
    report.assumed = {
        {"contact.modulus", "356 MPa", "k_n = 2 E R1 R2 / (R1 + R2)"}, {"contact.friction", "37 deg", ""}};
    report.figures = sample_figures();
    report.stages = {
        {"erosion/cloud", 1000, 1.86, 0.65, 0, 0, 0, {}, {}, {}, {}, std::nan(""), 0, 0, 0.4},
        {"erosion/initial",
         1000,
         0.672,
         0.402,
         3.32,
         1e5,
         300,
         {9e-4, 1e-3},
         {4e-4, 5e-3},
         {3e-3, 0.05},
         {2e-4, 1e-3},
         2e-9,
         4.1e-8,
         41200,
         38.2},
        {"erosion/erosion",
         700,
         0.95,
         0.487,
         4.1,
         1e5,
         500,
         {2e-3, 1e-3},
         {5e-4, 5e-3},
         {4e-3, 0.05},
         {3e-4, 1e-3},
         4e-9,
         4.1e-8,
         18200,
         21.7}};
    report.provenance = {
        {"version", "0.1.0"},
        {"commit", "0000000, synthetic"},
        {"seed", "2016"},
        {"threads", "2"},
        {"state hash", "0123456789abcdef"}};
    report.calls = {{"suffuse run case.toml", "2026-01-01T12:00:00Z", "0.1.0 0000000", 60.3}};
    report.cited = {"0.1.0", "0000000, synthetic", true};
    report.scene = sample_scene();
    report.redraw = "suffuse report runs/synthetic-0001";
    return report;
}

} // namespace suffuse::test
