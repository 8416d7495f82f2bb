#include "suffuse/report/assess_page.hpp"

#include "suffuse/atlas/node.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/read_text.hpp"
#include "suffuse/stability/criterion_guide.hpp"

namespace suffuse::report {

namespace {

void put(std::string& page, std::string_view mark, std::string_view text) {
    const std::size_t at = page.find(mark);
    expects(at != std::string::npos, "the page of assess has its marks");
    page.replace(at, mark.size(), text);
}

nlohmann::json number_or_null(const std::optional<double>& number) {
    return number ? nlohmann::json(*number) : nlohmann::json(nullptr);
}

/// Data within a script: no < may end it.
std::string as_data(const nlohmann::json& data) {
    std::string text;
    for (const char c : data.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace)) {
        text += c == '<' ? std::string("\\u003c") : std::string(1, c);
    }
    return text;
}

/// What the page's script computes with: the fixed part of each criterion.
nlohmann::json definitions() {
    nlohmann::json all = nlohmann::json::object();
    for (const std::string& id : stability::criterion_ids()) {
        const stability::Criterion criterion = stability::define(id);
        nlohmann::json& row = all[id];
        row = {
            {"name", criterion.name},
            {"measure", criterion.measure},
            {"sense", stability::name_of(criterion.sense)},
            {"verified", criterion.verified}};
        if (criterion.limit) {
            row["limit"] = *criterion.limit;
        }
    }
    return all;
}

/// With the densities at which the page's flow moves 1 % of the fines.
nlohmann::json place_json(const std::optional<PagePlace>& place) {
    if (!place) {
        return nullptr;
    }
    nlohmann::json moves = nlohmann::json::array();
    for (const nlohmann::json& entry : place->simulated) {
        const bool is_at_least = entry.at("i1_over_ic").is_null();
        const nlohmann::json& gradient =
            is_at_least ? entry.at("lower_bounds").at("i1_over_ic") : entry.at("i1_over_ic");
        if (!gradient.is_null()) {
            moves.push_back(
                {{"density", entry.at("density")},
                 {"porosity", entry.at("porosity")},
                 {"i1_over_ic", gradient},
                 {"at_most", entry.at("i1_at_most")},
                 {"at_least", is_at_least}}
            );
        }
    }
    return {
        {"ratio", place->size_ratio}, {"fines", place->fines_content}, {"inside", place->is_inside}, {"moves", moves}};
}

/// The nodes of upward flow.
nlohmann::json atlas_nodes() {
    nlohmann::json list = nlohmann::json::array();
    for (const atlas::Density density : {atlas::Density::Loose, atlas::Density::Medium, atlas::Density::Dense}) {
        for (const atlas::Node& node : atlas::gather_nodes(atlas::shipped_rows(), density, atlas::Flow::Up)) {
            list.push_back(
                {{"ratio", node.size_ratio},
                 {"fines", node.fines_content},
                 {"density", atlas::name_of(density)},
                 {"i1", node.moves_1 ? nlohmann::json(node.moves_1->mean) : number_or_null(node.least_1.gradient)},
                 {"at_most", node.moves_1 && node.moves_1->is_at_most},
                 {"at_least", !node.moves_1}}
            );
        }
    }
    return list;
}

} // namespace

std::string assess_page(const std::vector<PageSoil>& soils, const PageSeepage& seepage, const std::string& program) {
    nlohmann::json list = nlohmann::json::array();
    for (const PageSoil& soil : soils) {
        list.push_back(
            {{"name", as_utf8(soil.name)},
             {"d", soil.diameter},
             {"f", soil.passing},
             {"filter", soil.filter},
             {"place", place_json(soil.place)}}
        );
    }
    const nlohmann::json settings = {
        {"gradient", number_or_null(seepage.gradient)},
        {"porosity", seepage.porosity},
        {"density", seepage.density},
        {"alpha", number_or_null(seepage.alpha)},
        {"flow", stability::kind_of(seepage.way)}};
    std::string page(assess_template().substr(1));
    put(page, "@PROGRAM@", program);
    put(page, "@DATA@",
        as_data({{"soils", list}, {"seepage", settings}, {"criteria", definitions()}, {"atlas", atlas_nodes()}}));
    return page;
}

} // namespace suffuse::report
