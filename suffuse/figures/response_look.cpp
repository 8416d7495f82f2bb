#include "suffuse/figures/response_look.hpp"

#include "suffuse/figures/six_digits.hpp"
#include "suffuse/study/fines_study.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::figures {

namespace {

using nlohmann::json;

/// Every n-th row, and the last.
std::vector<std::size_t> drawn_rows(std::size_t count, std::size_t most) {
    const std::size_t every = std::max<std::size_t>(1, (count + most - 1) / most);
    std::vector<std::size_t> rows;
    for (std::size_t k = 0; k < count; k += every) {
        rows.push_back(k);
    }
    if (!rows.empty() && rows.back() + 1 != count) {
        rows.push_back(count - 1);
    }
    return rows;
}

} // namespace

std::vector<study::ResponseCurve> with_rows(std::vector<study::ResponseCurve> tests) {
    std::erase_if(tests, [](const study::ResponseCurve& test) { return test.rows.empty(); });
    return tests;
}

Table response_table(const std::vector<study::ResponseCurve>& tests, std::size_t most) {
    std::vector<std::string> name;
    std::vector<double> row_number, axial, deviator, mean, volumetric, void_ratio, pore_pressure, u_deviation;
    std::vector<double> q_deviation, v_deviation, samples;
    for (const study::ResponseCurve& test : tests) {
        for (const std::size_t k : drawn_rows(test.rows.size(), most)) {
            const study::StressStrainRow& row = test.rows[k];
            const study::StressStrainRow spread = test.deviation.empty() ? study::StressStrainRow{} : test.deviation[k];
            name.push_back(test.name);
            row_number.push_back(static_cast<double>(k));
            axial.push_back(six_digits(100 * row.axial_strain));
            deviator.push_back(six_digits(row.deviator_stress / 1e3));
            q_deviation.push_back(six_digits(spread.deviator_stress / 1e3));
            mean.push_back(six_digits(row.mean_stress / 1e3));
            volumetric.push_back(six_digits(100 * row.volumetric_strain));
            v_deviation.push_back(six_digits(100 * spread.volumetric_strain));
            void_ratio.push_back(six_digits(row.void_ratio));
            pore_pressure.push_back(six_digits(row.excess_pore_pressure / 1e3));
            u_deviation.push_back(six_digits(spread.excess_pore_pressure / 1e3));
            samples.push_back(test.samples);
        }
    }
    Table table;
    table.add("test", std::move(name));
    table.add("axial_strain", "%", std::move(axial));
    table.add("deviator_stress", "kPa", std::move(deviator));
    table.add("mean_stress", "kPa", std::move(mean));
    table.add("volumetric_strain", "%", std::move(volumetric));
    table.add("void_ratio", "-", std::move(void_ratio));
    table.add("deviator_stress_deviation", "kPa", std::move(q_deviation));
    table.add("volumetric_strain_deviation", "%", std::move(v_deviation));
    table.add("samples", "", std::move(samples));
    table.add("row", "", std::move(row_number));
    table.add("excess_pore_pressure", "kPa", std::move(pore_pressure));
    table.add("excess_pore_pressure_deviation", "kPa", std::move(u_deviation));
    return table;
}

std::vector<std::string> content_colors(const std::vector<study::ResponseCurve>& tests) {
    std::vector<double> contents;
    for (const study::ResponseCurve& test : tests) {
        if (std::isfinite(test.fines_content)) {
            contents.push_back(test.fines_content);
        }
    }
    const std::vector<std::string> known = study::fines_colors(contents);
    std::vector<std::string> colors;
    std::size_t next = 0;
    for (const study::ResponseCurve& test : tests) {
        colors.push_back(std::isfinite(test.fines_content) ? known[next++] : "");
    }
    return colors;
}

int legend_columns(const json& names) {
    std::size_t longest = 1;
    for (const json& name : names) {
        longest = std::max(longest, name.get_ref<const std::string&>().size());
    }
    return std::max(1, static_cast<int>(560 / (6.2 * static_cast<double>(longest) + 52)));
}

void color_by_test(const std::vector<study::ResponseCurve>& tests, json& encoding) {
    json names = json::array(), colors = json::array();
    const std::vector<std::string> by_content = content_colors(tests);
    for (const study::ResponseCurve& test : tests) {
        const json& sequence = color::sequence();
        const std::string& of_content = by_content[names.size()];
        names.push_back(test.name);
        colors.push_back(of_content.empty() ? sequence[colors.size() % sequence.size()] : json(of_content));
    }
    encoding["color"] = {
        {"field", "test"},
        {"type", "nominal"},
        {"title", nullptr},
        {"scale", {{"domain", names}, {"range", colors}}},
        {"legend",
         {{"symbolType", "stroke"},
          {"symbolOpacity", 1},
          {"symbolSize", color::dash_symbol},
          {"columns", legend_columns(names)}}}};
    encoding["strokeDash"] = {
        {"field", "test"},
        {"type", "nominal"},
        {"title", nullptr},
        {"scale", {{"domain", names}, {"range", json::parse("[[1, 0], [6, 3], [2, 2], [8, 2, 2, 2]]")}}}};
}

bool starts_at_zero(const std::vector<study::ResponseCurve>& tests) {
    double lowest = 0, highest = 0;
    for (const study::ResponseCurve& test : tests) {
        for (const study::StressStrainRow& row : test.rows) {
            lowest = std::min(lowest, row.deviator_stress);
            highest = std::max(highest, row.deviator_stress);
        }
    }
    return lowest > -0.01 * highest;
}

} // namespace suffuse::figures
