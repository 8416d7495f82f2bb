#include "suffuse/study/strength_change.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/record/or_null.hpp"
#include "suffuse/record/result_json.hpp"
#include "suffuse/study/end_of_test.hpp"
#include "suffuse/study/strength_pairs.hpp"
#include "suffuse/study/trace_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::study {
namespace {

using nlohmann::json;
using triaxial::Path;
using triaxial::TriaxialSpec;

constexpr double same_confinement = 0.02; // relative; stages that settle are within 0.5 %
constexpr double at_the_end = 0.98;       // of the strain of a test
// Of one sample: seeds of examples/silty-sand-2016 differ by 2 to 21 % (one standard deviation), most of them by 8.
constexpr double clear_change = 0.1;
// The pore pressures that the seeds of examples/silty-sand-fc20/stability.toml bear differ by 46 to 53 %.
constexpr double clear_change_of_pore_pressure = 0.5;

/// The stress that a test holds, of the state that it starts from [Pa].
double confinement(const record::FinishedStage& state, const TriaxialSpec& test) {
    const Mat3 stress = state.numbers.at("stress").get<Mat3>();
    const int a = (test.axis + 1) % 3, b = (test.axis + 2) % 3;
    return test.path == Path::Drained ? 0.5 * (stress(a, a) + stress(b, b))
                                      : state.numbers.at("mean_stress").get<double>();
}

/// The deviator stress that a state carries [Pa].
double deviator(const record::FinishedStage& state, const TriaxialSpec& test) {
    const Mat3 stress = state.numbers.at("stress").get<Mat3>();
    const int a = (test.axis + 1) % 3, b = (test.axis + 2) % 3;
    return stress(test.axis, test.axis) - 0.5 * (stress(a, a) + stress(b, b));
}

const json& response_of(const record::FinishedStage& test) {
    return test.numbers.at("response");
}

double number_of(const record::FinishedStage& test, const char* key) {
    const json& response = response_of(test);
    return response.contains(key) && response.at(key).is_number() ? response.at(key).get<double>() : std::nan("");
}

double relative(double before, double after) {
    return before > 0 ? (after - before) / before : std::nan("");
}

double difference(double before, double after) {
    return after - before;
}

/// One number of all pairs; not a number where a pair is not compared.
BeforeAfter gather(
    const std::vector<TestPair>& pairs, const std::vector<bool>& is_compared, const auto& number, const auto& change
) {
    std::vector<double> before, after, changes;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const auto [b, a] = is_compared[k] ? number(pairs[k]) : std::pair{std::nan(""), std::nan("")};
        before.push_back(b), after.push_back(a), changes.push_back(change(b, a));
    }
    return {scatter_of(std::move(before)), scatter_of(std::move(after)), scatter_of(std::move(changes))};
}

BeforeAfter gather_response(
    const std::vector<TestPair>& pairs, const std::vector<bool>& is_compared, const char* key, const auto& change
) {
    const auto number = [&](const TestPair& pair) {
        return std::pair{number_of(*pair.before, key), number_of(*pair.after, key)};
    };
    return gather(pairs, is_compared, number, change);
}

/// Why the two tests of a sample are not compared; empty: they are.
std::string why_not(const TestPair& pair, const TriaxialSpec& test) {
    for (const record::FinishedStage* each : {pair.before, pair.after}) {
        if (const double lost = number_of(*each, "lost_at"); std::isfinite(lost)) {
            return fmt::format("{} collapsed at {} % axial strain", each->stage->name, short_number(100 * lost, 2));
        }
    }
    const double before = confinement(*pair.tested, test), after = confinement(*pair.eroded, test);
    if (!(std::abs(relative(before, after)) <= same_confinement)) {
        return fmt::format(
            "{} starts from {} kPa, not from {} kPa", pair.after->stage->name, short_number(after / 1e3),
            short_number(before / 1e3)
        );
    }
    const double held = deviator(*pair.tested, test), held_after = deviator(*pair.eroded, test);
    if (test.path == Path::ConstantDeviator && !(std::abs(held_after - held) <= same_confinement * before)) {
        return fmt::format(
            "{} holds a deviator stress of {} kPa, not of {} kPa", pair.after->stage->name,
            short_number(held_after / 1e3), short_number(held / 1e3)
        );
    }
    return {};
}

/// "2 of 3 samples: WHAT"; without the number where there is but one.
void remark(std::size_t count, std::size_t of, const std::string& what, std::vector<std::string>& remarks) {
    if (count > 0) {
        remarks.push_back(of == 1 ? what : fmt::format("{} of {} samples: {}", count, of, what));
    }
}

/// On one of the two tests, over all samples.
void remark_on_test(const std::vector<const record::FinishedStage*>& samples, std::vector<std::string>& remarks) {
    const casefile::Stage& stage = *samples.front()->stage;
    const double last_strain = at_the_end * test_of_strength(stage)->strain;
    const auto add_remark = [&](const char* what, const auto& holds) {
        const auto count =
            std::ranges::count_if(samples, [&](const record::FinishedStage* test) { return holds(*test); });
        remark(static_cast<std::size_t>(count), samples.size(), fmt::format("{} {}", stage.name, what), remarks);
    };
    add_remark("liquefied", [](const record::FinishedStage& test) {
        return response_of(test).value("liquefied", json()) == true;
    });
    add_remark("is highest at its end, and may rise further", [&](const record::FinishedStage& test) {
        return number_of(test, "peak_strain") > last_strain;
    });
    add_remark("has a flaw (warnings)", [](const record::FinishedStage& test) {
        return !test.numbers.value("flaws", json::array()).empty() && !std::isfinite(number_of(test, "lost_at"));
    });
}

void remark_on_samples(const std::vector<TestPair>& pairs, std::vector<std::string>& remarks) {
    std::vector<const record::FinishedStage*> before, after;
    std::size_t failed = 0;
    for (const TestPair& pair : pairs) {
        before.push_back(pair.before), after.push_back(pair.after);
        failed += pair.has_failed ? 1 : 0;
    }
    remark(failed, pairs.size(), "the skeleton had failed during removal and found a new state", remarks);
    remark_on_test(before, remarks);
    remark_on_test(after, remarks);
}

/// What the curves show beyond their highest point.
void gather_curves(
    const std::vector<TestPair>& pairs, const std::vector<bool>& is_compared, const TriaxialSpec& test,
    StrengthChange& change
) {
    constexpr double usual_strain = 0.1; // at which tests of soil are often read
    change.reading_strain = std::min(usual_strain, test.strain);
    const auto at_strain = [&](const record::FinishedStage& stage) {
        return test.strain <= usual_strain ? number_of(stage, "final_deviator")
                                           : deviator_at(stage.findings.curve, usual_strain);
    };
    const auto of_both = [](const auto& number) {
        return [&number](const TestPair& pair) { return std::pair{number(*pair.before), number(*pair.after)}; };
    };
    change.deviator_at_strain = gather(pairs, is_compared, of_both(at_strain), relative);
    if (test.path == Path::Drained || test.path == Path::ConstantMean) {
        change.volume_change = gather_response(pairs, is_compared, "final_volumetric_strain", difference);
    }
    std::vector<bool> are_critical;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const auto before = end_of_test(pairs[k].before->findings.curve);
        const auto after = end_of_test(pairs[k].after->findings.curve);
        are_critical.push_back(is_compared[k] && before && after && before->is_critical() && after->is_critical());
    }
    const auto residual = [](const record::FinishedStage& stage) {
        return end_of_test(stage.findings.curve)->deviator;
    };
    const auto void_ratio = [](const record::FinishedStage& stage) {
        return end_of_test(stage.findings.curve)->void_ratio;
    };
    change.residual_deviator = gather(pairs, are_critical, of_both(residual), relative);
    change.critical_void_ratio = gather(pairs, are_critical, of_both(void_ratio), difference);
    const auto compared = static_cast<std::size_t>(std::ranges::count(is_compared, true));
    const auto critical = static_cast<std::size_t>(std::ranges::count(are_critical, true));
    remark(
        compared - critical, compared,
        fmt::format(
            "too short to reach the critical state: at {} % axial strain volume or stress still change",
            short_number(100 * test.strain, 3)
        ),
        change.remarks
    );
}

StrengthChange summed_up(const std::vector<TestPair>& pairs) {
    const TestPair& first = pairs.front();
    const TriaxialSpec& test = *test_of_strength(*first.after->stage);
    StrengthChange change;
    change.study = first.after->study, change.variant = first.after->variant;
    change.before = first.before->stage, change.after = first.after->stage;
    std::vector<bool> is_compared, is_there(pairs.size(), true);
    std::vector<double> removed;
    for (const TestPair& pair : pairs) {
        const std::string reason = why_not(pair, test);
        is_compared.push_back(reason.empty());
        change.seeds.push_back(pair.after->variant->seed);
        removed.push_back(pair.removed_mass);
        if (!reason.empty()) {
            const std::string of = pairs.size() > 1 ? fmt::format("seed {}: ", pair.after->variant->seed) : "";
            change.remarks.push_back(fmt::format("{}not compared, for {}", of, reason));
        }
    }
    change.removed_mass = scatter_of(std::move(removed));
    if (change.holds_deviator()) {
        change.pore_pressure = gather_response(pairs, is_compared, "excess_pore_pressure", relative);
    } else {
        change.peak_deviator = gather_response(pairs, is_compared, "peak_deviator", relative);
        change.final_deviator = gather_response(pairs, is_compared, "final_deviator", relative);
        change.friction_angle = gather_response(pairs, is_compared, "friction_angle", difference);
        gather_curves(pairs, is_compared, test, change);
    }
    const auto void_ratios = [](const TestPair& pair) {
        return std::pair{
            pair.intact->numbers.at("void_ratio").get<double>(), pair.eroded->numbers.at("void_ratio").get<double>()};
    };
    change.void_ratio = gather(pairs, is_there, void_ratios, difference);
    remark_on_samples(pairs, change.remarks);
    return change;
}

json before_after_json(const BeforeAfter& value) {
    if (value.before.seeds == 0) {
        return nullptr;
    }
    return {
        {"before", scatter_json(value.before)},
        {"after", scatter_json(value.after)},
        {"change", scatter_json(value.change)}};
}

} // namespace

bool StrengthChange::holds_deviator() const {
    return std::get<TriaxialSpec>(after->spec).path == Path::ConstantDeviator;
}

std::optional<bool> StrengthChange::is_weaker() const {
    const Scatter& by = borne().change;
    const double clear = by.seeds > 1       ? by.standard_deviation
                         : holds_deviator() ? clear_change_of_pore_pressure
                                            : clear_change;
    return by.seeds > 0 && std::abs(by.mean) > clear ? std::optional(by.mean < 0) : std::nullopt;
}

std::vector<StrengthChange> compare_strength(const std::vector<record::FinishedStage>& stages) {
    std::vector<std::vector<TestPair>> groups; // a group: the seeds of one test at one set of values
    for (const TestPair& pair : find_test_pairs(stages)) {
        const record::FinishedStage& stage = *pair.after;
        const auto group = std::ranges::find_if(groups, [&](const std::vector<TestPair>& other) {
            const record::FinishedStage& first = *other.front().after;
            return first.study == stage.study && first.stage->name == stage.stage->name &&
                   sweep_values(*first.study, *first.variant) == sweep_values(*stage.study, *stage.variant);
        });
        (group == groups.end() ? groups.emplace_back() : *group).push_back(pair);
    }
    std::vector<StrengthChange> changes;
    changes.reserve(groups.size());
    for (const std::vector<TestPair>& group : groups) {
        changes.push_back(summed_up(group));
    }
    return changes;
}

json strength_json(const std::vector<StrengthChange>& changes) {
    json list = json::array();
    for (const StrengthChange& change : changes) {
        list.push_back(
            {{"study", change.study->name},
             {"values", values_json(*change.study, *change.variant)},
             {"before", change.before->name},
             {"after", change.after->name},
             {"seeds", change.seeds},
             {"removed_mass_share", scatter_json(change.removed_mass)},
             {"peak_deviator", before_after_json(change.peak_deviator)},
             {"final_deviator", before_after_json(change.final_deviator)},
             {"told_strain", change.reading_strain > 0 ? json(change.reading_strain) : json()},
             {"deviator_at_strain", before_after_json(change.deviator_at_strain)},
             {"residual_deviator", before_after_json(change.residual_deviator)},
             {"critical_void_ratio", before_after_json(change.critical_void_ratio)},
             {"volume_change", before_after_json(change.volume_change)},
             {"friction_angle", before_after_json(change.friction_angle)},
             {"excess_pore_pressure", before_after_json(change.pore_pressure)},
             {"void_ratio", before_after_json(change.void_ratio)},
             {"weaker", or_null(change.is_weaker())},
             {"remarks", change.remarks}}
        );
    }
    return list;
}

} // namespace suffuse::study
