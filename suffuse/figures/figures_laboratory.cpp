#include "suffuse/figures/figures_laboratory.hpp"

#include "suffuse/base/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace suffuse::figures {
namespace {

using nlohmann::json;

/// A number of a row of a curve, in the unit of the figure.
struct Drawn {
    std::string name, unit;
    std::function<double(const triaxial::TriaxialSpec&, const triaxial::PathRow&)> value;
};

Table table_of(const std::vector<LaboratoryTest>& tests, const std::vector<Drawn>& columns) {
    std::vector<std::string> names;
    std::vector<double> number;
    std::vector<std::vector<double>> values(columns.size());
    for (const LaboratoryTest& test : tests) {
        const triaxial::TriaxialSpec& spec = *casefile::laboratory_test(test.stage->stage->spec);
        for (const triaxial::PathRow& row : test.stage->findings.curve) {
            names.push_back(test.name);
            number.push_back(static_cast<double>(number.size()));
            for (std::size_t k = 0; k < columns.size(); ++k) {
                values[k].push_back(columns[k].value(spec, row));
            }
        }
    }
    Table table;
    table.add("test", std::move(names));
    table.add("row", "", std::move(number));
    for (std::size_t k = 0; k < columns.size(); ++k) {
        table.add(columns[k].name, columns[k].unit, std::move(values[k]));
    }
    return table;
}

/// Lines through the rows in their order, a color a test.
json panel(const std::string& x, const std::string& x_title, const std::string& y, const std::string& y_title) {
    const auto axis = [](const std::string& field, const std::string& title) {
        return json{
            {"field", field},
            {"type", "quantitative"},
            {"title", title},
            {"scale", {{"zero", false}, {"nice", false}}}};
    };
    json panel{{"width", 480}, {"height", 200}, {"mark", {{"type", "line"}}}};
    panel["encoding"] = {
        {"x", axis(x, x_title)},
        {"y", axis(y, y_title)},
        {"order", {{"field", "row"}}},
        {"color", {{"field", "test"}, {"type", "nominal"}, {"title", nullptr}, {"sort", nullptr}}},
        {"tooltip", {{{"field", "test"}}, {{"field", x}, {"format", ".4g"}}, {{"field", y}, {"format", ".4g"}}}}};
    panel["encoding"]["color"]["scale"] = {{"range", color::sequence()}};
    return panel;
}

json stacked(const json& panels) {
    return {{"vconcat", panels}, {"spacing", 16}, {"resolve", {{"scale", {{"color", "shared"}}}}}};
}

/// "oedometer: K0 0.41, Cc 0.012", of the numbers that the stages have.
std::string
numbers_of(const std::vector<LaboratoryTest>& tests, const std::vector<std::pair<const char*, const char*>>& keys) {
    std::string all;
    for (const LaboratoryTest& test : tests) {
        std::string of_test;
        for (const auto& [key, symbol] : keys) {
            const json value = test.stage->numbers.value(key, json());
            if (value.is_number()) {
                of_test +=
                    fmt::format("{}{} {}", of_test.empty() ? "" : ", ", symbol, short_number(value.get<double>(), 3));
            }
        }
        if (!of_test.empty()) {
            all += fmt::format("{}{}: {}", all.empty() ? "" : "; ", test.name, of_test);
        }
    }
    return all;
}

Figure figure_of(const char* id, const char* title, std::string claim) {
    Figure figure;
    figure.id = id;
    figure.section = "Tests";
    figure.title = title;
    figure.claim = std::move(claim);
    return figure;
}

double axial_stress(const triaxial::TriaxialSpec& spec, const triaxial::PathRow& row) {
    return row.stress(spec.axis, spec.axis) / 1e3;
}

double void_ratio(const triaxial::TriaxialSpec& /*spec*/, const triaxial::PathRow& row) {
    return row.void_ratio;
}

double lateral_stress(const triaxial::TriaxialSpec& spec, const triaxial::PathRow& row) {
    return 0.5 * (trace(row.stress) - row.stress(spec.axis, spec.axis));
}

/// Of undrained tests; one fluid fills them all.
std::string words_on_water(const std::vector<LaboratoryTest>& tests) {
    const json b = tests.front().stage->numbers.value("skempton_b", json());
    if (!b.is_number()) {
        return "";
    }
    return b.get<double>() == 1 ? " Water is incompressible: Skempton's B is 1."
                                : fmt::format(" Skempton's B is {}.", short_number(b.get<double>(), 3));
}

} // namespace

std::optional<Figure> compression_curves(const std::vector<LaboratoryTest>& tests) {
    if (tests.empty()) {
        return std::nullopt;
    }
    Figure figure = figure_of(
        "own-compression", "Compression and swelling",
        as_sentence(numbers_of({tests.front()}, {{"compression_index", "Cc"}, {"swelling_index", "Cs"}, {"k0", "K₀"}}))
    );
    figure.table = table_of(tests, {{"axial_stress", "kPa", axial_stress}, {"void_ratio", "-", void_ratio}});
    figure.chart = panel("axial_stress", "axial stress [kPa]", "void_ratio", "void ratio e");
    figure.chart["height"] = 260;
    figure.chart["encoding"]["x"]["scale"] = {{"type", "log"}, {"nice", false}};
    figure.caption =
        as_sentence(numbers_of(tests, {{"compression_index", "Cc"}, {"swelling_index", "Cs"}, {"k0", "K₀"}})) +
        ". Cc and Cs are the slopes of first loading and of unloading over a decade of stress.";
    return figure;
}

std::optional<Figure> shear_curves(const std::vector<LaboratoryTest>& tests) {
    if (tests.empty()) {
        return std::nullopt;
    }
    const auto normal = [](const triaxial::TriaxialSpec& spec, const triaxial::PathRow& row) {
        return row.stress(spec.shear_axes.normal, spec.shear_axes.normal) / 1e3;
    };
    const auto ratio = [normal](const triaxial::TriaxialSpec& spec, const triaxial::PathRow& row) {
        const double across = normal(spec, row);
        return across > 0 ? triaxial::shear_stress(spec, row.stress) / 1e3 / across : missing;
    };
    Figure figure = figure_of(
        "own-shear", "Simple shear", as_sentence(numbers_of({tests.front()}, {{"peak_stress_ratio", "Highest τ/σₙ"}}))
    );
    figure.table = table_of(
        tests, {{"shear_strain", "%",
                 [](const triaxial::TriaxialSpec&, const triaxial::PathRow& row) { return 100 * row.shear_strain; }},
                {"stress_ratio", "-", ratio},
                {"normal_stress", "kPa", normal},
                {"void_ratio", "-", void_ratio}}
    );
    const char* const strain = "shear strain γ [%]";
    figure.chart = stacked(
        {panel("shear_strain", strain, "stress_ratio", "stress ratio τ/σₙ"),
         panel("shear_strain", strain, "normal_stress", "normal stress σₙ [kPa]"),
         panel("shear_strain", strain, "void_ratio", "void ratio e")}
    );
    figure.caption =
        as_sentence(numbers_of(tests, {{"peak_stress_ratio", "highest τ/σₙ"}, {"final_stress_ratio", "at the end"}})) +
        ". Tests hold the volume or the normal stress; the sides of the cell keep their lengths.";
    return figure;
}

std::optional<Figure> cyclic_resistance(const std::vector<LaboratoryTest>& tests) {
    std::vector<std::string> names;
    std::vector<double> amplitudes, cycles;
    for (const LaboratoryTest& test : tests) {
        const std::optional<double> csr = casefile::laboratory_test(test.stage->stage->spec)->cycles->csr;
        const json to_liquefaction = test.stage->numbers.value("cycles_to_liquefaction", json());
        if (csr && to_liquefaction.is_number()) {
            names.push_back(test.name);
            amplitudes.push_back(*csr);
            cycles.push_back(to_liquefaction.get<double>());
        }
    }
    if (names.size() < 2) {
        return std::nullopt;
    }
    const auto [fewest, most] = std::ranges::minmax(cycles);
    Figure figure = figure_of(
        "own-cyclic-resistance", "Cyclic resistance",
        fmt::format("{} tests liquefy in {} to {} cycles", names.size(), short_number(fewest, 3), short_number(most, 3))
    );
    figure.table.add("state", std::move(names));
    figure.table.add("cycles_to_liquefaction", "-", std::move(cycles));
    figure.table.add("csr", "-", std::move(amplitudes));
    figure.chart = panel("cycles_to_liquefaction", "cycles to liquefaction N", "csr", "cyclic stress ratio q/(2 p₀)");
    figure.chart["height"] = 260;
    figure.chart["mark"] = {{"type", "point"}, {"filled", true}, {"size", 70}, {"opacity", 0.7}};
    figure.chart["encoding"]["x"]["scale"] = {{"type", "log"}, {"nice", false}, {"padding", 20}};
    figure.chart["encoding"]["x"]["axis"] = {{"format", "~g"}};
    figure.chart["encoding"]["y"]["scale"] = {{"zero", true}};
    figure.chart["encoding"]["color"]["field"] = "state";
    figure.chart["encoding"]["tooltip"][0]["field"] = "state";
    figure.chart["encoding"].erase("order");
    figure.caption =
        "A point a test that liquefied, by the limits of its `until`; a color a state. Samples that differ in "
        "their seed only scatter as much as the points of one state and amplitude.";
    return figure;
}

std::optional<Figure> cyclic_curves(const std::vector<LaboratoryTest>& tests) {
    if (tests.empty()) {
        return std::nullopt;
    }
    const auto curve_of = [&](const triaxial::TriaxialSpec& spec) -> const std::vector<triaxial::PathRow>& {
        const auto of_test = std::ranges::find_if(tests, [&](const LaboratoryTest& test) {
            return casefile::laboratory_test(test.stage->stage->spec) == &spec;
        });
        return of_test->stage->findings.curve;
    };
    const auto pore_pressure_ratio = [&](const triaxial::TriaxialSpec& spec, const triaxial::PathRow& row) {
        return row.excess_pore_pressure / lateral_stress(spec, curve_of(spec).front());
    };
    const auto cycle = [&](const triaxial::TriaxialSpec& spec, const triaxial::PathRow& row) {
        const std::vector<triaxial::PathRow>& curve = curve_of(spec);
        const auto first = std::ranges::lower_bound(curve, row.leg, {}, &triaxial::PathRow::leg);
        const auto end = std::ranges::upper_bound(curve, row.leg, {}, &triaxial::PathRow::leg);
        const auto done = static_cast<double>(&row - &*first + 1);
        return 0.5 * (row.leg + done / static_cast<double>(end - first));
    };
    Figure figure = figure_of(
        "own-cyclic", "Cyclic loading",
        as_sentence(
            numbers_of({tests.front()}, {{"cycles_to_liquefaction", "N"}, {"pore_pressure_ratio", "highest rᵤ"}})
        )
    );
    figure.table = table_of(
        tests, {{"axial_strain", "%",
                 [](const triaxial::TriaxialSpec&, const triaxial::PathRow& row) { return 100 * row.axial_strain; }},
                {"deviator_stress", "kPa",
                 [](const triaxial::TriaxialSpec&, const triaxial::PathRow& row) { return row.deviator_stress / 1e3; }},
                {"mean_stress", "kPa",
                 [](const triaxial::TriaxialSpec&, const triaxial::PathRow& row) { return row.mean_stress / 1e3; }},
                {"cycle", "-", cycle},
                {"pore_pressure_ratio", "-", pore_pressure_ratio}}
    );
    const char* const q = "deviator stress q [kPa]";
    figure.chart = stacked(
        {panel("mean_stress", "effective mean stress p′ [kPa]", "deviator_stress", q),
         panel("axial_strain", "axial strain ε₁ [%]", "deviator_stress", q),
         panel("cycle", "cycles", "pore_pressure_ratio", "pore-pressure ratio rᵤ")}
    );
    figure.caption = as_sentence(numbers_of(
                         tests, {{"cycles_to_liquefaction", "cycles to liquefaction"},
                                 {"cycles", "cycles begun"},
                                 {"pore_pressure_ratio", "highest rᵤ"},
                                 {"double_amplitude", "largest double amplitude of ε₁"}}
                     )) +
                     ". From above: path of effective stress, loops of stress and strain, pore pressure. The total "
                     "lateral stress is constant." +
                     words_on_water(tests);
    return figure;
}

} // namespace suffuse::figures
