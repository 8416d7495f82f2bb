#include "apps/verbs.hpp"

#include "suffuse/base/parallel.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/base/units.hpp"

#include <fmt/format.h>

#include "apps/wording.hpp"
#include <charconv>
#include <cmath>
#include <thread>

namespace suffuse::apps {

int perform(const CommandLine& line, const Console& console) {
    struct Verb {
        std::string_view name;
        int (*act)(const CommandLine&, const Console&);
    };

    constexpr Verb verbs[] = {
        {"sweep", sweep_verb},     {"cache", cache_verb},   {"run", run_verb},       {"resume", resume_verb},
        {"report", report_verb},   {"new", new_verb},       {"check", check_verb},   {"plan", plan_verb},
        {"explain", explain_verb}, {"schema", schema_verb}, {"bench", bench_verb},   {"import", import_verb},
        {"compare", compare_verb}, {"verify", verify_verb}, {"export", export_verb}, {"figures", figures_verb},
        {"watch", watch_verb},     {"assess", assess_verb},
    };
    for (const Verb& verb : verbs) {
        if (verb.name == line.verb) {
            return verb.act(line, console);
        }
    }
    throw Bug("a verb without its function: " + line.verb);
}

casefile::Case load_asked_case(const CommandLine& line, const Console& console) {
    casefile::LoadedCase loaded = casefile::load_case(line.subject, {line.preset, line.overrides, line.studies});
    if (!loaded.warnings.empty()) {
        console.talk(render(loaded.warnings, console.has_color()));
    }
    return std::move(loaded.value);
}

std::filesystem::path cache_folder(const CommandLine& line, const std::filesystem::path& usual) {
    if (line.no_cache) {
        return {};
    }
    return line.cache.empty() ? usual : std::filesystem::absolute(line.cache).lexically_normal();
}

void set_threads(int asked) {
    const auto cores = static_cast<int>(std::thread::hardware_concurrency());
    set_thread_count(asked > 0 ? asked : std::max(cores, 1));
}

std::string json_text(const nlohmann::json& json) {
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

nlohmann::json problem_json(const Diagnostic& problem) {
    return {{"code", problem.code},     {"kind", problem.is_warning ? "warning" : "error"},
            {"file", problem.file},     {"line", problem.line},
            {"column", problem.column}, {"message", problem.message},
            {"help", problem.help}};
}

double quantity_of(const std::string& text, Dimension dimension, const std::string& flag, bool bare_is_si) {
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(text.data(), end, value);
    if (problem == std::errc() && stop == end && std::isfinite(value)) {
        if (bare_is_si) {
            return value;
        }
        const std::string unit = dimension == dimension::time ? "min" : usual_units(dimension).front();
        throw UsageError(fmt::format("{} {} has no unit; write {}{}", flag, shown(text), shown(text), unit));
    }
    try {
        return parse_quantity(text, dimension);
    } catch (const UnitError& error) {
        throw UsageError(fmt::format("{} {}: {}; {}", flag, shown(text), shown(error.what()), error.help));
    }
}

Mat3 cell_of(const std::string& text) {
    std::vector<double> values;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        values.push_back(quantity_of(text.substr(begin, end - begin), dimension::length, "--cell", true));
        begin = end + 1;
    }
    Mat3 h{};
    if (values.size() == 3) {
        h = diagonal({values[0], values[1], values[2]});
    } else if (values.size() == 9) {
        for (int a = 0; a < 3; ++a) {
            for (int b = 0; b < 3; ++b) {
                h(a, b) = values[static_cast<std::size_t>(3 * a + b)];
            }
        }
    } else {
        throw UsageError(
            fmt::format("--cell {} has {} numbers; it wants 3 edges, or 9 numbers", shown(text), values.size())
        );
    }
    if (!(determinant(h) > 0) || !std::isfinite(determinant(h))) {
        throw UsageError(fmt::format("--cell {} has no volume; its edges are positive lengths", shown(text)));
    }
    return h;
}

} // namespace suffuse::apps
