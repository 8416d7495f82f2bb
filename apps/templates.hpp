#pragma once
// The cases that `new` starts from: the files of examples/, embedded when the program is built (embed_templates.cmake).

#include <span>
#include <string_view>

namespace suffuse::apps {

struct TemplateFile {
    std::string_view name; ///< of the template: the folder below examples/
    std::string_view path; ///< inside it
    std::string_view text;
};

std::span<const TemplateFile> template_files();

} // namespace suffuse::apps
