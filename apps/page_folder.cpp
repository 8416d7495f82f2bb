#include "apps/page_folder.hpp"

#include <system_error>

namespace suffuse::apps {

std::filesystem::path page_folder() {
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    const std::filesystem::path built = folder.parent_path().parent_path() / "report-page";
    const std::filesystem::path installed = folder.parent_path() / "share" / "suffuse" / "report-page";
    for (const std::filesystem::path& page : {built, installed}) {
        if (std::filesystem::is_directory(page, error)) {
            return page;
        }
    }
    return {};
}

} // namespace suffuse::apps
