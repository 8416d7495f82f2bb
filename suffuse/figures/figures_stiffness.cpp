#include "suffuse/figures/figures_stiffness.hpp"

#include "suffuse/base/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace suffuse::figures {
namespace {

using nlohmann::json;

constexpr double MPa = 1e6, kPa = 1e3;
constexpr double percent = 100;

struct SecantModulus {
    double strain;  ///< engineering shear strain [-]
    double modulus; ///< [Pa]
};

double small_strain_modulus(const LaboratoryTest& probed) {
    return probed.stage->numbers.at("shear_modulus").get<double>();
}

/// Since the first row of the test, where it has strained.
std::vector<SecantModulus> secant_moduli(const LaboratoryTest& test) {
    const triaxial::TriaxialSpec& spec = *casefile::laboratory_test(test.stage->stage->spec);
    const std::vector<triaxial::PathRow>& curve = test.stage->findings.curve;
    std::vector<SecantModulus> moduli;
    for (const triaxial::PathRow& row : curve) {
        double strain = row.shear_strain, stress = triaxial::shear_stress(spec, row.stress - curve.front().stress);
        if (!triaxial::shears(spec.path)) { // lateral strains are alike: half of what the axial one leaves
            strain = 1.5 * row.axial_strain - 0.5 * row.volumetric_strain;
            stress = 0.5 * (row.deviator_stress - curve.front().deviator_stress);
        }
        if (stress * strain > 0) {
            moduli.push_back({std::abs(strain), stress / strain});
        }
    }
    return moduli;
}

/// Of the first test from the state that was probed; empty where there is none, or where it stays stiffer.
std::string where_half_is_gone(const LaboratoryTest& probed, const std::vector<LaboratoryTest>& loaded) {
    const auto from_there = std::ranges::find_if(loaded, [&](const LaboratoryTest& test) {
        return test.stage->variant == probed.stage->variant && test.stage->stage->from == probed.stage->stage->from;
    });
    if (from_there == loaded.end()) {
        return "";
    }
    const std::vector<SecantModulus> moduli = secant_moduli(*from_there);
    const double half = 0.5 * small_strain_modulus(probed);
    const auto first = std::ranges::find_if(moduli, [half](const SecantModulus& each) { return each.modulus < half; });
    if (first == moduli.end()) {
        return "";
    }
    return fmt::format(
        "{}: G falls below half of G₀ by {} % of shear strain", from_there->name,
        short_number(percent * first->strain, 2)
    );
}

json modulus_over_strain() {
    const auto axis = [](const char* field, const char* title, const char* scale) {
        return json{
            {"field", field},
            {"type", "quantitative"},
            {"title", title},
            {"axis", {{"format", "~g"}}},
            {"scale", {{"type", scale}, {"nice", false}, {"padding", 10}}}};
    };
    json strain = axis("shear_strain", "shear strain γ [%]", "log");
    strain["axis"] = {{"labelExpr", power_of_ten_labels()}};
    json chart{{"width", 480}, {"height", 260}, {"mark", {{"type", "line"}, {"point", {{"size", 16}}}}}};
    chart["encoding"] = {
        {"x", strain},
        {"y", axis("secant_shear_modulus", "secant shear modulus G [MPa]", "linear")},
        {"color",
         {{"field", "test"},
          {"type", "nominal"},
          {"title", nullptr},
          {"sort", nullptr},
          {"scale", {{"range", color::sequence()}}}}},
        {"tooltip",
         {{{"field", "test"}},
          {{"field", "shear_strain"}, {"format", ".3~g"}},
          {{"field", "secant_shear_modulus"}, {"format", ".3~g"}}}}};
    return chart;
}

} // namespace

std::optional<Figure> stiffness_points(const std::vector<LaboratoryTest>& probed) {
    if (probed.empty()) {
        return std::nullopt;
    }
    Figure figure;
    figure.id = "own-stiffness";
    figure.section = "Tests";
    figure.title = "Small-strain stiffness";
    std::vector<std::string> names;
    for (const LaboratoryTest& test : probed) {
        names.push_back(test.name);
    }
    figure.table.add("test", std::move(names));
    const auto add = [&](const char* key, const char* unit, double size) {
        std::vector<double> values;
        for (const LaboratoryTest& test : probed) {
            const json& value = test.stage->numbers.at(key);
            values.push_back(value.is_number() ? value.get<double>() / size : missing);
        }
        figure.table.add(key, unit, std::move(values));
    };
    add("mean_stress", "kPa", kPa);
    add("void_ratio", "-", 1);
    for (const char* modulus : {"young_modulus", "shear_modulus", "mean_field_shear", "bulk_modulus"}) {
        add(modulus, "MPa", MPa);
    }
    add("poisson_ratio", "-", 1);
    add("anisotropy", "-", 1);
    json layers = json::array();
    for (const auto& [key, name] : {std::pair{"shear_modulus", "measured"}, {"mean_field_shear", "mean-field bound"}}) {
        const auto axis = [](const char* field, const char* title) {
            return json{
                {"field", field},
                {"type", "quantitative"},
                {"title", title},
                {"axis", {{"format", ".3~g"}}},
                {"scale", {{"type", "log"}, {"nice", false}, {"padding", 20}}}};
        };
        json layer{{"mark", {{"type", "point"}, {"filled", true}, {"size", 60}}}};
        layer["encoding"] = {
            {"x", axis("mean_stress", "effective mean stress p′ [kPa]")},
            {"y", axis(key, "shear modulus G₀ [MPa]")},
            {"color", {{"datum", name}, {"scale", {{"range", color::sequence()}}}}},
            {"tooltip",
             {{{"field", "test"}},
              {{"field", "mean_stress"}, {"format", ".4g"}},
              {{"field", key}, {"format", ".4g"}},
              {{"field", "void_ratio"}, {"format", ".3f"}}}}};
        layers.push_back(layer);
    }
    figure.chart = {{"width", 480}, {"height", 260}, {"layer", layers}};
    std::string all;
    for (const LaboratoryTest& test : probed) {
        const json& of = test.stage->numbers;
        const auto number = [&](const char* key, double size) {
            return short_number(of.at(key).get<double>() / size, 3);
        };
        all += fmt::format(
            "{}{}: G₀ {} MPa, E₀ {} MPa, ν {}", all.empty() ? "" : "; ", test.name, number("shear_modulus", MPa),
            number("young_modulus", MPa), number("poisson_ratio", 1)
        );
    }
    figure.claim = as_sentence(all.substr(0, all.find(';')));
    figure.caption = as_sentence(all) + ". The bound is the modulus of grains that all move with the mean strain.";
    return figure;
}

std::optional<Figure>
stiffness_over_strain(const std::vector<LaboratoryTest>& probed, const std::vector<LaboratoryTest>& loaded) {
    std::vector<std::string> names;
    std::vector<double> strains, moduli;
    const auto add = [&](const std::string& name, const SecantModulus& secant) {
        names.push_back(name), strains.push_back(percent * secant.strain), moduli.push_back(secant.modulus / MPa);
    };
    for (const LaboratoryTest& test : probed) {
        const double strain = std::get<triaxial::StiffnessSpec>(test.stage->stage->spec).increment;
        add(test.name, {strain, small_strain_modulus(test)});
    }
    for (const LaboratoryTest& test : loaded) {
        for (const SecantModulus& secant : secant_moduli(test)) {
            add(test.name, secant);
        }
    }
    if (probed.empty() || names.size() == probed.size()) {
        return std::nullopt;
    }
    Figure figure;
    figure.id = "own-stiffness-strain";
    figure.section = "Tests";
    figure.title = "Stiffness against strain";
    figure.claim = where_half_is_gone(probed.front(), loaded);
    figure.table.add("test", std::move(names));
    figure.table.add("shear_strain", "%", std::move(strains));
    figure.table.add("secant_shear_modulus", "MPa", std::move(moduli));
    figure.chart = modulus_over_strain();
    figure.caption =
        "A single point is a small strain on a copy of a state. A curve is a test's secant from its start on.";
    return figure;
}

} // namespace suffuse::figures
