#include "suffuse/job/calibration_folder.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/read_text.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/casefile/bind.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/missing_stages.hpp"
#include "suffuse/record/samples.hpp"
#include "suffuse/record/stored.hpp"
#include "suffuse/record/sums.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>

namespace suffuse::job {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

json checksums_of_data(const casefile::CalibrationCase& what) {
    json sums = json::object();
    for (const casefile::CalibrateTarget& target : what.spec.targets) {
        sums[target.name] = record::checksum_of(target.file);
    }
    return sums;
}

/// Of the first round, which has the gradings and rows of other files in full.
std::string checksum_of_samples(const casefile::CalibrationCase& what) {
    return record::checksum_of_text(casefile::resolved_toml(first_round(what)));
}

/// "calibrate.particles": a key that has another value in one of the two texts of settings.
std::string find_other_key(const std::string& before, const std::string& now) {
    const auto lines_of = [](const std::string& text) {
        std::set<std::string> lines;
        std::string table;
        std::istringstream stream(text);
        for (std::string line; std::getline(stream, line);) {
            if (line.starts_with('[')) {
                table = line.substr(1, line.find(']') - 1) + ".";
            } else {
                lines.insert(table + line);
            }
        }
        return lines;
    };
    const std::set<std::string> kept = lines_of(before), wanted = lines_of(now);
    for (const auto& [these, others] : {std::pair(&wanted, &kept), std::pair(&kept, &wanted)}) {
        for (const std::string& line : *these) {
            if (!others->contains(line)) {
                return line.substr(0, line.find(" = "));
            }
        }
    }
    return "";
}

/// That settings and data are those with which the calibration in `folder` began. @throws CaseError
void require_same_inputs(const casefile::CalibrationCase& what, const fs::path& folder) {
    const fs::path file = folder / calibration_inputs_file;
    const std::string shown_folder = shown(folder.string());
    if (!fs::exists(file)) {
        throw CaseError(fmt::format(
            "{}: has no {}: an earlier version began this calibration without a record of its settings and data; "
            "give -o another folder",
            shown_folder, calibration_inputs_file
        ));
    }
    const json kept = record::read_json(file);
    record::take_from(file, [&] {
        if (const std::string before = kept.at("settings"); before != what.settings) {
            throw CaseError(fmt::format(
                "{}: holds a calibration with other settings (another {}); give -o another folder", shown_folder,
                find_other_key(before, what.settings)
            ));
        }
        const json data = checksums_of_data(what);
        for (const casefile::CalibrateTarget& target : what.spec.targets) {
            if (kept.at("data").at(target.name) != data.at(target.name)) {
                throw CaseError(fmt::format(
                    "{} has changed since the calibration in {} began; restore it, or give -o another folder",
                    shown(target.file), shown_folder
                ));
            }
        }
        if (kept.at("samples") != checksum_of_samples(what)) {
            throw CaseError(fmt::format(
                "{}: its samples were others when the calibration began: a file of the case, such as a grading, has "
                "changed, or the version of suffuse; restore it, or give -o another folder",
                shown_folder
            ));
        }
    });
}

} // namespace

bool is_calibration(const fs::path& folder) {
    std::error_code error;
    return fs::is_regular_file(folder / calibration_case_file, error);
}

std::vector<fs::path> rounds_of(const fs::path& folder) {
    std::vector<fs::path> rounds;
    for (int number = 1;; ++number) {
        fs::path round = folder / fmt::format("round-{}", number);
        std::error_code error;
        if (!fs::is_regular_file(round / record::resolved_case_file, error)) {
            break;
        }
        rounds.push_back(std::move(round));
    }
    if (fs::path last = folder / "held-out"; fs::exists(last / record::resolved_case_file)) {
        rounds.push_back(std::move(last));
    }
    return rounds;
}

void keep_calibration_case(
    const std::string& case_file, const casefile::CalibrationCase& what, const fs::path& folder
) {
    const fs::path kept = folder / calibration_case_file;
    const std::string text = read_whole_file(case_file);
    if (!fs::exists(kept)) {
        record::write_json(
            folder / calibration_inputs_file,
            {{"settings", what.settings}, {"data", checksums_of_data(what)}, {"samples", checksum_of_samples(what)}}
        );
        io::write_file(kept, text);
        return;
    }
    if (read_whole_file(kept) != text) {
        throw UsageError(
            fmt::format("{} has changed since {} began; give another folder", shown(case_file), shown(folder.string()))
        );
    }
    require_same_inputs(what, folder);
}

bool is_round_done(const CalibrationRound& round) {
    if (!fs::exists(round.folder / record::resolved_case_file)) {
        return false;
    }
    std::set<std::string> failed;
    for (const record::FailedSample& failure : record::read_failures(round.folder, round.samples)) {
        failed.insert(failure.sample);
    }
    return std::ranges::all_of(record::list_samples(round.samples), [&](const record::Sample& sample) {
        return failed.contains(sample.variant->folder) || record::is_complete(sample, round.folder);
    });
}

} // namespace suffuse::job
