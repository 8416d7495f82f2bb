#include "suffuse/job/scratch_folder.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <system_error>

namespace suffuse::job {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t least_space = 64'000'000; // [B], for what a browser keeps and the drawings of a large run

/// Empty where it cannot be made.
fs::path make_within(const fs::path& folder) {
    std::string name = (folder / ".suffuse-scratch-XXXXXX").string();
    return mkdtemp(name.data()) == nullptr ? fs::path() : fs::path(name);
}

/// A folder where temporary files belong and have room; empty where there is none.
fs::path make_among_temporary() {
    std::error_code error;
    const fs::path usual = fs::temp_directory_path(error);
    if (error) {
        return {};
    }
    const fs::space_info space = fs::space(usual, error);
    return error || space.available < least_space ? fs::path() : make_within(usual);
}

} // namespace

ScratchFolder::ScratchFolder(const fs::path& otherwise) : path_(make_among_temporary()) {
    if (path_.empty()) {
        path_ = make_within(fs::absolute(otherwise));
    }
    if (path_.empty()) {
        throw IoError(fmt::format(
            "no folder for temporary files: neither TMPDIR nor {} takes one; set TMPDIR to a folder that you may write "
            "to",
            otherwise.string()
        ));
    }
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

} // namespace suffuse::job
