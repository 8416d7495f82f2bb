#include "suffuse/job/calibration_files.hpp"

#include "suffuse/base/units.hpp"
#include "suffuse/casefile/node.hpp"
#include "suffuse/casefile/sweep_value.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/job/calibration_words.hpp"
#include "suffuse/record/folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace suffuse::job {
namespace {

using nlohmann::json;

constexpr std::string_view contact_prefix = "contact.";

std::string_view key_of(Remedy remedy) {
    constexpr std::array<std::string_view, 5> keys = {
        "", "volumetric_strain", "other_pressure", "larger_samples", "oedometer"};
    return keys[static_cast<std::size_t>(remedy)];
}

/// The unit in which the range was written, and how large it is in SI.
std::pair<std::string, double> unit_of(const casefile::CalibrateUnknown& unknown) {
    if (unknown.dimension == dimension::none) {
        return {"", 1};
    }
    const std::string text = casefile::written(unknown.low); // a text: it has a dimension
    const std::string unit = text.substr(std::min(text.find_first_not_of("0123456789.eE+- _"), text.size()));
    return {unit, parse_unit(unit, unknown.dimension)};
}

/// Of numbers in SI.
std::string si_unit(Dimension dimension) {
    const std::vector<std::string> units = usual_units(dimension);
    const auto found =
        std::ranges::find_if(units, [&](const std::string& unit) { return parse_unit(unit, dimension) == 1; });
    return found == units.end() ? "-" : *found;
}

json parameter_json(const ParameterResult& parameter) {
    const calibration::Bound bound = parameter.interval.bound;
    json one = {
        {"mean", parameter.mean},
        {"low", parameter.low},
        {"high", parameter.high},
        {"best", parameter.best},
        {"si_unit", si_unit(parameter.unknown.dimension)},
        {"identified", parameter.interval.is_identified()},
        {"at_bound", bound != calibration::Bound::None},
        {"range", {parameter.unknown.least, parameter.unknown.most}},
        {"logarithmic", parameter.unknown.is_log},
        {"relative_width", parameter.interval.width},
        {"information", parameter.interval.information}};
    std::tie(one["unit"], one["unit_size"]) = unit_of(parameter.unknown);
    if (bound != calibration::Bound::None) {
        one["bound"] = bound == calibration::Bound::Low ? "low" : "high";
    }
    if (parameter.remedy != Remedy::None) {
        one["identified_by"] = key_of(parameter.remedy);
    }
    return one;
}

json fit_json(const TargetFit& fit) {
    const std::size_t n = fit.laboratory.form.grid.size();
    const auto part_of = [&](const std::vector<double>& values, std::size_t part) {
        const auto begin = values.begin() + static_cast<std::ptrdiff_t>(part * n);
        return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(n));
    };
    json curves = json::array();
    for (std::size_t part = 0; part < fit.laboratory.form.measured.size() && !fit.model.empty(); ++part) {
        curves.push_back(
            {{"quantity", key_of(fit.laboratory.form.measured[part])},
             {"measured", part_of(fit.laboratory.values, part)},
             {"scatter", fit.laboratory.deviations[part * n]},
             {"model", part_of(fit.model, part)},
             {"model_error", part_of(fit.model_deviation, part)},
             {"relative_misfit", relative_misfit(fit, part)}}
        );
        if (!fit.seed_scatter.empty()) {
            curves.back()["seed_scatter"] = part_of(fit.seed_scatter, part);
        }
    }
    const bool is_oedometer = fit.target.test == casefile::CalibrateTest::Oedometer;
    json one = {
        {"target", fit.target.name},
        {"file", fit.target.file},
        {"sample", fit.target.sample},
        {"pressure", fit.target.pressure},
        {is_oedometer ? "axial_stress" : "axial_strain", fit.laboratory.form.grid},
        {"curves", std::move(curves)},
        {"samples", fit.samples},
        {"failed", fit.failed}};
    for (const char* key : {"decided", "assumed"}) {
        one[key] = json::array();
    }
    for (const laboratory::Finding& finding : fit.laboratory.findings) {
        one[finding.is_assumed ? "assumed" : "decided"].push_back(finding.text);
    }
    one["unread"] = fit.laboratory.unread;
    if (std::isfinite(fit.band)) {
        one["band_90"] = fit.band;
    }
    return one;
}

json round_json(const RoundResult& round) {
    json parameters = json::object();
    for (const ParameterResult& p : round.parameters) {
        parameters[p.unknown.key] = {{"best", p.best}, {"low", p.low}, {"high", p.high}};
    }
    return {
        {"designs", round.designs},
        {"samples", round.samples},
        {"failed", round.failed},
        {"relative_width", round.width},
        {"parameters", std::move(parameters)}};
}

json sample_json(const SampleFit& sample, const std::vector<ParameterResult>& parameters) {
    json one = {{"round", sample.round}, {"target", sample.target}, {"design", sample.design}};
    if (sample.failure.empty()) {
        one["misfit"] = sample.misfit;
    } else {
        one["failure"] = sample.failure;
    }
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        one["values"][parameters[k].unknown.key] = sample.values[k];
    }
    return one;
}

/// As a case has it: what has a unit is a text.
std::string written(const casefile::CalibrateUnknown& unknown, double value) {
    const std::string text = shown_value(unknown, value);
    return unknown.dimension == dimension::none ? text : fmt::format("\"{}\"", text);
}

} // namespace

std::string_view words_of(Remedy remedy) {
    return remedy_in_words(key_of(remedy));
}

std::string shown_value(const casefile::CalibrateUnknown& unknown, double value) {
    const auto [unit, size] = unit_of(unknown);
    return fmt::format("{:.4g}{}{}", value / size, unit.empty() ? "" : " ", unit);
}

double relative_misfit(const TargetFit& fit, std::size_t part) {
    const std::size_t n = fit.laboratory.form.grid.size();
    double squares = 0, largest = 0;
    for (std::size_t k = part * n; k < (part + 1) * n; ++k) {
        squares += std::pow(fit.model[k] - fit.laboratory.values[k], 2);
        largest = std::max(largest, std::abs(fit.laboratory.values[k]));
    }
    return std::sqrt(squares / static_cast<double>(n)) / largest;
}

json calibration_json(const casefile::CalibrationCase& what, const CalibrationResult& result) {
    json document = {
        {"title", what.title},
        {"seed", what.seed},
        {"soil", what.spec.soil},
        {"particles", what.spec.particles},
        {"complete", result.is_complete},
        {"parameters", json::object()},
        {"correlation", json::object()},
        {"effective_samples", result.effective_samples},
        {"log_likelihood", result.log_likelihood},
        {"fit", json::array()},
        {"held_out", json::array()},
        {"rounds", json::array()},
        {"samples", json::array()},
        {"failures", result.failures},
        {"contact", contact_block(what, result)}};
    for (std::size_t a = 0; a < result.parameters.size(); ++a) {
        const std::string& key = result.parameters[a].unknown.key;
        document["parameters"][key] = parameter_json(result.parameters[a]);
        for (std::size_t b = 0; b < result.parameters.size(); ++b) {
            document["correlation"][key][result.parameters[b].unknown.key] = result.correlations[a][b];
        }
    }
    for (const TargetFit& fit : result.fits) {
        document[fit.target.is_held_out ? "held_out" : "fit"].push_back(fit_json(fit));
    }
    for (const RoundResult& round : result.rounds) {
        document["rounds"].push_back(round_json(round));
    }
    for (const SampleFit& sample : result.samples) {
        document["samples"].push_back(sample_json(sample, result.parameters));
    }
    document["verdict"] = verdict_of(document);
    return document;
}

std::string posterior_csv(const CalibrationResult& result) {
    std::string text;
    for (const ParameterResult& parameter : result.parameters) {
        text += (text.empty() ? "" : ",") + parameter.unknown.key;
    }
    text += "\n";
    for (const std::vector<double>& row : result.posterior) {
        for (std::size_t k = 0; k < row.size(); ++k) {
            text += fmt::format("{}{}", k == 0 ? "" : ",", row[k]);
        }
        text += "\n";
    }
    return text;
}

std::string contact_block(const casefile::CalibrationCase& what, const CalibrationResult& result) {
    std::string text = fmt::format(
        "# From {}: suffuse calibrate, {} grains, seed {}; comments are 90 % intervals.\n[contact]\n",
        what.title.empty() ? "a calibration" : what.title, what.spec.particles, what.seed
    );
    const casefile::Node::Entry* contact = what.base.find("contact");
    const auto is_sought = [&](const std::string& key) {
        return std::ranges::any_of(result.parameters, [&](const ParameterResult& p) {
            return p.unknown.key == std::string(contact_prefix) + key;
        });
    };
    if (contact != nullptr) {
        for (const casefile::Node::Entry& entry : contact->value.entries) {
            if (!is_sought(entry.key)) {
                text += fmt::format("{} = {}\n", entry.key, casefile::print_value(entry.value));
            }
        }
    }
    for (const ParameterResult& p : result.parameters) {
        const bool is_contact = p.unknown.key.starts_with(contact_prefix);
        text += fmt::format(
            "{}{} = {}   # {} to {}{}\n", is_contact ? "" : "# ",
            is_contact ? p.unknown.key.substr(contact_prefix.size()) : p.unknown.key, written(p.unknown, p.best),
            shown_value(p.unknown, p.low), shown_value(p.unknown, p.high),
            p.interval.is_identified() ? "" : ", not identified"
        );
    }
    return text;
}

void write_calibration(
    const std::filesystem::path& folder, const casefile::CalibrationCase& what, const CalibrationResult& result
) {
    io::write_file(folder / posterior_file, posterior_csv(result));
    io::write_file(folder / "contact.toml", contact_block(what, result));
    record::write_json(folder / calibration_file, calibration_json(what, result));
}

} // namespace suffuse::job
