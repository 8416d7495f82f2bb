# The rows of the atlas as a string in the library, so that the program needs no other file.
if(CMAKE_SCRIPT_MODE_FILE)
    file(READ ${FROM} text)
    file(WRITE ${TO} "#include \"suffuse/atlas/row.hpp\"

namespace suffuse::atlas {

std::string_view shipped_table() {
    return R\"csv(${text})csv\";
}

} // namespace suffuse::atlas
")
    return()
endif()

set(gradients ${PROJECT_SOURCE_DIR}/suffuse/atlas/gradients.csv)
set(gradients_source ${PROJECT_BINARY_DIR}/generated/gradients.cpp)
add_custom_command(
    OUTPUT ${gradients_source}
    COMMAND ${CMAKE_COMMAND} -DFROM=${gradients} -DTO=${gradients_source} -P ${CMAKE_CURRENT_LIST_FILE}
    DEPENDS ${gradients} ${CMAKE_CURRENT_LIST_FILE}
    COMMENT "Embedding the atlas")
target_sources(suffuse_atlas PRIVATE ${gradients_source})
