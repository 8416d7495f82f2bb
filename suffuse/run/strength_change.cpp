#include "suffuse/run/strength_change.hpp"

#include "suffuse/report/words.hpp"
#include "suffuse/run/result_json.hpp"
#include "suffuse/run/study_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::run {
namespace {

using nlohmann::json;
using triaxial::Path;
using triaxial::TriaxialSpec;

constexpr double same_confinement = 0.02; // relative; stages that settle are within 0.5 %
constexpr double at_the_end = 0.98;       // of the strain of a test
// Of one sample: seeds of examples/silty-sand-2016 differ by 4 to 18 % (one standard deviation), most of them by 8.
constexpr double clear_change = 0.1;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The test of a sample before fines went, and after.
struct Pair {
    const FinishedStage *before, *after;
    const FinishedStage *intact, *eroded; ///< states: before anything left, and where the second test starts
    double removed_mass;                  ///< [-]
    bool has_failed;                      ///< the skeleton, while fines went
};

const TriaxialSpec* test_of_strength(const casefile::Stage& stage) {
    const auto* spec = std::get_if<TriaxialSpec>(&stage.spec);
    const bool is_one = spec != nullptr && !spec->deviator_stress && !spec->stress_ratio &&
                        spec->path != Path::Proportional && spec->path != Path::ConstantDeviator;
    return is_one ? spec : nullptr;
}

bool is_same_test(const TriaxialSpec& a, const TriaxialSpec& b) {
    return a.path == b.path && a.axis == b.axis && a.strain == b.strain && a.inertial_number == b.inertial_number;
}

/// Whether a test goes on from the end of this stage as it would from its start: a part of the same path, or a look.
bool leaves_path(const casefile::StageSpec& spec, const TriaxialSpec& test) {
    if (const auto* part = std::get_if<TriaxialSpec>(&spec)) {
        return test.path != Path::Drained || part->path != Path::Drained || part->axis != test.axis;
    }
    return !std::holds_alternative<erosion::ErodeSpec>(spec) && !std::holds_alternative<erosion::RemoveSpec>(spec) &&
           !std::holds_alternative<erosion::DetachStageSpec>(spec) && !std::holds_alternative<flow::FlowSpec>(spec) &&
           !std::holds_alternative<triaxial::StressProbeSpec>(spec) && !std::holds_alternative<dem::SettleSpec>(spec);
}

/// Share of the mass that a stage took [-]; nothing where it takes none.
std::optional<double> taken_by(const FinishedStage& stage) {
    if (std::holds_alternative<erosion::ErodeSpec>(stage.stage->spec)) {
        return stage.numbers.value("eroded_share_of_solids", none);
    }
    return std::holds_alternative<erosion::RemoveSpec>(stage.stage->spec)
               ? std::optional(stage.numbers.value("removed_mass_share", none))
               : std::nullopt;
}

bool skeleton_failed(const FinishedStage& stage) {
    const auto& erosion = stage.findings.erosion;
    return stage.numbers.value("failed", false) ||
           (erosion && !erosion->passes.empty() && erosion->passes.back().failed);
}

class Finder {
public:
    explicit Finder(const std::vector<FinishedStage>& stages) : stages_(stages) {}

    /// From the second test back to the nearest state before all erosion from which the same test was made.
    [[nodiscard]] std::optional<Pair> pair_of(const FinishedStage& after) const {
        const TriaxialSpec* test = test_of_strength(*after.stage);
        if (test == nullptr || !after.numbers.contains("response") || after.stage->parent < 0) {
            return std::nullopt;
        }
        Pair pair{nullptr, &after, nullptr, state(after, after.stage->parent), 0, false};
        const FinishedStage* intact = nullptr;
        double left = 1;
        bool has_failed = false, looks = false;
        for (int row = after.stage->parent; row >= 0;) {
            const FinishedStage* stage = state(after, row);
            if (stage == nullptr) {
                break;
            }
            if (const FinishedStage* before = looks ? same_test_from(after, row, *test) : nullptr) {
                pair.before = before, pair.intact = intact;
                pair.removed_mass = 1 - left, pair.has_failed = has_failed;
                looks = false;
            }
            if (leaves_path(stage->stage->spec, *test)) {
                break;
            }
            row = stage->stage->parent;
            if (const std::optional<double> share = taken_by(*stage)) {
                left *= 1 - *share;
                has_failed = has_failed || skeleton_failed(*stage);
                looks = true, intact = row < 0 ? nullptr : state(after, row);
            }
        }
        return pair.before != nullptr && pair.intact != nullptr ? std::optional(pair) : std::nullopt;
    }

private:
    [[nodiscard]] const FinishedStage* state(const FinishedStage& of, int row) const {
        const casefile::Stage* wanted = &of.variant->stages[static_cast<std::size_t>(row)];
        const auto found =
            std::ranges::find_if(stages_, [&](const FinishedStage& stage) { return stage.stage == wanted; });
        return found == stages_.end() ? nullptr : &*found;
    }

    [[nodiscard]] const FinishedStage*
    same_test_from(const FinishedStage& after, int row, const TriaxialSpec& test) const {
        const auto found = std::ranges::find_if(stages_, [&](const FinishedStage& stage) {
            const TriaxialSpec* other = test_of_strength(*stage.stage);
            return stage.variant == after.variant && stage.stage->parent == row && other != nullptr &&
                   is_same_test(*other, test) && stage.numbers.contains("response");
        });
        return found == stages_.end() ? nullptr : &*found;
    }

    const std::vector<FinishedStage>& stages_;
};

/// The stress that a test holds, of the state that it starts from [Pa].
double confinement(const FinishedStage& state, const TriaxialSpec& test) {
    const Mat3 stress = state.numbers.at("stress").get<Mat3>();
    const int a = (test.axis + 1) % 3, b = (test.axis + 2) % 3;
    return test.path == Path::Drained ? 0.5 * (stress(a, a) + stress(b, b))
                                      : state.numbers.at("mean_stress").get<double>();
}

const json& response_of(const FinishedStage& test) {
    return test.numbers.at("response");
}

double number_of(const FinishedStage& test, const char* key) {
    const json& response = response_of(test);
    return response.contains(key) && response.at(key).is_number() ? response.at(key).get<double>() : none;
}

double relative(double before, double after) {
    return (after - before) / before;
}

double difference(double before, double after) {
    return after - before;
}

/// One number of all pairs; not a number where a pair is not compared.
BeforeAfter
gather(const std::vector<Pair>& pairs, const std::vector<bool>& is_compared, const auto& number, const auto& change) {
    std::vector<double> before, after, changes;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const auto [b, a] = is_compared[k] ? number(pairs[k]) : std::pair{none, none};
        before.push_back(b), after.push_back(a), changes.push_back(change(b, a));
    }
    return {
        report::scatter_of(std::move(before)), report::scatter_of(std::move(after)),
        report::scatter_of(std::move(changes))};
}

BeforeAfter gather_response(
    const std::vector<Pair>& pairs, const std::vector<bool>& is_compared, const char* key, const auto& change
) {
    const auto number = [&](const Pair& pair) {
        return std::pair{number_of(*pair.before, key), number_of(*pair.after, key)};
    };
    return gather(pairs, is_compared, number, change);
}

/// Why the two tests of a sample are not compared; empty: they are.
std::string why_not(const Pair& pair, const TriaxialSpec& test) {
    for (const FinishedStage* each : {pair.before, pair.after}) {
        if (const double lost = number_of(*each, "lost_at"); std::isfinite(lost)) {
            return fmt::format(
                "{} collapsed at {} % axial strain", each->stage->name, report::short_number(100 * lost, 2)
            );
        }
    }
    const double before = confinement(*pair.intact, test), after = confinement(*pair.eroded, test);
    if (!(std::abs(relative(before, after)) <= same_confinement)) {
        return fmt::format(
            "{} starts from {} kPa, not from {} kPa", pair.after->stage->name, report::short_number(after / 1e3),
            report::short_number(before / 1e3)
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

void remark_on_tests(const std::vector<Pair>& pairs, std::vector<std::string>& remarks) {
    const auto count = [&](const auto& holds) { return static_cast<std::size_t>(std::ranges::count_if(pairs, holds)); };
    const std::size_t all = pairs.size();
    remark(
        count([](const Pair& p) { return p.has_failed; }), all,
        "the skeleton had failed when fines went, and found a new state", remarks
    );
    for (const FinishedStage* Pair::*which : {&Pair::before, &Pair::after}) {
        const FinishedStage& first = *(pairs.front().*which);
        const std::string& name = first.stage->name;
        const TriaxialSpec& test = *test_of_strength(*first.stage);
        remark(
            count([&](const Pair& p) { return response_of(*(p.*which)).value("liquefied", json()) == true; }), all,
            name + " liquefied", remarks
        );
        remark(
            count([&](const Pair& p) { return number_of(*(p.*which), "peak_strain") > at_the_end * test.strain; }), all,
            name + " is highest at its end, and may rise further", remarks
        );
        remark(
            count([&](const Pair& p) {
                return !(p.*which)->numbers.value("flaws", json::array()).empty() &&
                       !std::isfinite(number_of(*(p.*which), "lost_at"));
            }),
            all, name + " has a flaw (warnings)", remarks
        );
    }
}

StrengthChange summed_up(const std::vector<Pair>& pairs) {
    const Pair& first = pairs.front();
    const TriaxialSpec& test = *test_of_strength(*first.after->stage);
    StrengthChange change;
    change.study = first.after->study, change.variant = first.after->variant;
    change.before = first.before->stage, change.after = first.after->stage;
    std::vector<bool> is_compared, is_there(pairs.size(), true);
    std::vector<double> removed;
    for (const Pair& pair : pairs) {
        const std::string reason = why_not(pair, test);
        is_compared.push_back(reason.empty());
        change.seeds.push_back(pair.after->variant->seed);
        removed.push_back(pair.removed_mass);
        if (!reason.empty()) {
            const std::string of = pairs.size() > 1 ? fmt::format("seed {}: ", pair.after->variant->seed) : "";
            change.remarks.push_back(fmt::format("{}not compared, for {}", of, reason));
        }
    }
    change.removed_mass = report::scatter_of(std::move(removed));
    change.peak_deviator = gather_response(pairs, is_compared, "peak_deviator", relative);
    change.final_deviator = gather_response(pairs, is_compared, "final_deviator", relative);
    change.friction_angle = gather_response(pairs, is_compared, "friction_angle", difference);
    const auto void_ratios = [](const Pair& pair) {
        return std::pair{
            pair.intact->numbers.at("void_ratio").get<double>(), pair.eroded->numbers.at("void_ratio").get<double>()};
    };
    change.void_ratio = gather(pairs, is_there, void_ratios, difference);
    remark_on_tests(pairs, change.remarks);
    return change;
}

json scatter_json(const report::Scatter& value) {
    if (value.seeds == 0) {
        return nullptr;
    }
    return {{"mean", value.mean}, {"standard_deviation", value.standard_deviation}, {"of_seed", value.of_seed}};
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

std::optional<bool> StrengthChange::is_weaker() const {
    const report::Scatter& by = peak_deviator.change;
    const double clear = by.seeds > 1 ? by.standard_deviation : clear_change;
    return by.seeds > 0 && std::abs(by.mean) > clear ? std::optional(by.mean < 0) : std::nullopt;
}

std::vector<StrengthChange> compare_strength(const std::vector<FinishedStage>& stages) {
    const Finder finder(stages);
    std::vector<std::vector<Pair>> groups; // a group: the seeds of one test at one set of values
    for (const FinishedStage& stage : stages) {
        const std::optional<Pair> pair = finder.pair_of(stage);
        if (!pair) {
            continue;
        }
        const auto group = std::ranges::find_if(groups, [&](const std::vector<Pair>& other) {
            const FinishedStage& first = *other.front().after;
            return first.study == stage.study && first.stage->name == stage.stage->name &&
                   sweep_values(*first.study, *first.variant) == sweep_values(*stage.study, *stage.variant);
        });
        (group == groups.end() ? groups.emplace_back() : *group).push_back(*pair);
    }
    std::vector<StrengthChange> changes;
    changes.reserve(groups.size());
    for (const std::vector<Pair>& group : groups) {
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
             {"friction_angle", before_after_json(change.friction_angle)},
             {"void_ratio", before_after_json(change.void_ratio)},
             {"weaker", or_null(change.is_weaker())},
             {"remarks", change.remarks}}
        );
    }
    return list;
}

} // namespace suffuse::run
