#pragma once
// A figure as a value: its data, and either a Vega-Lite specification or a ready drawing. The same specification feeds
// the report's page, exports to SVG and PNG, and notebooks. Axis titles carry symbol and unit.

#include "suffuse/figures/table.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace suffuse::figures {

struct Figure {
    std::string id;           ///< "fig09", "own-rules": also the stem of its files
    std::string title;        ///< a few words: what is drawn
    std::string claim;        ///< what it shows, in a short sentence: its heading in the report; empty: the title
    std::string caption;      ///< this run's numbers, how to read it, and what limits it
    std::string section;      ///< of the report: "Soils", "Tests", "Water", "Filter", "Erosion"
    Table table;              ///< what is drawn
    nlohmann::json chart;     ///< Vega-Lite without `data`; null where there is a drawing
    std::string drawing = {}; ///< SVG text instead of a chart
    std::string still = {}; ///< the chart drawn once as SVG, for a page that runs no script; empty: the script draws it
    std::string flat = {};  ///< that nothing changed: the page says so in the place of a chart of rounding and noise
};

/// 9 of "fig09"; nothing for a figure of our own.
std::optional<int> figure_of_paper(std::string_view id);

/// Colors that stay apart for color-blind readers, on white and on black paper alike.
namespace color {
inline constexpr const char* coarse = "#b5852f"; // sand
inline constexpr const char* fines = "#c8322b";
inline constexpr const char* detachable = "#d55e00";
inline constexpr const char* staying = "#3b82b8";
inline constexpr const char* ink = "#333333";
inline constexpr const char* quiet = "#808080";
/// For passes and tests, in their order.
const nlohmann::json& sequence();
/// And the dashes next to them.
const nlohmann::json& dashes();
/// Size of a legend's stroke, long enough to distinguish dashes [px²].
inline constexpr int dash_symbol = 676;
} // namespace color

/// The chart, where axes and tooltips without a title have that of the fact whose key they show.
nlohmann::json named_chart(const Figure& figure);

/// The named chart with its data inside and the look of a figure in print, as written to `ID.vl.json`. [Vega-Lite 6]
nlohmann::json complete_specification(const Figure& figure);

/// Vega-Lite configuration of a figure in print: fonts, dark ink on white.
nlohmann::json look_in_print();

/// An axis or legend expression that writes decades as powers of ten, and nothing at the ticks between them.
std::string power_of_ten_labels();

} // namespace suffuse::figures
