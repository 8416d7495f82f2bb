#include "tests/fuzz/finished_run.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/casefile/load_case.hpp"
#include "suffuse/job/ended_run.hpp"
#include "suffuse/job/run_case.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/record/checksums.hpp"
#include "suffuse/record/finished_stages.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/refine.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <unistd.h>

namespace suffuse::fuzz {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void put(const fs::path& file, const std::string& bytes) {
    if (!std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
        std::abort();
    }
}

/// Files that no reader of runs reads: they are written for people.
bool is_for_people(const fs::path& name) {
    return name.extension() == ".html" || name.extension() == ".csv" || *name.begin() == "figures";
}

/// What the program tells its user in words may be thrown.
template <class Look>
void look(const Look& look_at) {
    try {
        look_at();
    } catch (const Error&) {
    } catch (const fs::filesystem_error&) {
    }
}

} // namespace

FinishedRun& FinishedRun::the() {
    static FinishedRun run;
    return run;
}

FinishedRun::FinishedRun() {
    set_thread_count(1); // so small a run has no work for more
    std::string name = "/dev/shm/suffuse-fuzz-XXXXXX";
    if (mkdtemp(name.data()) == nullptr) {
        std::abort();
    }
    root_ = name, folder_ = root_ / "run";
    const std::string case_file = std::string(SUFFUSE_FUZZ_DATA) + "/run/case.toml";
    run::RunOptions options;
    options.folder = folder_;
    options.command = "suffuse run case.toml";
    options.case_text = bytes_of(case_file);
    job::run_case(casefile::load_case(case_file).value, options);
    job::save_request(folder_, {.case_file = case_file, .preset = "", .overrides = {}, .studies = {}, .cache = {}});
    job::rebuild_report(folder_, {}, "suffuse report run"); // signs the options, too
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_)) {
        if (entry.is_regular_file()) {
            const fs::path file = entry.path().lexically_relative(folder_);
            (is_for_people(file) ? others_ : files_)[file.string()] = bytes_of(entry.path());
        }
    }
}

FinishedRun::~FinishedRun() {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
}

/// Who changes a file can write checksums that fit it.
void FinishedRun::seal(const std::map<std::string, std::string>& replaced) const {
    const auto sign = [&](const fs::path& sums_file, const std::string& name, const std::string& below) {
        if (replaced.contains(sums_file.string())) {
            return;
        }
        record::Sums sums = record::read_sums(folder_ / sums_file);
        if (const auto line = sums.find(below); line != sums.end()) {
            line->second = record::checksum_of_text(replaced.at(name));
            put(folder_ / sums_file, record::sums_text(sums));
        }
    };
    for (const auto& [name, bytes] : replaced) {
        const fs::path file = name;
        sign(file.parent_path() / record::checksums_file, name, file.filename());
        sign(record::checksums_file, name, name);
    }
}

void FinishedRun::put_back(const std::map<std::string, std::string>& replaced) const {
    for (const auto& [name, bytes] : others_) { // which the report has written anew
        put(folder_ / name, bytes);
    }
    for (const auto& [name, bytes] : files_) {
        const fs::path file = name;
        if (replaced.contains(name) || file.filename() == record::checksums_file || !file.has_parent_path()) {
            put(folder_ / file, bytes);
        }
    }
}

void FinishedRun::look_with(const std::map<std::string, std::string>& replaced) {
    for (const auto& [name, bytes] : replaced) {
        put(folder_ / name, bytes);
    }
    seal(replaced);
    look([&] { record::verify_run(folder_); });
    look([&] { job::read_request(folder_); });
    look([&] {
        run::RunOptions options;
        options.folder = folder_;
        record::require_whole_run(folder_);
        job::find_ended(record::load_run(folder_), options);
    });
    look([&] {
        record::require_whole_run(folder_);
        job::rebuild_report(folder_, {}, "suffuse report run");
    });
    put_back(replaced);
}

} // namespace suffuse::fuzz

/// The run takes longer than libFuzzer lets an input take.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
    suffuse::fuzz::FinishedRun::the();
    return 0;
}
