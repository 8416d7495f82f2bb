#include "suffuse/job/calibration_folder.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/read_text.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/missing_stages.hpp"
#include "suffuse/record/samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <system_error>
#include <utility>

namespace suffuse::job {

namespace fs = std::filesystem;

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

void keep_calibration_case(const fs::path& case_file, const fs::path& folder) {
    const fs::path kept = folder / calibration_case_file;
    const std::string text = read_whole_file(case_file);
    if (!fs::exists(kept)) {
        io::write_file(kept, text);
    } else if (read_whole_file(kept) != text) {
        throw UsageError(fmt::format(
            "{} has changed since {} began; give another folder", shown(case_file.string()), shown(folder.string())
        ));
    }
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
