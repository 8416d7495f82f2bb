#pragma once
// The cases that `new` starts from: the files of examples/, embedded when the program is built (embed_templates.cmake).

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::apps {

struct TemplateFile {
    std::string_view name; ///< of the template: the folder below examples/
    std::string_view path; ///< inside it
    std::string_view text;
};

std::span<const TemplateFile> template_files();

inline std::vector<std::string> template_names() {
    std::vector<std::string> names;
    for (const TemplateFile& file : template_files()) {
        if (names.empty() || names.back() != file.name) {
            names.emplace_back(file.name);
        }
    }
    return names;
}

} // namespace suffuse::apps
