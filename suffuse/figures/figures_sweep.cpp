#include "suffuse/figures/figures_sweep.hpp"

#include "suffuse/base/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace suffuse::figures {
namespace {

using nlohmann::json;
using study::OutcomePoint;
using study::Result;
using study::Scatter;
using study::StudyOutcome;

constexpr std::size_t most_swept_lines = 6; ///< as many as there are colors

/// The values of the keys but the first: what distinguishes one line from another.
std::string line_of(const StudyOutcome& outcome, const OutcomePoint& point) {
    std::string name;
    for (std::size_t k = 1; k < outcome.keys.size(); ++k) {
        name += fmt::format(
            "{}{} {}", name.empty() ? "" : ", ", study::key_in_words(outcome.keys[k], outcome.keys), point.at.written[k]
        );
    }
    return name;
}

/// A value as written in the case: "30 deg" is 30 of deg. Not a number for words.
struct Written {
    double number = 0;
    std::string unit;

    explicit Written(const std::string& text) {
        char* end = nullptr;
        number = std::strtod(text.c_str(), &end);
        if (end == text.c_str()) {
            number = std::nan("");
        } else {
            const std::string rest = end;
            const std::size_t at = rest.find_first_not_of(' ');
            unit = at == std::string::npos ? "" : rest.substr(at);
        }
    }
};

/// The unit in which all values of the first key are written; nothing where they are words, or of several units.
std::optional<std::string> common_unit(const StudyOutcome& outcome) {
    const std::string unit = Written(outcome.points.front().at.written.front()).unit;
    const bool is_common = std::ranges::all_of(outcome.points, [&](const OutcomePoint& point) {
        const Written value(point.at.written.front());
        return !std::isnan(value.number) && value.unit == unit;
    });
    return is_common ? std::optional(unit) : std::nullopt;
}

/// "friction [deg]": the first key as the title of an axis.
std::string title_of_key(const StudyOutcome& outcome) {
    const std::string unit = common_unit(outcome).value_or("");
    return study::key_in_words(outcome.keys.front(), outcome.keys) + (unit.empty() ? "" : fmt::format(" [{}]", unit));
}

/// Columns of a sweep's results, a row for each sample.
struct SweepColumns {
    std::vector<std::string> panel, line, written;
    std::vector<double> value, sample, mean, low, high, samples;

    void add(const StudyOutcome& outcome, Result which) {
        const study::ResultScale scale = study::scale_of(which);
        const bool is_number = common_unit(outcome).has_value();
        for (const OutcomePoint& point : outcome.points) {
            const Scatter* const found = point.find(which);
            if (found == nullptr) {
                continue;
            }
            for (const double of_seed : found->of_seed) {
                panel.push_back(title_of(scale));
                line.push_back(line_of(outcome, point));
                written.push_back(point.at.written.front());
                value.push_back(is_number ? Written(point.at.written.front()).number : std::nan(""));
                sample.push_back(scale.factor * of_seed);
                mean.push_back(scale.factor * found->mean);
                low.push_back(scale.factor * (found->mean - found->standard_deviation));
                high.push_back(scale.factor * (found->mean + found->standard_deviation));
                samples.push_back(found->seeds);
            }
        }
    }

    static std::string title_of(const study::ResultScale& scale) {
        return *scale.unit == '\0' ? scale.label : fmt::format("{} [{}]", scale.label, scale.unit);
    }

    [[nodiscard]] bool has_words() const {
        return std::ranges::any_of(value, [](double each) { return std::isnan(each); });
    }

    Table table(const std::string& key) && {
        Table table;
        if (std::ranges::any_of(panel, [&](const std::string& each) { return each != panel.front(); })) {
            table.add("result", std::move(panel));
        }
        if (std::ranges::any_of(line, [](const std::string& each) { return !each.empty(); })) {
            table.add("line", std::move(line));
        }
        if (has_words()) {
            table.add("value", std::move(written));
        } else {
            table.add("value", "", std::move(value));
        }
        table.add("key", std::vector<std::string>(sample.size(), key));
        table.add("sample", "", std::move(sample));
        table.add("mean", "", std::move(mean));
        table.add("low", "", std::move(low));
        table.add("high", "", std::move(high));
        table.add("samples", "", std::move(samples));
        return table;
    }
};

/// Band, line and dots over the value; over words bars of one deviation instead of the band and the line.
json layers(bool is_words, bool has_lines, const std::string& value_title, const std::string& y_title) {
    json x = {{"field", "value"}, {"type", is_words ? "nominal" : "quantitative"}, {"title", value_title}};
    if (is_words) {
        x["axis"] = {{"labelAngle", 0}};
    } else {
        x["scale"] = {{"zero", false}, {"nice", true}};
    }
    const json tooltip = {
        {{"field", "value"}, {"title", value_title}},
        {{"field", "sample"}, {"title", "this sample"}, {"format", ".4g"}},
        {{"field", "mean"}, {"title", "mean"}, {"format", ".4g"}},
        {{"field", "samples"}, {"title", "samples"}}};
    const json y_scale = {{"zero", false}};
    const auto y = [&](const char* field) {
        return json{{"field", field}, {"type", "quantitative"}, {"title", y_title}, {"scale", y_scale}};
    };
    json list = json::array();
    if (is_words) {
        list.push_back(
            {{"mark", {{"type", "rule"}, {"strokeWidth", 2}}},
             {"encoding", {{"x", x}, {"y", y("low")}, {"y2", {{"field", "high"}}}}}}
        );
        list.push_back(
            {{"mark", {{"type", "tick"}, {"thickness", 3}, {"size", 22}}}, {"encoding", {{"x", x}, {"y", y("mean")}}}}
        );
    } else {
        list.push_back(
            {{"mark", {{"type", "area"}, {"opacity", 0.18}, {"line", false}}},
             {"encoding", {{"x", x}, {"y", y("low")}, {"y2", {{"field", "high"}}}}}}
        );
        list.push_back({{"mark", {{"type", "line"}, {"strokeWidth", 2.4}}}, {"encoding", {{"x", x}, {"y", y("mean")}}}}
        );
    }
    list.push_back(
        {{"mark", {{"type", "point"}, {"filled", true}, {"size", 42}, {"opacity", 0.75}}},
         {"encoding", {{"x", x}, {"y", y("sample")}, {"tooltip", tooltip}}}}
    );
    for (json& layer : list) {
        if (has_lines) {
            layer["encoding"]["color"] = {
                {"field", "line"}, {"type", "nominal"}, {"title", nullptr}, {"scale", {{"range", color::sequence()}}}};
        } else {
            layer["mark"]["color"] = color::staying;
        }
    }
    return list;
}

std::string how_to_read(const StudyOutcome& outcome, const study::SweepEffect& effect, bool is_words) {
    const std::string points =
        effect.points == outcome.all_points()
            ? ""
            : fmt::format(" {} of {} points have a result.", effect.points, outcome.all_points());
    if (!effect.has_scatter()) {
        return "One sample per point: no band, because the scatter between samples was not measured." + points;
    }
    return fmt::format(
        "{}: mean of {} samples. {}: one standard deviation to both sides. Dots: single samples.{}",
        is_words ? "Ticks" : "Line", study::range_in_words(effect.fewest_samples, effect.most_samples),
        is_words ? "Bars" : "Band", points
    );
}

/// What dots do not show of first movements: the stage that they are of, and which are upper bounds.
std::string on_first_movements(const StudyOutcome& outcome, const std::vector<Result>& drawn) {
    const auto is_one = [](Result which) { return which == Result::FirstMovement || which == Result::Safety; };
    const std::string stage = outcome.first_probe.empty() || std::ranges::none_of(drawn, is_one)
                                  ? ""
                                  : fmt::format(" First movements are those of the stage “{}”.", outcome.first_probe);
    const auto points = std::ranges::count_if(outcome.points, [&](const OutcomePoint& point) {
        return std::ranges::any_of(drawn, [&](Result which) { return point.is_at_most(which); });
    });
    return points == 0 ? stage
                       : fmt::format(
                             "{} At {} of {} points motion had not ended when the gradient rose: the value is an upper "
                             "bound.",
                             stage, points, outcome.points.size()
                         );
}

/// "Mass carried out: no measurable difference over the gradient": what the eye is to see.
std::string claim(const StudyOutcome& outcome, Result which) {
    const std::string key = study::keys_in_words(outcome);
    const std::string label = study::scale_of(which).label;
    switch (study::effect_of_sweep(outcome, which).difference) {
    case study::Difference::WithinScatter:
        return fmt::format("{}: no measurable difference over the {}", label, key);
    case study::Difference::Small:
        return fmt::format("{}: nearly the same over the {}", label, key);
    case study::Difference::Clear:
        break;
    }
    return fmt::format("{} over the {}", label, key);
}

bool is_many_lined(const StudyOutcome& outcome) {
    return outcome.keys.size() > 1;
}

/// Whether a result is more than noise at one value at least.
bool is_drawn(const StudyOutcome& outcome, Result which) {
    return std::ranges::any_of(outcome.points, [&](const OutcomePoint& point) {
        const Scatter* const value = point.find(which);
        return value != nullptr && std::abs(value->mean) >= study::scale_of(which).least;
    });
}

std::size_t count_lines(const StudyOutcome& outcome) {
    std::vector<std::string> names;
    for (const OutcomePoint& point : outcome.points) {
        if (const std::string name = line_of(outcome, point); std::ranges::count(names, name) == 0) {
            names.push_back(name);
        }
    }
    return names.size();
}

} // namespace

std::optional<Figure> sweep_result(const StudyOutcome& outcome) {
    const std::optional<Result> main = study::main_result(outcome);
    if (!main || outcome.points.size() < 2 || count_lines(outcome) > most_swept_lines) {
        return std::nullopt;
    }
    SweepColumns columns;
    columns.add(outcome, *main);
    const bool is_words = columns.has_words();
    const std::string key = title_of_key(outcome);
    Figure figure;
    figure.id = "own-sweep";
    figure.section = "Samples";
    figure.title = claim(outcome, *main);
    figure.caption =
        how_to_read(outcome, study::effect_of_sweep(outcome, *main), is_words) + on_first_movements(outcome, {*main});
    figure.table = std::move(columns).table(outcome.keys.front());
    figure.chart = {
        {"width", 560},
        {"height", 320},
        {"layer", layers(is_words, is_many_lined(outcome), key, SweepColumns::title_of(study::scale_of(*main)))}};
    return figure;
}

std::optional<Figure> sweep_multiples(const StudyOutcome& outcome) {
    const std::optional<Result> main = study::main_result(outcome);
    if (!main || outcome.points.size() < 2 || count_lines(outcome) > most_swept_lines) {
        return std::nullopt;
    }
    SweepColumns columns;
    json panels = json::array();
    std::vector<Result> drawn;
    study::SweepEffect shown{.fewest_samples = std::numeric_limits<int>::max()}; // what all panels stand for
    shown.points = outcome.all_points();
    for (int k = 0; k < study::results; ++k) {
        const auto which = static_cast<Result>(k);
        if (which != *main && outcome.has(which) && is_drawn(outcome, which)) {
            const study::SweepEffect effect = study::effect_of_sweep(outcome, which);
            shown.points = std::min(shown.points, effect.points);
            shown.fewest_samples = std::min(shown.fewest_samples, effect.fewest_samples);
            shown.most_samples = std::max(shown.most_samples, effect.most_samples);
            columns.add(outcome, which);
            drawn.push_back(which);
            panels.push_back(SweepColumns::title_of(study::scale_of(which)));
        }
    }
    if (panels.size() < 2) { // one alone is no multiple: it is a card and a column of the table
        return std::nullopt;
    }
    const bool is_words = columns.has_words();
    const std::string key = title_of_key(outcome);
    Figure figure;
    figure.id = "own-sweep-multiples";
    figure.section = "Samples";
    figure.title = fmt::format("Other results over the {}", study::keys_in_words(outcome));
    figure.caption = how_to_read(outcome, shown, is_words) + " Each panel has an axis of its own for its result." +
                     on_first_movements(outcome, drawn);
    figure.table = std::move(columns).table(outcome.keys.front());
    figure.chart = {
        {"facet", {{"field", "result"}, {"type", "nominal"}, {"title", nullptr}, {"sort", panels}}},
        {"columns", 3},
        {"resolve", {{"scale", {{"y", "independent"}}}}},
        {"spec", {{"width", 260}, {"height", 180}, {"layer", layers(is_words, is_many_lined(outcome), key, "")}}}};
    return figure;
}

} // namespace suffuse::figures
