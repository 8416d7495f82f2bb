#include "apps/terminal.hpp"

#include "suffuse/base/amounts.hpp"
#include "suffuse/casefile/stage_traits.hpp"
#include "suffuse/facts/shown.hpp"

#include <fmt/format.h>

#include "apps/wording.hpp"
#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

namespace suffuse::apps {
namespace {

using run::Progress;

constexpr std::chrono::milliseconds redraw_interval{100};
constexpr std::chrono::seconds report_interval{30};
constexpr std::size_t label_width = 9, longest_bar = 28, shortest_bar = 8;
constexpr std::size_t most_samples_shown = 4;
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

struct ShownNumber {
    const char* key;
    const char* label;
    int digits = 3;
    double least = 0; ///< in the unit shown, in size
};

constexpr std::array shown_numbers{
    ShownNumber{"void_ratio", "e"},
    ShownNumber{"mean_stress", "p"},
    ShownNumber{"deviator_stress", "q", 3, 0.01},
    ShownNumber{"axial_strain", "strain", 3, 0.01},
    ShownNumber{"unbalanced_force", "unbalance", 2},
};

std::string bar(double share, std::size_t cells, bool utf8) {
    const auto full = std::min(cells, static_cast<std::size_t>(std::lround(share * static_cast<double>(cells))));
    std::string text;
    for (std::size_t k = 0; k < cells; ++k) {
        text += utf8 ? (k < full ? "\u2588" : "\u2591") : (k < full ? "#" : ".");
    }
    return text;
}

std::string labelled(std::string_view label, std::string_view text) {
    return fmt::format(" {:{}}{}", label, label_width - 1, text);
}

std::string place_of(const Progress& progress) {
    return progress.study.empty() ? progress.stage : progress.study + "/" + progress.stage;
}

/// "relax, step 1,200", or the verb where the part has no name.
std::string doing(const Progress& progress) {
    const std::string& part = progress.part.empty() ? progress.verb : progress.part;
    if (progress.steps == 0) {
        return part;
    }
    return fmt::format("{}, step {}", part, count_text(progress.steps));
}

std::string samples_text(const Progress& latest) {
    if (latest.samples < 2) {
        return "";
    }
    const std::string failed = latest.samples_failed > 0 ? fmt::format(", {} FAILED", latest.samples_failed) : "";
    return fmt::format("samples {}/{}{}", latest.samples_done, latest.samples, failed);
}

/// The only sample that runs: what it does, and its numbers below.
void add_one(const Progress& progress, std::size_t width, std::vector<std::string>& lines) {
    const std::string rate = progress.particle_steps_per_second > 0
                                 ? fmt::format("  {:.2g} grain-steps/s", progress.particle_steps_per_second)
                                 : "";
    lines.push_back(labelled("now", fmt::format("{}: {}", place_of(progress), doing(progress))));
    lines.back() += columns_of(lines.back()) + columns_of(rate) < width ? rate : "";
    if (const std::string state = state_text(progress.state); !state.empty()) {
        lines.push_back(labelled("state", state));
    }
}

/// Several samples: a line for each, and one for those that find no room.
void add_several(const Running& running, std::vector<std::string>& lines) {
    std::size_t shown = 0;
    for (const auto& [number, progress] : running) {
        if (shown == most_samples_shown) {
            lines.push_back(labelled("", fmt::format("and {} more", running.size() - shown)));
            return;
        }
        const std::string label = shown++ == 0 ? "now" : "";
        lines.push_back(
            labelled(label, fmt::format("{}: {}  {}", place_of(progress), doing(progress), state_text(progress.state)))
        );
    }
}

/// What fits of a line: numbers stand apart by two blanks, and one that is cut would be another, 1 for 1.4e-09.
std::string fitted(const std::string& line, std::size_t width) {
    const std::string text = clipped(line, width);
    const bool is_within = text.size() < line.size() && line.compare(text.size(), 2, "  ") != 0;
    const std::size_t gap = text.rfind("  ");
    return is_within && gap != std::string::npos && gap >= label_width ? text.substr(0, gap) : text;
}

/// "1 % of the fines move at i = 0.15, 10 % at ≤ 0.25; heave at 0.82": of a stage whose fines have weight.
std::string mobility_text(const nlohmann::json& state) {
    const auto moves = state.find("critical_gradient");
    if (moves == state.end() || !moves->is_object()) {
        return "";
    }
    const auto at_most = state.find("critical_gradient_at_most");
    const auto gradient = [](const nlohmann::json& value) { return digits_text(value.get<double>(), 2); };
    const auto reached = [&](const char* sign, const char* share) {
        const bool is_bound = at_most != state.end() && at_most->value(share, false);
        return (is_bound ? "≤ " : sign) + gradient(moves->at(share));
    };
    std::string text = moves->at("1 %").is_number() ? "1 % of the fines move at i " + reached("= ", "1 %")
                                                    : "less than 1 % of the fines move";
    if (moves->at("10 %").is_number()) {
        text += ", 10 % at " + reached("", "10 %");
    }
    if (const auto heave = state.find("heave_gradient"); heave != state.end() && heave->is_number()) {
        text += fmt::format("; heave at {}", gradient(*heave));
    }
    return text;
}

/// "14 % of the fines left, 12 % still move": of a stage in which they travel.
std::string migration_text(const nlohmann::json& state) {
    const auto holds = state.find("holds");
    if (holds == state.end() || holds->empty() || state.value("fed_mass_share", 0.0) > 0) {
        return "";
    }
    const auto percent = [&](const char* key) { return digits_text(100 * holds->back().value(key, 0.0), 2); };
    return fmt::format(
        "{} % of the {} left, {} % still move", percent("eroded_mass_share"),
        state.contains("stack") ? "base" : "fines", percent("moving_mass_share")
    );
}

} // namespace

std::string state_text(const nlohmann::json& state) {
    std::string text;
    if (const auto passes = state.find("passes"); passes != state.end() && passes->is_array() && !passes->empty()) {
        double eroded = 0;
        for (const nlohmann::json& pass : *passes) {
            eroded += pass.value("eroded_mass_percent_of_initial", 0.0);
        }
        const casefile::StageTraits* const traits = casefile::find_verb(state.value("verb", ""));
        const bool is_removal = traits != nullptr && !traits->has_water;
        text = fmt::format("{} {:.3g} % of the mass", is_removal ? "removed" : "eroded", eroded);
    }
    for (const std::string& of_fines : {mobility_text(state), migration_text(state)}) {
        text += (text.empty() || of_fines.empty() ? "" : "  ") + of_fines;
    }
    const auto add = [&](const char* label, const std::string& value) {
        text += fmt::format("{}{} {}", text.empty() ? "" : "  ", label, value);
    };
    if (const auto pass = state.find("pass"); pass != state.end() && pass->is_number()) {
        add("pass", digits_text(*pass, 3));
    }
    for (const ShownNumber& number : shown_numbers) {
        const auto found = state.find(number.key);
        const double value = found != state.end() && found->is_number() ? found->get<double>() : missing;
        const double shown = facts::in_unit_shown(number.key, value);
        if (std::isfinite(shown) && std::abs(shown) >= number.least) {
            const std::string_view unit = facts::unit_shown(number.key);
            add(number.label, digits_text(shown, number.digits) + (unit == "-" ? "" : fmt::format(" {}", unit)));
        }
    }
    return text;
}

std::vector<std::string> progress_lines(
    const Progress& latest, const Running& running, const Range& left, const std::string& hint, std::size_t width,
    bool utf8
) {
    const double share = latest.stages > 0 ? static_cast<double>(latest.stages_done) / latest.stages : 0;
    const std::size_t cells = std::clamp(width / 3, shortest_bar, longest_bar);
    std::vector<std::string> lines{labelled(
        "stages",
        fmt::format("{} {}/{}   {}", bar(share, cells, utf8), latest.stages_done, latest.stages, samples_text(latest))
    )};
    if (running.size() == 1) {
        add_one(running.begin()->second, width, lines);
    } else {
        add_several(running, lines);
    }
    const std::size_t room = width > 1 ? width - 1 : 1; // the last column would make some terminals begin a new line
    for (std::string& line : lines) {
        line = fitted(line, room);
    }
    std::string last = labelled("left", fmt::format("{:16} {}", duration_range_text(left), hint));
    if (columns_of(last) > room) { // then what matters of the hint
        last = labelled("left", fmt::format("{:16} {}", duration_range_text(left), hint.substr(0, hint.find(';'))));
    }
    lines.push_back(clipped(last, room));
    return lines;
}

std::string progress_line(const Progress& progress, const Range& left) {
    if (!progress.failure.empty()) {
        return fmt::format("{} FAILED: {}", place_of(progress), progress.failure);
    }
    const std::string at = fmt::format("{}/{} {}", progress.stages_done, progress.stages, place_of(progress));
    const std::string state = state_text(progress.state);
    const bool is_last = progress.stages_done == progress.stages;
    const std::string rest = is_last ? "" : fmt::format("  {} left", duration_range_text(left));
    const std::string how = progress.from_cache ? "from the cache" : "done in " + duration_text(progress.stage_seconds);
    return fmt::format("{:32} {}{}{}{}", at, how, state.empty() ? "" : "  ", state, rest);
}

std::string progress_line(const Progress& latest, const Running& running, const Range& left) {
    std::string text = fmt::format("{}/{} ", latest.stages_done, latest.stages);
    std::size_t shown = 0;
    for (const auto& [number, progress] : running) {
        if (shown == most_samples_shown) {
            text += fmt::format("; and {} more", running.size() - shown);
            break;
        }
        text += fmt::format("{}{}: {}", shown++ == 0 ? "" : "; ", place_of(progress), doing(progress));
    }
    if (running.size() == 1) {
        text += "  " + state_text(running.begin()->second.state);
    }
    const std::string samples = samples_text(latest);
    return fmt::format("{}  {}{}{} left", text, samples, samples.empty() ? "" : "  ", duration_range_text(left));
}

void ProgressView::show(const Progress& progress) {
    if (screen_.quiet) {
        return;
    }
    left_.see(progress);
    if (progress.sample_ended) {
        running_.erase(progress.sample);
    } else {
        running_[progress.sample] = progress;
    }
    const bool has_failed = !progress.failure.empty();
    if (has_failed) { // not to be drawn over
        clear();
        screen_.write(progress_line(progress, left_.left()) + "\n");
    }
    const auto now = Clock::now();
    const bool is_first = shown_ == Clock::time_point{};
    if (screen_.redraws) {
        if (!progress.stage_finished && !has_failed && !is_first && now - shown_ < redraw_interval) {
            return;
        }
        redraw(progress);
    } else {
        if (!progress.stage_finished && !is_first && now - shown_ < report_interval) {
            return;
        }
        if (progress.stage_finished || !is_first) {
            report(progress);
        }
    }
    shown_ = now;
}

void ProgressView::redraw(const Progress& latest) {
    const auto lines = progress_lines(latest, running_, left_.left(), hint_, screen_.width(), screen_.utf8);
    std::string text = drawn_ > 0 ? fmt::format("\x1b[{}A", drawn_) : "";
    for (const std::string& line : lines) {
        text += "\r\x1b[K" + line + "\n";
    }
    if (lines.size() < drawn_) {
        text += "\x1b[J";
    }
    screen_.write(text);
    drawn_ = lines.size();
}

void ProgressView::report(const Progress& latest) {
    const Range left = left_.left();
    screen_.write((latest.stage_finished ? progress_line(latest, left) : progress_line(latest, running_, left)) + "\n");
}

void ProgressView::clear() {
    if (drawn_ > 0) {
        screen_.write(fmt::format("\x1b[{}A\r\x1b[J", drawn_));
    }
    drawn_ = 0;
}

} // namespace suffuse::apps
