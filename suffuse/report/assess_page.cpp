#include "suffuse/report/assess_page.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/read_text.hpp"

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

} // namespace

std::string assess_page(const std::vector<PageSoil>& soils, const PageSeepage& seepage, const std::string& program) {
    nlohmann::json list = nlohmann::json::array();
    for (const PageSoil& soil : soils) {
        list.push_back(
            {{"name", as_utf8(soil.name)}, {"d", soil.diameter}, {"f", soil.passing}, {"filter", soil.filter}}
        );
    }
    nlohmann::json asked = {
        {"gradient", seepage.gradient},
        {"porosity", seepage.porosity},
        {"density", seepage.density},
        {"alpha", nullptr}};
    if (seepage.alpha) {
        asked["alpha"] = *seepage.alpha;
    }
    std::string page(assess_template().substr(1));
    put(page, "@PROGRAM@", program);
    put(page, "@DATA@", as_data({{"soils", list}, {"seepage", asked}}));
    return page;
}

} // namespace suffuse::report
