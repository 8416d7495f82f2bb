#include "suffuse/job/verify_calibration.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/job/calibration_files.hpp"
#include "suffuse/job/calibration_folder.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/refine.hpp"
#include "suffuse/record/samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>

namespace suffuse::job {
namespace {

namespace fs = std::filesystem;

/// Names of the calibration's own files that are there, with the checksums of its rounds.
std::set<std::string> own_files(const fs::path& folder) {
    std::set<std::string> names;
    for (const char* name :
         {calibration_case_file, calibration_inputs_file, record::options_file, record::provenance_file,
          calibration_file, posterior_file, "contact.toml", "report.html"}) {
        if (fs::exists(folder / name)) {
            names.insert(name);
        }
    }
    if (fs::exists(folder / "figures")) {
        for (const fs::directory_entry& entry : fs::directory_iterator(folder / "figures")) {
            if (const std::string name = entry.path().filename(); name.starts_with("own-calibration-")) {
                names.insert("figures/" + name);
            }
        }
    }
    for (const fs::path& round : rounds_of(folder)) {
        if (fs::exists(round / record::checksums_file)) {
            names.insert((round.filename() / record::checksums_file).string());
        }
    }
    return names;
}

/// Of a run: its stages that are missing though their sample has not failed.
std::vector<std::string> lost_stages(const fs::path& round, const std::vector<std::string>& missing) {
    const std::vector<record::FailedSample> failures = record::read_failures(round, record::load_run(round));
    std::vector<std::string> lost;
    std::ranges::copy_if(missing, std::back_inserter(lost), [&](const std::string& name) {
        return std::ranges::none_of(failures, [&](const record::FailedSample& failure) {
            return name.starts_with(failure.sample + "/");
        });
    });
    return lost;
}

void add_round(record::Verification& all, const fs::path& round) {
    const record::Verification found = record::verify_run(round);
    const std::string name = round.filename().string() + "/";
    const auto append = [&](std::vector<std::string>& to, const std::vector<std::string>& names) {
        std::ranges::transform(names, std::back_inserter(to), [&](const std::string& each) { return name + each; });
    };
    all.files += found.files;
    all.states += found.states;
    all.stages += found.stages;
    all.missing.of += found.missing.of;
    append(all.without_checksums, found.without_checksums);
    append(all.unverified, found.unverified);
    append(all.more, found.more);
    if (!found.missing.names.empty()) {
        append(all.missing.names, lost_stages(round, found.missing.names));
    }
    for (const record::Damage& damage : found.damages) {
        all.damages.push_back({name + damage.file, damage.what});
    }
}

} // namespace

void write_calibration_sums(const fs::path& folder) {
    record::Sums sums;
    for (const std::string& name : own_files(folder)) {
        sums[name] = record::checksum_of(folder / name);
    }
    io::write_file(folder / record::checksums_file, record::sums_text(sums));
}

record::Verification verify_calibration(const fs::path& folder) {
    if (!fs::exists(folder / record::checksums_file)) {
        throw IoError(fmt::format(
            "{0}: the calibration has not ended, or an earlier version made it; suffuse resume {1} continues it and "
            "writes its checksums",
            folder.string(), shell_word(folder.string())
        ));
    }
    const record::Sums sums = record::read_run_sums(folder);
    record::Verification all;
    for (const auto& [name, sum] : sums) {
        ++all.files;
        if (std::string what = record::describe_damage(folder / name, sum); !what.empty()) {
            all.damages.push_back({name, std::move(what)});
        }
    }
    for (const std::string& name : own_files(folder)) {
        if (!sums.contains(name)) {
            all.more.push_back(name);
        }
    }
    for (const fs::path& round : rounds_of(folder)) {
        add_round(all, round);
    }
    return all;
}

} // namespace suffuse::job
