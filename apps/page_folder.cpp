#include "apps/page_folder.hpp"

#include <system_error>

namespace suffuse::apps {

std::filesystem::path page_folder() {
    std::error_code error;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    const std::filesystem::path page = program.parent_path().parent_path().parent_path() / "report-page";
    return !error && std::filesystem::is_directory(page, error) ? page : std::filesystem::path();
}

} // namespace suffuse::apps
