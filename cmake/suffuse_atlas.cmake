# The tables of the atlas as strings in the library, so that the program needs no other file.
if(CMAKE_SCRIPT_MODE_FILE)
    file(READ ${FROM} text)
    file(WRITE ${TO} "#include \"suffuse/atlas/${HEADER}\"

namespace suffuse::atlas {

std::string_view ${FUNCTION}() {
    return R\"csv(${text})csv\";
}

} // namespace suffuse::atlas
")
    return()
endif()

function(embed_table name header function)
    set(table ${PROJECT_SOURCE_DIR}/suffuse/atlas/${name}.csv)
    set(source ${PROJECT_BINARY_DIR}/generated/${name}.cpp)
    add_custom_command(
        OUTPUT ${source}
        COMMAND ${CMAKE_COMMAND} -DFROM=${table} -DTO=${source} -DHEADER=${header} -DFUNCTION=${function}
            -P ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
        DEPENDS ${table} ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
        COMMENT "Embedding the atlas, ${name}")
    target_sources(suffuse_atlas PRIVATE ${source})
endfunction()

embed_table(gradients row.hpp shipped_table)
embed_table(filters filter_row.hpp shipped_filter_table)
