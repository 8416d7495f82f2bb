#include "suffuse/io/leftovers.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <dirent.h>
#include <fcntl.h>
#include <memory>
#include <string>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace suffuse::io {
namespace {

namespace fs = std::filesystem;

bool is_number(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

bool is_own_file(const struct stat& status) {
    return S_ISREG(status.st_mode) && status.st_uid == geteuid();
}

/// Names of a folder that are leftovers by their form. Every writing calls it, also in a folder of thousands of
/// snapshots: a path for each of them, as std::filesystem makes it, would take longer than the writing.
std::vector<std::string>
leftovers_in(const fs::path& folder, const std::function<bool(std::string_view)>& is_of_program) {
    struct Close {
        void operator()(DIR* open) const { ::closedir(open); }
    };

    std::vector<std::string> names;
    const std::unique_ptr<DIR, Close> open(::opendir(folder.c_str()));
    while (const dirent* entry = open ? ::readdir(open.get()) : nullptr) {
        const std::string_view name = static_cast<const char*>(entry->d_name);
        if (const std::string_view whole = name_of_leftover(name); !whole.empty() && is_of_program(whole)) {
            names.emplace_back(name);
        }
    }
    return names;
}

bool is_held(int descriptor) {
    int refused = 0;
    do {
        refused = ::flock(descriptor, LOCK_EX | LOCK_NB);
    } while (refused != 0 && errno == EINTR);
    return refused != 0;
}

} // namespace

std::string_view name_of_leftover(std::string_view name) {
    const std::size_t at = name.rfind(partial_suffix);
    if (at == std::string_view::npos) {
        return {};
    }
    const std::string_view numbers = name.substr(at + partial_suffix.size());
    const std::size_t dash = numbers.rfind('-');
    const bool is_form = numbers.starts_with('-') && dash > 0 && is_number(numbers.substr(1, dash - 1)) &&
                         is_number(numbers.substr(dash + 1));
    return is_form ? name.substr(0, at) : std::string_view();
}

fs::path next_partial(const fs::path& path) {
    static std::atomic<int> count{0};
    fs::path partial = path;
    partial += fmt::format("{}-{}-{}", partial_suffix, ::getpid(), ++count);
    return partial;
}

bool is_leftover_of(const fs::path& file, std::string_view name) {
    struct stat status {};

    const std::string own = file.filename().string();
    return name_of_leftover(own) == name && ::lstat(file.c_str(), &status) == 0 && is_own_file(status);
}

/// A program's number would not show whether it lives: several machines may write into one folder.
void remove_leftovers(const fs::path& folder, const std::function<bool(std::string_view)>& is_of_program) {
    for (const std::string& name : leftovers_in(folder, is_of_program)) {
        const fs::path partial = folder / name;
        const int descriptor = ::open(partial.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if (descriptor < 0) {
            continue;
        }

        struct stat status {};

        if (::fstat(descriptor, &status) == 0 && is_own_file(status) && !is_held(descriptor)) {
            ::unlink(partial.c_str());
        }
        ::close(descriptor);
    }
}

} // namespace suffuse::io
