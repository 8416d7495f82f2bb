# cmake -DFROM=examples -DTO=templates.cpp -P embed_templates.cmake: case files and their data as string literals.
file(GLOB files RELATIVE ${FROM} ${FROM}/*/*.toml ${FROM}/*/*.csv ${FROM}/*/data/*.csv)
list(SORT files)
set(rows "")
foreach(file IN LISTS files)
    string(REGEX MATCH "^([^/]*)/(.*)$" unused "${file}")
    set(name ${CMAKE_MATCH_1})
    set(path ${CMAKE_MATCH_2})
    file(READ ${FROM}/${file} text)
    string(APPEND rows "    {\"${name}\", \"${path}\", R\"suffuse(${text})suffuse\"},\n")
endforeach()
file(WRITE ${TO} "#include \"apps/templates.hpp\"

#include <array>

namespace suffuse::apps {

std::span<const TemplateFile> template_files() {
    static constexpr auto files = std::to_array<TemplateFile>({
${rows}    });
    return files;
}

} // namespace suffuse::apps
")
