#include "suffuse/job/calibration_report.hpp"

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/read_text.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/figures/figures_calibration.hpp"
#include "suffuse/job/calibration_files.hpp"
#include "suffuse/job/calibration_words.hpp"
#include "suffuse/job/draw_figures.hpp"
#include "suffuse/job/report_data.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/stored.hpp"
#include "suffuse/report/html.hpp"
#include "suffuse/report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace suffuse::job {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Names and rows of posterior.csv, in SI.
struct PosteriorTable {
    std::vector<std::string> keys;
    std::vector<std::vector<double>> rows;
};

PosteriorTable read_posterior(const fs::path& file) {
    PosteriorTable table;
    std::istringstream lines(read_whole_file(file));
    std::string line, cell;
    for (bool is_head = true; std::getline(lines, line); is_head = false) {
        std::istringstream cells(line);
        std::vector<double> row;
        while (std::getline(cells, cell, ',')) {
            if (is_head) {
                table.keys.push_back(cell);
            } else {
                row.push_back(std::strtod(cell.c_str(), nullptr));
            }
        }
        if (!is_head && row.size() != table.keys.size()) {
            throw IoError(fmt::format(
                "{}: a row has {} numbers, and there are {} keys", file.string(), row.size(), table.keys.size()
            ));
        }
        if (!is_head) {
            table.rows.push_back(std::move(row));
        }
    }
    return table;
}

/// What the page is made from.
struct FoundCalibration {
    json answer;
    std::vector<std::string> keys; ///< in the order of the case
    std::vector<figures::CalibratedParameter> parameters;
    PosteriorTable posterior; ///< in the units of the parameters
};

figures::CalibratedParameter parameter_of(const std::string& key, const json& stored) {
    const double size = stored.at("unit_size");
    const auto number = [&](const json& value) { return value.get<double>() / size; };
    figures::CalibratedParameter parameter;
    parameter.name = key_in_words(key);
    parameter.field = key;
    std::ranges::replace_if(
        parameter.field, [](unsigned char c) { return std::isalnum(c) == 0; }, '_'
    );
    parameter.unit = stored.at("unit") == "deg" ? "°" : stored.at("unit").get<std::string>();
    parameter.best = number(stored.at("best"));
    parameter.low = number(stored.at("low"));
    parameter.high = number(stored.at("high"));
    parameter.least = number(stored.at("range").at(0));
    parameter.most = number(stored.at("range").at(1));
    parameter.is_log = stored.at("logarithmic");
    parameter.is_identified = stored.at("identified");
    return parameter;
}

FoundCalibration read_found(const fs::path& folder) {
    const fs::path file = folder / calibration_file;
    if (!fs::exists(file)) {
        throw IoError(fmt::format(
            "{}: holds no answer yet: the calibration was stopped before its first round ended; continue it with "
            "suffuse resume {}",
            folder.string(), shell_word(folder.string())
        ));
    }
    FoundCalibration found;
    found.answer = record::read_json(file);
    found.posterior = read_posterior(folder / posterior_file);
    found.keys = found.posterior.keys;
    record::take_from(file, [&] {
        for (const std::string& key : found.keys) {
            found.parameters.push_back(parameter_of(key, found.answer.at("parameters").at(key)));
        }
        for (std::vector<double>& row : found.posterior.rows) {
            for (std::size_t k = 0; k < row.size(); ++k) {
                row[k] /= found.answer.at("parameters").at(found.keys[k]).at("unit_size").get<double>();
            }
        }
    });
    return found;
}

struct CurveWords {
    const char *key, *symbol;
    double size; ///< of 1 in the figure
};

CurveWords words_on(const std::string& quantity) {
    for (const CurveWords& words :
         {CurveWords{"stress_ratio", "q/p₀", 1},
          {"volumetric_strain", "εᵥ [%]", 0.01},
          {"mean_stress_ratio", "p′/p₀", 1},
          {"axial_strain", "ε₁ [%]", 0.01}}) {
        if (quantity == words.key) {
            return words;
        }
    }
    return {"", "", 1};
}

std::vector<figures::CalibratedCurve> curves_in(const json& fits) {
    std::vector<figures::CalibratedCurve> curves;
    for (const json& fit : fits) {
        const bool is_oedometer = fit.contains("axial_stress");
        const double x_size = is_oedometer ? 1e3 : 0.01;
        for (const json& stored : fit.at("curves")) {
            const CurveWords words = words_on(stored.at("quantity"));
            const auto numbers = [](const json& values, double size) {
                auto all = values.get<std::vector<double>>();
                for (double& value : all) {
                    value /= size;
                }
                return all;
            };
            figures::CalibratedCurve& curve = curves.emplace_back();
            curve.target = fit.at("target");
            curve.quantity = words.symbol;
            curve.x_title = is_oedometer ? "axial stress [kPa]" : "axial strain [%]";
            curve.x = numbers(fit.at(is_oedometer ? "axial_stress" : "axial_strain"), x_size);
            curve.measured = numbers(stored.at("measured"), words.size);
            curve.model = numbers(stored.at("model"), words.size);
            curve.band = numbers(stored.at("model_error"), words.size);
            for (double& half : curve.band) {
                half *= fit.value("band_90", figures::missing);
            }
            curve.relative_misfit = stored.at("relative_misfit");
        }
    }
    return curves;
}

std::vector<figures::CalibrationSampleFit> sample_fits_in(const FoundCalibration& found) {
    std::vector<figures::CalibrationSampleFit> samples;
    for (const json& stored : found.answer.value("samples", json::array())) {
        figures::CalibrationSampleFit& sample = samples.emplace_back();
        sample.target = stored.at("target");
        sample.round = stored.at("round");
        sample.misfit = stored.value("misfit", figures::missing);
        for (const std::string& key : found.keys) {
            sample.values.push_back(
                stored.at("values").at(key).get<double>() /
                found.answer.at("parameters").at(key).at("unit_size").get<double>()
            );
        }
    }
    return samples;
}

figures::PageTable parameters_table(const FoundCalibration& found) {
    figures::PageTable table;
    table.section = "Parameters";
    table.title = "Parameters";
    table.note =
        "The likeliest values belong together. An interval contains the parameter with a probability of 90 %, if the "
        "model can behave like the soil. Share: width of the interval over that of the range. The mean over a "
        "logarithmic range is the geometric one.";
    table.header = {"parameter", "likeliest", "mean", "90 % interval", "range of the case", "share", "verdict"};
    table.numeric = {false, true, true, true, true, true, false};
    for (const std::string& key : found.keys) {
        const json& p = found.answer.at("parameters").at(key);
        std::string remark = p.at("identified") ? "identified" : "not identified";
        if (const std::string remedy = p.value("identified_by", std::string()); !remedy.empty()) {
            remark += fmt::format("; add {}", remedy_in_words(remedy));
        }
        if (p.contains("bound")) {
            remark += p.at("bound") == "low" ? "; at its lower bound" : "; at its upper bound";
        }
        table.rows.push_back(
            {key, value_in_words(p, p.at("best")),
             value_in_words(p, p.at("mean")) + (p.at("logarithmic") ? " (geometric)" : ""), interval_in_words(p),
             fmt::format(
                 "{} to {}{}", value_in_words(p, p.at("range").at(0)), value_in_words(p, p.at("range").at(1)),
                 p.at("logarithmic") ? ", log" : ""
             ),
             short_number(p.at("relative_width"), 2), remark}
        );
    }
    return table;
}

figures::PageTable correlations_table(const FoundCalibration& found) {
    figures::PageTable table;
    table.section = "Parameters";
    table.title = "Correlations";
    table.note = "Near 1 or −1, the tests fix a combination of the two better than each. Take both from one row of "
                 "posterior.csv.";
    table.header = {""};
    table.numeric = {false};
    for (const std::string& key : found.keys) {
        table.header.push_back(key_in_words(key));
        table.numeric.push_back(true);
        std::vector<std::string>& row = table.rows.emplace_back();
        row.push_back(key_in_words(key));
        for (const std::string& other : found.keys) {
            row.push_back(report::in_figures(found.answer.at("correlation").at(key).at(other), 2));
        }
    }
    return table;
}

figures::PageTable tests_table(const json& answer) {
    figures::PageTable table;
    table.section = "Fit";
    table.title = "Tests";
    table.note = "Misfit: root mean square of model minus laboratory, over the largest measured value.";
    table.header = {"test", "record", "pressure", "counts as", "misfit", "samples", "failed"};
    table.numeric = {false, false, true, false, false, true, true};
    for (const char* kind : {"fit", "held_out"}) {
        for (const json& fit : answer.at(kind)) {
            std::string misfits;
            for (const json& curve : fit.at("curves")) {
                misfits += fmt::format(
                    "{}{} {} %", misfits.empty() ? "" : ", ", quantity_in_words(curve.at("quantity")),
                    short_number(100 * curve.at("relative_misfit").get<double>(), 2)
                );
            }
            const std::string sample = fit.at("sample");
            table.rows.push_back(
                {fit.at("target"),
                 fs::path(fit.at("file").get<std::string>()).filename().string() +
                     (sample.empty() ? "" : ", " + sample),
                 short_number(fit.at("pressure").get<double>() / 1e3, 4) + " kPa",
                 kind == std::string("fit") ? "fitted" : "held out", misfits,
                 std::to_string(fit.at("samples").get<int>()), std::to_string(fit.at("failed").get<int>())}
            );
        }
    }
    return table;
}

/// Each record once, with what was found of it.
figures::PageTable records_table(const json& answer) {
    figures::PageTable table;
    table.section = "Fit";
    table.title = "How the records were read";
    table.note = "Found: the file decides. Assumed: correct it by the heading of the column if it is not so.";
    table.header = {"record", "", "what"};
    table.numeric = {false, false, false};
    for (const char* kind : {"fit", "held_out"}) {
        for (const json& fit : answer.at(kind)) {
            const std::string record = fs::path(fit.at("file").get<std::string>()).filename().string();
            for (const auto& [key, word] :
                 {std::pair("assumed", "assumed"), {"unread", "not read"}, {"decided", "found"}}) {
                for (const json& text : fit.value(key, json::array())) {
                    std::vector<std::string> row = {record, word, text.get<std::string>()};
                    if (std::ranges::find(table.rows, row) == table.rows.end()) {
                        table.rows.push_back(std::move(row));
                    }
                }
            }
        }
    }
    return table;
}

figures::PageTable rounds_table(const FoundCalibration& found) {
    figures::PageTable table;
    table.section = "Samples";
    table.title = "Rounds";
    table.note = "Width: mean of the intervals after the round, over those of the ranges.";
    table.header = {"round", "sets of parameters", "samples", "failed", "width"};
    table.numeric = {false, true, true, true, true};
    for (const std::string& key : found.keys) {
        table.header.push_back(key_in_words(key));
        table.numeric.push_back(true);
    }
    int number = 0;
    for (const json& round : found.answer.at("rounds")) {
        std::vector<std::string>& row = table.rows.emplace_back();
        row = {
            std::to_string(++number), std::to_string(round.at("designs").get<int>()),
            std::to_string(round.at("samples").get<int>()), std::to_string(round.at("failed").get<int>()),
            short_number(round.at("relative_width"), 2)};
        for (const std::string& key : found.keys) {
            json parameter = found.answer.at("parameters").at(key);
            parameter.update(round.at("parameters").at(key));
            row.push_back(interval_in_words(parameter));
        }
    }
    return table;
}

answer::Opening opening_of(const FoundCalibration& found) {
    answer::Opening opening;
    opening.verdict = verdict_of(found.answer);
    opening.confidence = "Intervals checked in part";
    opening.about_confidence = as_sentence(fmt::format(
        "{}. Take them as the order of what the tests leave open; they hold only if the model can behave like the "
        "soil.",
        calibration_caution
    ));
    opening.doubts = doubts_on(found.answer);
    constexpr std::size_t most_cards = 6;
    for (const std::string& key : found.keys) {
        const json& p = found.answer.at("parameters").at(key);
        answer::Headline card;
        card.label = as_sentence(key_in_words(key));
        card.value = value_in_words(p, p.at("best"));
        card.detail = "90 %: " + interval_in_words(p);
        card.caution = p.contains("bound") ? "at a bound of its range" : p.at("identified") ? "" : "not identified";
        if (opening.cards.size() < most_cards) {
            opening.cards.push_back(std::move(card));
        }
    }
    opening.pictures = {"own-calibration-fit", "own-calibration-intervals"};
    return opening;
}

report::ReportData describe_calibration(const FoundCalibration& found, const fs::path& folder) {
    const json& answer = found.answer;
    report::ReportData data;
    data.title =
        answer.at("title").get<std::string>().empty() ? "A calibration" : answer.at("title").get<std::string>();
    data.run = fs::absolute(folder).lexically_normal().filename().string();
    data.request =
        fmt::format("calibration of the soil {} from tests of a laboratory", answer.at("soil").get<std::string>());
    data.opening = opening_of(found);
    if (!answer.at("complete")) {
        data.unfinished = {
            "This is the answer of the rounds that have ended", "suffuse resume " + shell_word(folder.string())};
    }
    for (const json& failure : answer.at("failures")) {
        data.warnings.push_back(fmt::format(
            "{} failed, and counts as such: {}", failure.at("sample").get<std::string>(),
            failure.at("message").get<std::string>()
        ));
    }
    data.tables = {
        parameters_table(found), correlations_table(found), tests_table(answer), records_table(answer),
        rounds_table(found)};
    data.figures.push_back(figures::calibration_intervals(found.parameters));
    for (std::optional<figures::Figure> figure :
         {figures::calibration_corner(found.parameters, found.posterior.rows),
          figures::calibration_fits(curves_in(answer.at("fit")), false),
          figures::calibration_fits(curves_in(answer.at("held_out")), true),
          figures::calibration_misfits(found.parameters, sample_fits_in(found))}) {
        if (figure) {
            data.figures.push_back(std::move(*figure));
        }
    }
    data.texts.push_back({"Parameters", "For your case", answer.at("contact").get<std::string>()});
    if (const fs::path file = folder / record::provenance_file; fs::exists(file)) {
        take_provenance(data, folder, record::read_json(file));
    }
    data.redraw = "suffuse report " + shell_word(folder.string());
    return data;
}

} // namespace

fs::path write_calibration_report(const fs::path& folder, const fs::path& page_folder) {
    const FoundCalibration found = read_found(folder);
    report::ReportData data =
        record::take_from(folder / calibration_file, [&] { return describe_calibration(found, folder); });
    report::write_figures(folder, data);
    if (data.unfinished.missing.empty()) { // drawings take seconds, and the next round writes another report
        draw_in_page(data.figures, folder, page_folder);
    }
    return report::write_page(folder, data, page_folder).file;
}

} // namespace suffuse::job
