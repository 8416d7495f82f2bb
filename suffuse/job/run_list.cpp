#include "suffuse/job/run_list.hpp"

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/casefile/calibration_case.hpp"
#include "suffuse/job/calibration_files.hpp"
#include "suffuse/job/calibration_folder.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/missing_stages.hpp"
#include "suffuse/record/refine.hpp"
#include "suffuse/record/samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>

namespace suffuse::job {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A file of a run that was interrupted may be missing, or damaged: the list still shows the others.
json read_or_empty(const fs::path& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) {
        return json::object();
    }
    try {
        const json read = record::read_json(file);
        return read.is_object() ? read : json::object();
    } catch (const Error&) {
        return json::object();
    }
}

template <class Value>
Value value_or(const json& from, const char* key, Value otherwise) {
    const auto found = from.find(key);
    if (found == from.end() || found->is_null()) {
        return otherwise;
    }
    try {
        return found->get<Value>();
    } catch (const json::exception&) {
        return otherwise;
    }
}

std::string state_of(const fs::path& run, const json& summary) {
    if (is_at_work(run)) {
        return "at work";
    }
    const json nothing = json::array();
    if (!value_or(summary, "failures", nothing).empty()) {
        return "failed in part";
    }
    const bool ended_early = !value_or(summary, "until", std::string()).empty(); // as specified
    if (summary.empty() && fs::exists(run / "tasks.txt")) {
        return "tasks emitted";
    }
    if (summary.empty() || (!ended_early && !value_or(summary, "missing_stages", nothing).empty())) {
        return "not complete";
    }
    return value_or(summary, "flaws", nothing).empty() ? "done" : "flaws";
}

/// Of a run that goes on: its summary is older than its samples, or there is none yet.
void look_into(const fs::path& run, ListedRun& listed) {
    try {
        const casefile::Case what = record::load_run(run);
        const std::vector<record::Sample> samples = record::list_samples(what, listed.until);
        listed.title = what.title;
        listed.samples = static_cast<int>(samples.size());
        listed.done = static_cast<int>(std::ranges::count_if(samples, [&run](const record::Sample& sample) {
            return record::is_complete(sample, run);
        }));
        const bool is_task_at_work = std::ranges::any_of(samples, [&run](const record::Sample& sample) {
            return is_at_work(run / "studies" / sample.variant->folder);
        });
        listed.state = is_task_at_work ? "at work" : listed.state;
    } catch (const Error&) { // the list still shows the others
    }
}

ListedRun describe(const fs::path& run) {
    const json summary = read_or_empty(run / "summary.json"), provenance = read_or_empty(run / record::provenance_file);
    const json samples = value_or(summary, "samples", json::object());
    ListedRun listed;
    listed.name = run.filename().string();
    listed.title = value_or(summary, "title", std::string());
    listed.state = state_of(run, summary);
    listed.samples = value_or(samples, "total", 0);
    listed.done = value_or(samples, "done", 0);
    listed.until = value_or(summary, "until", std::string());
    listed.seconds = value_or(provenance, "wall_seconds", 0.0);
    listed.finished = value_or(provenance, "finished", std::string());
    listed.commit = value_or(provenance, "commit", std::string());
    listed.verdict = value_or(value_or(summary, "answer", json::object()), "verdict", std::vector<std::string>());
    if (listed.state != "done" && listed.state != "flaws") {
        look_into(run, listed);
    }
    return listed;
}

/// Samples that fail are data of a calibration: it is done all the same.
ListedRun list_calibration(const fs::path& run) {
    const json answer = read_or_empty(run / calibration_file),
               provenance = read_or_empty(run / record::provenance_file);
    ListedRun listed;
    listed.is_calibration = true;
    listed.name = run.filename().string();
    try {
        listed.title = answer.contains("title")
                           ? value_or(answer, "title", std::string())
                           : casefile::load_calibration((run / calibration_case_file).string()).title;
    } catch (const Error&) { // its records lie next to the case that began it
        listed.title = "calibration";
    }
    listed.state = is_at_work(run) ? "at work" : value_or(answer, "complete", false) ? "done" : "not complete";
    for (const json& sample : value_or(answer, "samples", json::array())) {
        ++listed.samples;
        listed.done += sample.contains("misfit") ? 1 : 0;
    }
    listed.seconds = value_or(provenance, "wall_seconds", 0.0);
    listed.finished = value_or(provenance, "finished", std::string());
    listed.commit = value_or(provenance, "commit", std::string());
    listed.verdict = value_or(answer, "verdict", std::vector<std::string>());
    return listed;
}

/// Whether `a` stands before `b`.
bool comes_before(const ListedRun& a, const ListedRun& b, RunOrder order) {
    switch (order) {
    case RunOrder::Finished:
        return std::tie(b.finished, a.name) < std::tie(a.finished, b.name);
    case RunOrder::Name:
        return a.name < b.name;
    case RunOrder::Time:
        return std::tie(b.seconds, a.name) < std::tie(a.seconds, b.name);
    case RunOrder::Samples:
        return std::tie(b.samples, a.name) < std::tie(a.samples, b.name);
    case RunOrder::Title:
        return std::tie(a.title, a.name) < std::tie(b.title, b.name);
    }
    throw Bug("an order of runs without its rule");
}

/// Characters as a terminal counts them; those of several bytes are one.
std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    }));
}

std::string cut(const std::string& text, std::size_t width) {
    if (width_of(text) <= width) {
        return text;
    }
    std::string out;
    std::size_t count = 0;
    for (const char c : text) {
        count += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1U : 0U;
        if (count >= width) {
            break;
        }
        out += c;
    }
    return out + "…";
}

} // namespace

std::vector<ListedRun> list_runs(const fs::path& folder, RunOrder order) {
    std::error_code error;
    if (!fs::is_directory(folder, error)) {
        throw IoError(fmt::format(
            "{} is no folder; suffuse run makes runs/NAME-0001 where it is called, or -o DIR", shown(folder.string())
        ));
    }
    std::vector<ListedRun> runs;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (entry.is_directory(error) && is_calibration(entry.path())) {
            runs.push_back(list_calibration(entry.path()));
        } else if (entry.is_directory(error) && fs::exists(entry.path() / record::resolved_case_file, error)) {
            runs.push_back(describe(entry.path()));
        }
    }
    std::ranges::sort(runs, [&](const ListedRun& a, const ListedRun& b) { return comes_before(a, b, order); });
    return runs;
}

std::string text_of(const std::vector<ListedRun>& runs, std::size_t width) {
    constexpr std::size_t columns = 5, gap = 2, least_verdict = 20;
    using Row = std::array<std::string, columns>;
    std::vector<Row> rows = {{"run", "state", "samples", "took", "ended (UTC)"}};
    for (const ListedRun& run : runs) {
        std::string ended = run.finished.substr(0, 16);
        std::ranges::replace(ended, 'T', ' ');
        rows.push_back(
            {run.name, run.state,
             fmt::format("{}/{}{}{}", run.done, run.samples, run.until.empty() ? "" : " until ", run.until),
             run.seconds > 0 ? duration_text(run.seconds) : "", ended}
        );
    }
    std::array<std::size_t, columns> widths{};
    for (const Row& row : rows) {
        for (std::size_t c = 0; c < columns; ++c) {
            widths[c] = std::max(widths[c], width_of(row[c]));
        }
    }
    std::size_t used = 0;
    for (const std::size_t each : widths) {
        used += each + gap;
    }
    std::string text;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (std::size_t c = 0; c < columns; ++c) {
            text += rows[r][c] + std::string(widths[c] + gap - width_of(rows[r][c]), ' ');
        }
        const ListedRun* const run = r == 0 ? nullptr : &runs[r - 1];
        const std::string found = run == nullptr         ? "what it found"
                                  : run->verdict.empty() ? run->title
                                                         : run->verdict.front();
        text +=
            cut(found, std::max(width > used ? width - used : 0, least_verdict)) + (r + 1 < rows.size() ? "\n" : "");
    }
    return text;
}

json json_of(const std::vector<ListedRun>& runs) {
    json list = json::array();
    for (const ListedRun& run : runs) {
        list.push_back(
            {{"name", run.name},
             {"title", run.title},
             {"kind", run.is_calibration ? "calibration" : "run"},
             {"state", run.state},
             {"samples", {{"total", run.samples}, {"done", run.done}}},
             {"until", run.until.empty() ? json() : json(run.until)},
             {"wall_seconds", run.seconds},
             {"finished", run.finished},
             {"commit", run.commit},
             {"verdict", run.verdict}}
        );
    }
    return list;
}

} // namespace suffuse::job
