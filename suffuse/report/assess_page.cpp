#include "suffuse/report/assess_page.hpp"

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

} // namespace

std::string assess_page(const std::vector<PageSoil>& soils, const PageSeepage& seepage, const std::string& program) {
    nlohmann::json list = nlohmann::json::array();
    for (const PageSoil& soil : soils) {
        list.push_back(
            {{"name", as_utf8(soil.name)}, {"d", soil.diameter}, {"f", soil.passing}, {"filter", soil.filter}}
        );
    }
    nlohmann::json settings = {
        {"gradient", seepage.gradient},
        {"porosity", seepage.porosity},
        {"density", seepage.density},
        {"alpha", nullptr}};
    if (seepage.alpha) {
        settings["alpha"] = *seepage.alpha;
    }
    std::string page(assess_template().substr(1));
    put(page, "@PROGRAM@", program);
    put(page, "@DATA@", as_data({{"soils", list}, {"seepage", settings}, {"criteria", definitions()}}));
    return page;
}

} // namespace suffuse::report
