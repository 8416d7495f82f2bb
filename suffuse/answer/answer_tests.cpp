#include "suffuse/answer/answer_tests.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/study/strength_pairs.hpp"
#include "suffuse/study/trace_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace suffuse::answer {
namespace {

using nlohmann::json;

/// "75.17 kPa at 1.8 % axial strain", or between which values those of samples lie that differ in their seed only.
/// @param pressure, strain keys of a response that stand in the sentence
std::string describe_peaks(const std::vector<json>& responses, const char* pressure, const char* strain) {
    const auto kilopascals = [&](const json& response) { return response.at(pressure).get<double>() / 1e3; };
    if (responses.size() == 1) {
        const json& only = responses.front();
        return fmt::format(
            "{} kPa at {} % axial strain", short_number(kilopascals(only), 4),
            short_number(100 * only.at(strain).get<double>(), 2)
        );
    }
    double lowest = kilopascals(responses.front()), highest = lowest;
    for (const json& response : responses) {
        lowest = std::min(lowest, kilopascals(response)), highest = std::max(highest, kilopascals(response));
    }
    return fmt::format(
        "{} to {} kPa ({} samples)", short_number(lowest, 4), short_number(highest, 4), responses.size()
    );
}

/// " (2 of them liquefied)", " (and collapsed at 1.1 % axial strain)"; empty where nothing of the kind happened.
std::string describe_failures(const std::vector<json>& responses) {
    const auto liquefied =
        std::ranges::count_if(responses, [](const json& r) { return r.value("liquefied", json()) == true; });
    const auto lost = std::ranges::count_if(responses, [](const json& r) {
        return r.value("lost_at", json()).is_number(); // runs of earlier programs lack it
    });
    if (responses.size() == 1 && lost > 0) {
        return fmt::format(
            " (and collapsed at {} % axial strain)",
            short_number(100 * responses.front().at("lost_at").get<double>(), 2)
        );
    }
    if (responses.size() == 1) {
        return liquefied > 0 ? " (and liquefied)" : "";
    }
    return liquefied > 0 ? fmt::format(" ({} of them liquefied)", liquefied)
           : lost > 0    ? fmt::format(" ({} of them collapsed)", lost)
                         : "";
}

/// The responses of a test, of all seeds.
struct ReportedTest {
    const casefile::Study* study;
    std::string name;    ///< with the values of a sweep
    bool holds_deviator; ///< and fails by its pore pressure
    std::vector<json> responses;
};

/// Tests that were compared have their sentence already; those that stop at a stress lead to a state, not a strength.
bool is_reported_alone(const record::FinishedStage& stage, const std::vector<study::StrengthChange>& strength) {
    const auto* spec = std::get_if<triaxial::TriaxialSpec>(&stage.stage->spec);
    const bool stops = spec != nullptr && spec->stops_at_stress();
    return !stops && std::ranges::none_of(strength, [&](const study::StrengthChange& change) {
        const std::string& name = stage.stage->name;
        return change.study == stage.study && (change.before->name == name || change.after->name == name);
    });
}

/// "“shear”", "“shear” with order random".
std::string name_of_test(const record::FinishedStage& stage) {
    return stage.study->sweep.empty()
               ? fmt::format("“{}”", stage.stage->name)
               : fmt::format("“{}” with {}", stage.stage->name, study::values_name(*stage.study, *stage.variant));
}

/// Those of a sweep get sentences as long as they are few; over fines contents a curve shows them.
bool too_many_to_report(const std::vector<ReportedTest>& tests, const casefile::Study& study) {
    constexpr auto most_reported = 4;
    return !study.sweep.empty() &&
           (std::ranges::count(tests, &study, &ReportedTest::study) > most_reported ||
            std::ranges::any_of(study.sweep, [](const auto& swept) { return swept.key == "fines_content"; }));
}

std::vector<ReportedTest> gather_reported_tests(
    const std::vector<record::FinishedStage>& stages, const std::vector<study::StrengthChange>& strength
) {
    std::vector<ReportedTest> tests;
    for (const record::FinishedStage& stage : stages) {
        const bool is_compression = study::test_of_strength(*stage.stage) != nullptr;
        if (!is_compression || !stage.numbers.contains("response") || !is_reported_alone(stage, strength)) {
            continue;
        }
        const std::string name = name_of_test(stage);
        auto test = std::find_if(tests.begin(), tests.end(), [&](const ReportedTest& other) {
            return other.study == stage.study && other.name == name;
        });
        if (test == tests.end()) {
            const auto* spec = std::get_if<triaxial::TriaxialSpec>(&stage.stage->spec);
            const bool holds = spec != nullptr && spec->path == triaxial::Path::ConstantDeviator;
            test = tests.insert(test, {stage.study, name, holds, {}});
        }
        test->responses.push_back(stage.numbers.at("response"));
    }
    std::vector<ReportedTest> reported;
    std::ranges::copy_if(tests, std::back_inserter(reported), [&](const ReportedTest& test) {
        return !too_many_to_report(tests, *test.study);
    });
    return reported;
}

} // namespace

std::vector<std::string>
describe_tests(const std::vector<record::FinishedStage>& stages, const std::vector<study::StrengthChange>& changes) {
    std::string strength;
    std::vector<std::string> sentences;
    for (const ReportedTest& test : gather_reported_tests(stages, changes)) {
        if (!test.holds_deviator) {
            strength += fmt::format(
                "{}{} in {}{}", strength.empty() ? "Highest deviator stress in triaxial compression: " : ", ",
                describe_peaks(test.responses, "peak_deviator", "peak_strain"), test.name,
                describe_failures(test.responses)
            );
            continue;
        }
        sentences.push_back(fmt::format(
            "{}: with the deviator stress held, an excess pore pressure of {} is the most that the sample bears{}.",
            test.name, describe_peaks(test.responses, "excess_pore_pressure", "peak_strain"),
            describe_failures(test.responses)
        ));
    }
    if (!strength.empty()) {
        sentences.insert(sentences.begin(), strength + ".");
    }
    return sentences;
}

} // namespace suffuse::answer
