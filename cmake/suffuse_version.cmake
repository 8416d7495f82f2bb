# Writes version.cpp into the build folder: version, commit and compiler, for the provenance of results.
execute_process(
    COMMAND git -C ${PROJECT_SOURCE_DIR} describe --always --dirty --abbrev=10 --exclude=*
    OUTPUT_VARIABLE SUFFUSE_COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT SUFFUSE_COMMIT)
    set(SUFFUSE_COMMIT unknown)
endif()
configure_file(${PROJECT_SOURCE_DIR}/suffuse/base/version.cpp.in ${PROJECT_BINARY_DIR}/generated/version.cpp @ONLY)
target_sources(suffuse_base PRIVATE ${PROJECT_BINARY_DIR}/generated/version.cpp)
