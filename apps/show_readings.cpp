#include "apps/show_readings.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/failed_files.hpp"
#include "apps/grading_input.hpp"
#include "apps/json_text.hpp"

namespace suffuse::apps {
namespace {

using nlohmann::json;

json reading_json(const gradings::SheetReading& reading, const json& remarks) {
    return {{"size", reading.size}, {"unit", reading.size_unit},        {"share", reading.share},
            {"kind", reading.kind}, {"share_unit", reading.share_unit}, {"flag", reading.flag},
            {"remarks", remarks}};
}

} // namespace

int show_readings(
    const std::vector<std::string>& files, const std::string& sample, const gradings::ReadingOptions& reading,
    const Console& console
) {
    json soils = json::array(), remarks = json::array();
    FailedFiles failed(files.size());
    for (const std::string& file : files) {
        gradings::GradingFile read;
        failed.attempt(file, console, [&] { read = read_gradings_of(file, sample, reading); });
        if (read.soils.empty()) {
            continue;
        }
        print_remarks(read, console);
        console.result(fmt::format("{}{}", files.size() > 1 ? file + "\n" : "", shown_reading(read)));
        json of_file = json::array();
        for (const Diagnostic& remark : read.remarks) {
            of_file.push_back(remark_text(remark));
        }
        for (const gradings::NamedGrading& soil : read.soils) {
            soils.push_back(
                {{"file", file},
                 {"soil", soil.name},
                 {"reading", reading_json(soil.reading, of_file)},
                 {"diameter", soil.grading.diameter},
                 {"passing", soil.grading.passing}}
            );
        }
        remarks.insert(remarks.end(), of_file.begin(), of_file.end());
    }
    json document{{"soils", soils}, {"remarks", remarks}};
    failed.add_to(document);
    console.document(json_text(document));
    return failed.code();
}

} // namespace suffuse::apps
