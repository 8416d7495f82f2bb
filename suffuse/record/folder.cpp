#include "suffuse/record/folder.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/version.hpp"
#include "suffuse/casefile/bind.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/folders.hpp"
#include "suffuse/io/own_file.hpp"
#include "suffuse/record/case_hash.hpp"
#include "suffuse/record/documents.hpp"
#include "suffuse/record/samples.hpp"
#include "suffuse/record/stored.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <fstream>
#include <vector>

namespace suffuse::record {
namespace {

std::string read_all(const std::filesystem::path& path) {
    io::require_regular(path);
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw IoError(fmt::format("{}: cannot be read; is this a run folder?", path.string()));
    }
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Names of files may be any bytes; what is not UTF-8 is replaced.
std::string text_of(const nlohmann::json& json, int indent) {
    return json.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace);
}

bool is_utf8(const std::string& text) {
    try {
        [[maybe_unused]] const std::string valid = nlohmann::json(text).dump();
        return true;
    } catch (const nlohmann::json::type_error&) {
        return false;
    }
}

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (line.rfind("model name", 0) == 0) {
            return line.substr(line.find(':') + 2);
        }
    }
    return "unknown";
}

std::string now_utc() {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

/// The protocols of the case's compactions, in order, each once.
std::string protocols_of(const casefile::Case& what) {
    std::vector<std::string_view> names;
    for (const casefile::Study& study : what.studies) {
        for (const casefile::Variant& variant : study.variants) {
            for (const casefile::Stage& stage : variant.stages) {
                const auto* compact = std::get_if<packing::CompactSpec>(&stage.spec);
                if (compact != nullptr && std::ranges::count(names, packing::name_of(compact->protocol)) == 0) {
                    names.push_back(packing::name_of(compact->protocol));
                }
            }
        }
    }
    return names.empty() ? "imported" : fmt::format("{}", fmt::join(names, ", "));
}

/// Of one call.
nlohmann::json describe_provenance(const casefile::Case& what, const std::string& command, double wall_seconds) {
    nlohmann::json provenance = {
        {"program", "suffuse"},
        {"version", version()},
        {"commit", commit()},
        {"compiler", compiler()},
        {"processor", processor()},
        {"threads", thread_count()},
        {"seed", what.seed},
        {"preset", what.preset},
        {"case_hash", case_hash(what)},
        {"mode", dem::name_of(what.mode)},
        {"preparation", protocols_of(what)},
        {"command", command},
        {"finished", now_utc()},
        {"wall_seconds", wall_seconds},
    };
    if (!what.paper.empty()) {
        provenance["paper"] = what.paper;
    }
    return provenance;
}

/// What differs between the calls of a run.
nlohmann::json describe_call(const nlohmann::json& provenance) {
    nlohmann::json call = nlohmann::json::object();
    for (const char* const key : {"command", "version", "commit", "threads", "finished", "wall_seconds"}) {
        if (provenance.contains(key)) {
            call[key] = provenance.at(key);
        }
    }
    return call;
}

} // namespace

std::filesystem::path
stage_folder(const std::filesystem::path& run, const casefile::Variant& variant, const casefile::Stage& stage) {
    return run / "studies" / variant.folder / stage.name;
}

std::filesystem::path pass_file(const std::filesystem::path& stage_folder, int pass) {
    return stage_folder / fmt::format("pass-{}.h5", pass);
}

std::filesystem::path frame_file(const std::filesystem::path& stage_folder, std::size_t frame) {
    return stage_folder / fmt::format("frame-{}.h5", frame);
}

std::string case_that_began(const std::filesystem::path& run) {
    const std::filesystem::path file = run / options_file;
    if (!std::filesystem::exists(file)) {
        return "";
    }
    const nlohmann::json options = read_json(file);
    const bool has_name = options.is_object() && options.contains("case") && options.at("case").is_string();
    return has_name ? options.at("case").get<std::string>() : ""; // a path that is no text is kept as bytes
}

nlohmann::json read_json(const std::filesystem::path& path) {
    const std::string text = read_all(path);
    nlohmann::json json = parse_json(text);
    if (json.is_discarded()) {
        throw not_as_stored(path, "no valid JSON");
    }
    return json;
}

std::string file_text_of(const nlohmann::json& json) {
    return text_of(json, 2) + "\n";
}

void write_json(const std::filesystem::path& path, const nlohmann::json& json) {
    io::write_file(path, file_text_of(json));
}

nlohmann::json read_cbor(const std::filesystem::path& path) {
    const std::string bytes = read_all(path);
    nlohmann::json json = parse_cbor({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    if (json.is_discarded()) {
        throw not_as_stored(path, "no valid CBOR");
    }
    return json;
}

void write_cbor(const std::filesystem::path& path, const nlohmann::json& json) {
    const std::vector<std::uint8_t> bytes = nlohmann::json::to_cbor(json);
    io::write_file(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

void open_folder(const std::filesystem::path& run, const casefile::Case& what, const std::string& case_text) {
    io::make_folders(run);
    const std::string resolved = casefile::resolved_toml(what);
    if (!is_utf8(resolved)) { // TOML is; what reads it back would refuse it
        throw CaseError(fmt::format(
            "{}: the path of a data file is not UTF-8, so that no case file can name it; rename the folder",
            run.string()
        ));
    }
    const std::filesystem::path kept = run / resolved_case_file;
    if (std::filesystem::exists(kept)) {
        if (read_all(kept) == resolved) {
            return;
        }
        throw CaseError(fmt::format(
            "{}: holds a run of another case (or of this case with other settings); give -o another folder, or remove "
            "this one",
            run.string()
        ));
    }
    if (!case_text.empty()) {
        io::write_file(run / "case.toml", case_text);
    }
    io::write_file(kept, resolved);
}

void check_is_run(const std::filesystem::path& folder) {
    if (!std::filesystem::exists(folder / resolved_case_file)) {
        throw IoError(fmt::format(
            "{}: holds no run, because it has no {}; give the folder that suffuse run printed", folder.string(),
            resolved_case_file
        ));
    }
}

void check_is_in_place(const std::filesystem::path& run) {
    if (!std::filesystem::exists(run / resolved_case_file)) {
        throw IoError(fmt::format(
            "{}: was moved or removed while the run worked in it; the finished stages are in the moved folder: "
            "continue there with suffuse resume",
            run.string()
        ));
    }
}

void to_json(nlohmann::json& json, const FailedSample& failure) {
    json = {{"sample", failure.sample}, {"stage", failure.stage}, {"kind", failure.kind}, {"message", failure.message}};
}

void keep_failure(const std::filesystem::path& run, const FailedSample& failure) {
    check_is_in_place(run);
    const std::filesystem::path folder = run / "studies" / failure.sample / failure.stage;
    io::make_folders(folder);
    nlohmann::json kept = failure;
    kept["at"] = now_utc();
    write_json(folder / failure_file, kept);
}

std::vector<FailedSample> read_failures(const std::filesystem::path& run, const casefile::Case& what) {
    std::vector<FailedSample> failures;
    for (const Sample& sample : list_samples(what)) {
        for (const casefile::Stage& stage : sample.variant->stages) {
            const std::filesystem::path folder = stage_folder(run, *sample.variant, stage);
            const std::filesystem::path file = folder / failure_file;
            if (std::filesystem::exists(file) && !std::filesystem::exists(folder / "stage.json")) {
                const nlohmann::json kept = read_json(file);
                failures.push_back(take_from(file, [&]() -> FailedSample {
                    return {kept.at("sample"), kept.at("stage"), kept.at("kind"), kept.at("message")};
                }));
            }
        }
    }
    return failures;
}

void log_event(const std::filesystem::path& run, nlohmann::json event) {
    event["at"] = now_utc();
    io::append_to(run / "events.jsonl", text_of(event, -1) + "\n");
}

void keep_provenance(
    const std::filesystem::path& folder, const casefile::Case& what, const std::string& command, double wall_seconds,
    const std::string& until
) {
    const std::filesystem::path file = folder / provenance_file;
    nlohmann::json provenance = describe_provenance(what, command, wall_seconds), calls = nlohmann::json::array();
    if (std::filesystem::exists(file)) {
        const nlohmann::json earlier = read_json(file); // of a version that knew the last call only, or of this one
        calls =
            take_from(file, [&] { return earlier.value("calls", nlohmann::json::array({describe_call(earlier)})); });
    }
    calls.push_back(describe_call(provenance));
    take_from(file, [&] {
        double total = 0;
        for (const nlohmann::json& call : calls) {
            total += call.value("wall_seconds", 0.0);
        }
        provenance["command"] = calls.front().value("command", "");
        provenance["wall_seconds"] = total;
    });
    provenance["calls"] = std::move(calls);
    if (!until.empty()) {
        provenance["until"] = until;
    }
    write_json(file, provenance);
}

} // namespace suffuse::record
