#pragma once
// The chart that Figures 3 to 6 share: numbers over the fines content, with error bars from the replicates and marks
// where something changes.

#include "suffuse/figures/figure.hpp"
#include "suffuse/study/fines_study.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::figures {

/// One line of such a chart.
struct FinesLine {
    std::string name; ///< in the legend and in the table
    std::string color;
    const study::StageCurve* curve = nullptr;
    std::string number; ///< of stage.json
};

/// The numbers of lines as a tidy table: panel (where one is named), quantity, fines content specified and reached,
/// value, its standard deviation over the replicates, and how many there are.
class FinesTable {
public:
    FinesTable(std::string value, std::string unit, double factor)
        : value_(std::move(value)), unit_(std::move(unit)), factor_(factor) {}

    void add(const study::FinesStudy& study, const FinesLine& line, const std::string& panel = "");

    [[nodiscard]] Table table() &&;

    /// Largest number of samples behind a point.
    [[nodiscard]] int most_samples() const;

private:
    std::string value_, unit_;
    double factor_; ///< from SI to the unit of the figure
    std::vector<std::string> panel_, quantity_;
    std::vector<double> specified_, reached_, mean_, deviation_, samples_;
};

/// One panel. `value` is the field of the y axis; with `panel` only the rows of that panel are drawn, and measured
/// points that name one.
nlohmann::json fines_panel(
    const study::FinesStudy& study, const std::vector<FinesLine>& lines, const std::string& value,
    const std::string& title, const std::vector<study::Threshold>& thresholds, const std::string& panel = ""
);

/// How points and bars are to be read: a sentence.
std::string about_bars(int most_samples);

} // namespace suffuse::figures
