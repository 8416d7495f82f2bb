#include "suffuse/record/stored.hpp"

#include "suffuse/base/shell_word.hpp"
#include "suffuse/record/folder.hpp"

#include <fmt/format.h>

namespace suffuse::record {
namespace {

namespace fs = std::filesystem;

std::string what_helps(const fs::path& file) {
    const fs::path name = file.filename();
    if (fs::is_directory(file)) {
        return fmt::format(
            "find the file with suffuse verify {}; remove the folder of its stage and resume", shell_word(file.string())
        );
    }
    if (name == "stage.json" || name == "results.cbor") {
        return fmt::format("remove {} and resume: its stage is then computed anew", file.parent_path().string());
    }
    if (name == options_file) {
        return "restore its contents, or begin the run anew in another folder";
    }
    return "remove it and resume";
}

} // namespace

IoError not_as_stored(const fs::path& file, const std::string& found) {
    return IoError(fmt::format(
        "{}: has changed since it was written ({}): it was modified or damaged, or belongs to another version; {}",
        file.string(), found, what_helps(file)
    ));
}

std::string words_of(const nlohmann::json::exception& error) {
    const std::string text = error.what(); // "[json.exception.out_of_range.403] key 'mean' not found"
    const std::size_t end = text.find("] ");
    return end == std::string::npos ? text : text.substr(end + 2);
}

} // namespace suffuse::record
