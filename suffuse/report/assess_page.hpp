#pragma once
// The page of `suffuse assess --page`: one offline HTML file in which a curve can be edited and what is known of the
// soil dragged, while the criteria follow. It computes with its own script, page/src/assess.

#include "suffuse/stability/flow_way.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::report {

/// Where a soil is on the map of the atlas.
struct PagePlace {
    double size_ratio = 0, fines_content = 0;
    bool is_inside = false;
    nlohmann::json simulated =
        nlohmann::json::array(); ///< entries of `assess --json` for the page's flow that say something of this soil
};

struct PageSoil {
    std::string name;
    std::vector<double> diameter, passing; ///< as measured: sizes rising [m], shares finer [-]
    nlohmann::json filter = nullptr;       ///< what `assess --json` says of a filter; null: none was requested
    std::optional<PagePlace> place = {};   ///< none: the curve has no two parts
};

/// What the sliders begin with, and the flow that they are of.
struct PageSeepage {
    std::optional<double> gradient = {}; ///< none: not specified
    double porosity = 0.40, density = 2650;
    std::optional<double> alpha = {};
    stability::FlowWay way = stability::upward;
};

/// @param program its name and version, for the foot
std::string assess_page(const std::vector<PageSoil>& soils, const PageSeepage& seepage, const std::string& program);

/// The page before data and program are put in: page/src/assess, embedded when the library is built.
std::string_view assess_template();

} // namespace suffuse::report
