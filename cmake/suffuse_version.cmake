# version.cpp: version, commit and compiler, for the provenance of results. The commit is requested in every build and not
# when it is configured, or a program that was built again would name an old one; the file is written only where it
# changes, so that nothing is compiled or linked for it otherwise.
if(CMAKE_SCRIPT_MODE_FILE)
    execute_process(
        COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=10 --exclude=*
        OUTPUT_VARIABLE SUFFUSE_COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(NOT SUFFUSE_COMMIT)
        set(SUFFUSE_COMMIT unknown)
    endif()
    configure_file(${IN} ${OUT} @ONLY)
    return()
endif()

set(with_compiler ${PROJECT_BINARY_DIR}/generated/version.cpp.in)
set(SUFFUSE_COMMIT @SUFFUSE_COMMIT@)
configure_file(${PROJECT_SOURCE_DIR}/suffuse/base/version.cpp.in ${with_compiler} @ONLY)
set(version_source ${PROJECT_BINARY_DIR}/generated/version.cpp)
add_custom_target(name_commit
    COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D IN=${with_compiler} -D OUT=${version_source}
            -P ${CMAKE_CURRENT_LIST_FILE}
    BYPRODUCTS ${version_source}
    VERBATIM)
target_sources(suffuse_base PRIVATE ${version_source})
add_dependencies(suffuse_base name_commit)
