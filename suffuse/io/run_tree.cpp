#include "suffuse/io/run_tree.hpp"

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/io/own_file.hpp"

#include <fmt/format.h>

#include <pwd.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace suffuse::io {
namespace {

namespace fs = std::filesystem;

std::string name_of_user(uid_t user) {
    const passwd* const known = ::getpwuid(user);
    return known != nullptr ? known->pw_name : fmt::format("number {}", user);
}

/// Files of other users, and one of these.
struct Foreign {
    std::size_t files = 0;
    uid_t owner = 0;
};

/// What goes meanwhile, for another program works there, is passed over.
void look_into(const fs::path& folder, Purpose purpose, Foreign& foreign) {
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; at != end && !error; at.increment(error)) {
        const fs::path& file = at->path();

        struct stat status {};

        if (::lstat(file.c_str(), &status) != 0) {
            continue;
        }
        if (S_ISLNK(status.st_mode) && purpose == Purpose::Work) {
            throw IoError(fmt::format(
                "{} is a link: a run folder that is written to holds none; replace it by its target, or remove it",
                file.string()
            ));
        }
        require_regular(file);
        if (!S_ISDIR(status.st_mode) && status.st_uid != ::geteuid()) {
            ++foreign.files;
            foreign.owner = status.st_uid;
        }
        if (S_ISDIR(status.st_mode)) {
            look_into(file, purpose, foreign);
        }
    }
    if (error && error != std::errc::no_such_file_or_directory) {
        throw IoError(fmt::format("{}: cannot be read: {}", folder.string(), error.message()));
    }
}

} // namespace

std::string look_into_run(const fs::path& run, Purpose purpose) {
    Foreign foreign;
    if (fs::is_directory(run)) {
        look_into(run, purpose, foreign);
    }
    return foreign.files == 0 ? ""
                              : fmt::format(
                                    "{}: {} belong{} to another user ({})", run.string(),
                                    plural(static_cast<std::ptrdiff_t>(foreign.files), "file"),
                                    foreign.files == 1 ? "s" : "", name_of_user(foreign.owner)
                                );
}

} // namespace suffuse::io
