#include "apps/shared_options.hpp"

#include "suffuse/base/byte_size.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/memory_bound.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/render_within.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/base/units.hpp"
#include "suffuse/casefile/load_case.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/plan/fit_memory.hpp"
#include "suffuse/record/folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/typed_value.hpp"
#include <algorithm>
#include <limits>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace suffuse::apps {

void CaseChanges::add_to(Options& options) {
    options.value("--preset", preset, "size of the job, one of the case's [presets.*]")
        .type("NAME")
        .suggest({"quick", "standard", "paper"});
    options.values("--set", overrides, "change one value of the case; may be repeated").type("KEY=VALUE");
    options.values("--study", studies, "this study of the case alone; may be repeated").type("NAME");
}

std::string case_in(const std::string& given) {
    const std::filesystem::path folder = given, file = folder / "case.toml";
    std::error_code none;
    if (!std::filesystem::is_directory(folder, none) || !std::filesystem::exists(file, none)) {
        return given;
    }
    if (std::filesystem::exists(folder / "run_options.json", none)) {
        throw UsageError(fmt::format(
            "{} is the folder of a run: suffuse resume continues it, suffuse report rewrites its page", shown(given)
        ));
    }
    return file.string();
}

casefile::Case load_given_case(const std::string& file, const CaseChanges& changes, const Console& console) {
    casefile::LoadedCase loaded = casefile::load_case(file, changes);
    if (!loaded.warnings.empty()) {
        console.talk(render_within(loaded.warnings, console.has_color(), source_width()));
    }
    return std::move(loaded.value);
}

void ThreadOption::add_to(Options& options) {
    options.value("-j,--threads", requested, "threads; by default all cores. Results do not depend on it")
        .type("N")
        .whole_number(1, 1024);
}

void ThreadOption::apply() const {
    const auto cores = static_cast<int>(std::thread::hardware_concurrency());
    set_thread_count(requested > 0 ? requested : std::max(cores, 1));
}

void CacheOptions::add_to(Options& options) {
    const Option cache = options
                             .value(
                                 "--cache", folder,
                                 "folder in which stages are stored for reuse; by default suffuse-cache next to the run"
                             )
                             .type("DIR");
    options.flag("--shared-cache", is_shared, "also use stages stored there by other users");
    options.flag("--no-cache", is_off, "compute every stage and store none").excludes(cache);
}

std::filesystem::path CacheOptions::folder_or(const std::filesystem::path& usual) const {
    if (is_off) {
        return {};
    }
    return folder.empty() ? usual : std::filesystem::absolute(folder).lexically_normal();
}

std::filesystem::path cache_to_go_on(
    const CacheOptions& requested, const std::filesystem::path& run, bool is_trusted, const Console& console
) {
    const std::filesystem::path usual_cache = job::cache_next_to(run);
    const bool is_begun = std::filesystem::exists(run / record::options_file);
    const std::optional<std::string> earlier = is_begun ? job::read_request(run).cache : std::nullopt;
    if (earlier && (is_trusted || earlier->empty())) {
        return requested.folder_or(*earlier);
    }
    if (earlier && !requested.is_requested() && *earlier != std::filesystem::absolute(usual_cache).lexically_normal()) {
        console.talk(fmt::format(
            "This run began with another cache, and a run folder may not choose one. To use that cache: --cache {}",
            shell_word(shown(*earlier))
        ));
    }
    return requested.folder_or(usual_cache);
}

void look_at_run(const std::filesystem::path& run, io::Purpose purpose, const Console& console) {
    if (const std::string remark = io::look_into_run(run, purpose); !remark.empty()) {
        console.talk("warning: " + remark);
    }
}

double time_of(const std::string& text, const std::string& flag) {
    constexpr double longest = 3.2e9; // [s], a hundred years
    if (text.empty()) {
        return std::numeric_limits<double>::infinity();
    }
    const double limit = quantity_of(text, dimension::time, flag, false);
    if (!(limit > 0)) {
        throw UsageError(fmt::format("{} {} leaves no time; write one such as 90min", flag, shown(text)));
    }
    if (limit > longest) {
        throw UsageError(fmt::format("{} {} is more than a hundred years; leave it out for none", flag, shown(text)));
    }
    return limit;
}

double time_limit_of(const std::string& text) {
    return time_of(text, "--time-limit");
}

void RunLimits::add_to(Options& options) {
    add_until(options, until);
    options.value("--time-limit", time_limit, "save and stop after this wall time, as in 90min or 2h").type("TIME");
}

void MemoryOption::add_to(Options& options) {
    options
        .value(
            "--memory", requested,
            fmt::format(
                "maximum memory of the run, as in 16GB; by default {:.0f} % of the machine's",
                100 * plan::usual_memory_share
            )
        )
        .type("SIZE");
}

double MemoryOption::bytes() const {
    if (requested.empty()) {
        return plan::usual_memory_share * machine_memory();
    }
    try {
        return parse_byte_size(requested);
    } catch (const UnitError& error) {
        throw UsageError(fmt::format("--memory {}: {}; {}", shown(requested), error.what(), error.help));
    }
}

void add_until(Options& options, std::string& stage) {
    options.value("--until", stage, "end each sample with this stage").type("STAGE");
}

void CellOption::add_to(Options& options) {
    options
        .value(
            "--cell", edges,
            "edges of its cell in meters, or nine numbers, its matrix by rows; the file's own unless given"
        )
        .type("LX,LY,LZ");
}

std::optional<Mat3> CellOption::matrix() const {
    return edges.empty() ? std::nullopt : std::optional(cell_of(edges));
}

void PackingOutput::add_to(Options& options) {
    options.value("-o,--output", file, "file to write").type("FILE");
    const std::string names = fmt::format("{}", fmt::join(io::packing_format_names(), ", "));
    options.value("--format", format, names + "; by the file's ending unless given")
        .type("NAME")
        .suggest(io::packing_format_names);
}

io::PackingFormat PackingOutput::chosen_format() const {
    const std::vector<std::string> names = io::packing_format_names();
    const auto chosen = format.empty() ? io::packing_format_of_file(file) : io::packing_format_of_name(format);
    if (chosen) {
        return *chosen;
    }
    if (format.empty()) {
        throw UsageError(fmt::format(
            "the ending of {} does not determine the format; give --format, one of {}", shown(file),
            fmt::join(names, ", ")
        ));
    }
    throw UsageError(fmt::format(
        "unknown format {}{}; there are {}", shown(format), near_hint(format, names), fmt::join(names, ", ")
    ));
}

} // namespace suffuse::apps
