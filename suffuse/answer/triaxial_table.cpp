#include "suffuse/answer/triaxial_table.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/facts/shown.hpp"
#include "suffuse/study/trace_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

namespace suffuse::answer {
namespace {

using nlohmann::json;
using study::SweepPoint;
using triaxial::Path;
using triaxial::TriaxialSpec;

constexpr double least_strain = 0.02; // of a test whose dilatancy, a slope over one percent, is shown [-]
const char* const empty = "–";
const char* const liquefied = "liquefied"; // name of a column

/// What a path shows.
struct Shows {
    bool always = true;
    bool settles, strength, stiffness, dilatancy, volume, pore_pressure;

    explicit Shows(const TriaxialSpec& test)
        : settles(test.deviator_stress || test.stress_ratio), strength(!settles && test.path != Path::Proportional),
          stiffness(strength && test.path != Path::ConstantDeviator),
          dilatancy(
              strength && test.strain > least_strain && (test.path == Path::Drained || test.path == Path::ConstantMean)
          ),
          volume(test.path != Path::Undrained),
          pore_pressure(test.path == Path::Undrained || test.path == Path::ConstantDeviator) {}
};

/// A number of the response, with the unit and the digits of its fact.
struct ResponseColumn {
    const char* words;
    const char* number;
    bool Shows::*shows;
    const char* fact = number;

    [[nodiscard]] std::string head() const { return fmt::format("{} [{}]", words, facts::unit_shown(fact)); }
};

constexpr std::array response_columns{
    ResponseColumn{"highest q", "peak_deviator", &Shows::strength},
    ResponseColumn{"at ε₁", "peak_strain", &Shows::strength},
    ResponseColumn{"friction angle φ there", "friction_angle", &Shows::strength},
    ResponseColumn{"q at the end", "final_deviator", &Shows::always},
    ResponseColumn{"E50", "stiffness", &Shows::stiffness},
    ResponseColumn{"dilatancy", "dilatancy", &Shows::dilatancy},
    ResponseColumn{"εᵥ at the end", "final_volumetric_strain", &Shows::volume},
    ResponseColumn{"unstable from q", "instability.q", &Shows::pore_pressure, "deviator_stress"},
    ResponseColumn{"excess pore pressure Δu", "excess_pore_pressure", &Shows::always}};

/// Mean, and the standard deviation where there are several samples.
std::string cell(const SweepPoint& point, const ResponseColumn& column, bool settles) {
    // A test that came to rest at a stress went beyond it before: what counts is the state that it left.
    const bool is_end_of_settled = settles && std::string_view(column.number) == "final_deviator";
    const auto found =
        point.number.find(is_end_of_settled ? "deviator_stress" : std::string("response.") + column.number);
    return found == point.number.end()
               ? empty
               : study::with_scatter(
                     found->second, facts::in_unit_shown(column.fact, 1), facts::digits_shown(column.fact)
                 );
}

/// "no", "yes", "2 of 3"; empty where the test cannot.
std::string count_liquefied(const std::vector<json>& responses) {
    std::size_t able = 0, flowed = 0;
    for (const json& response : responses) {
        const json reported = response.value("liquefied", json());
        able += reported.is_boolean() ? 1 : 0;
        flowed += reported == true ? 1 : 0;
    }
    if (able == 0) {
        return empty;
    }
    return flowed == 0 ? "no" : able == 1 ? "yes" : fmt::format("{} of {}", flowed, able);
}

std::vector<std::string>
row_of(const std::string& name, const TriaxialSpec& test, const SweepPoint& point, const std::vector<json>& responses) {
    const Shows shows(test);
    std::vector<std::string> row{name, std::to_string(responses.size())};
    for (const ResponseColumn& column : response_columns) {
        row.push_back(shows.*column.shows ? cell(point, column, shows.settles) : empty);
    }
    row.push_back(count_liquefied(responses));
    return row;
}

void leave_out_empty_columns(figures::PageTable& table) {
    for (std::size_t column = table.header.size(); column-- > 0;) {
        const auto at = static_cast<std::ptrdiff_t>(column);
        if (std::ranges::all_of(table.rows, [&](const auto& row) { return row[column] == empty; })) {
            table.header.erase(table.header.begin() + at);
            table.numeric.erase(table.numeric.begin() + at);
            for (std::vector<std::string>& row : table.rows) {
                row.erase(row.begin() + at);
            }
        }
    }
}

/// Of the samples at one set of sweep values.
std::vector<json> responses_of(
    const casefile::Study& study, const casefile::Stage& stage, const SweepPoint& point,
    const std::vector<record::FinishedStage>& stages
) {
    std::vector<json> responses;
    for (const record::FinishedStage& each : stages) {
        if (each.numbers.contains("response") && study::is_behind(each, study, stage, point)) {
            responses.push_back(each.numbers.at("response"));
        }
    }
    return responses;
}

} // namespace

std::optional<figures::PageTable> tabulate_tests(const study::RunResults& results) {
    figures::PageTable table;
    table.section = "Tests";
    table.title = "Strength and deformation";
    table.note =
        "E50 is the secant stiffness at half the highest deviator stress, dilatancy the largest −dεᵥ/dε₁ over one "
        "percent. Contraction positive.";
    table.header = {"test", "samples"};
    std::ranges::transform(response_columns, std::back_inserter(table.header), &ResponseColumn::head);
    table.header.emplace_back(liquefied);
    table.numeric.assign(table.header.size(), true);
    table.numeric[0] = false;
    const std::vector<study::StudyCurves>& traced = results.curves;
    for (std::size_t s = 0; s < traced.size(); ++s) {
        const casefile::Study& study = results.what->studies[s];
        for (std::size_t k = 0; k < study.stages.size(); ++k) {
            const TriaxialSpec* const test = casefile::laboratory_test(study.stages[k].spec);
            for (const SweepPoint& point : traced[s].stages[k].points) {
                const auto responses = responses_of(study, study.stages[k], point, results.stages);
                if (test != nullptr && !responses.empty()) {
                    const std::string values = study::values_name(traced[s].keys, point);
                    const std::string name =
                        fmt::format("{}, {}{}{}", study.name, study.stages[k].name, values.empty() ? "" : ", ", values);
                    table.rows.push_back(row_of(name, *test, point, responses));
                }
            }
        }
    }
    leave_out_empty_columns(table);
    if (std::ranges::find(table.header, liquefied) != table.header.end()) {
        table.note +=
            " Of a test at constant deviator stress, highest q is that where the pore pressure is highest. Unstable: "
            "the second-order work is first no longer above zero, and loads instead of strains would make the sample "
            "fail. Excess pore pressure: at the end of an undrained test, or the most that is borne while the deviator "
            "is held. Liquefied: the mean stress fell below 5 % of its start.";
    }
    return table.rows.empty() ? std::nullopt : std::optional(std::move(table));
}

} // namespace suffuse::answer
