#include "apps/playground.hpp"

#include "suffuse/base/version.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/report/assess_page.hpp"

#include <fmt/format.h>

namespace suffuse::apps {
namespace {

using nlohmann::json;

/// Where the program found a soil in the atlas, with what it says of this flow.
std::optional<report::PagePlace> place_of(const json& about, const stability::FlowWay& way) {
    const json list = about.value("atlas", json::array());
    if (list.empty()) {
        return std::nullopt;
    }
    report::PagePlace place{list.front().at("size_ratio"), list.front().at("fines_content")};
    for (const json& entry : list) {
        const bool is_inside = entry.at("inside");
        place.is_inside = place.is_inside || is_inside;
        if (is_inside && entry.at("flow") == stability::name_of(way) && !entry.at("wide_fines").get<bool>()) {
            place.simulated.push_back(entry);
        }
    }
    return place;
}

} // namespace

void write_playground(
    const std::filesystem::path& file, const std::vector<job::AssessedSoil>& soils,
    const std::optional<stability::Seepage>& seepage, const json& about
) {
    report::PageSeepage begin;
    if (seepage) {
        begin = {seepage->gradient, seepage->porosity, seepage->grain_density, seepage->stress_share, seepage->way()};
    }
    std::vector<report::PageSoil> shown;
    for (std::size_t k = 0; k < soils.size(); ++k) {
        const grains::Grading& measured = soils[k].measured;
        shown.push_back(
            {soils[k].name, measured.diameter, measured.passing, about[k].value("filter", json(nullptr)),
             place_of(about[k], begin.way)}
        );
    }
    std::error_code none;
    std::filesystem::create_directories(file.parent_path(), none); // where that fails, writing says so
    io::write_file(file, report::assess_page(shown, begin, fmt::format("suffuse {} ({})", version(), commit())));
}

} // namespace suffuse::apps
