# What is installed and where, in three components: the program with its page, documents and examples; the Python module; what
# a program in C++ is built with. Everything is found from where it lies, so that an installed tree may be moved.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(SUFFUSE_REPORT_PAGE ${PROJECT_SOURCE_DIR}/build/report-page CACHE PATH "Where page/build.sh left the report's page")
set(documents share/doc/suffuse)

# The program. Its page is made by npm, outside of CMake, and may be missing: reports are plain then.
install(TARGETS suffuse RUNTIME DESTINATION bin COMPONENT program)
set(page_files ${SUFFUSE_REPORT_PAGE}/page.js ${SUFFUSE_REPORT_PAGE}/page.js.sha256 ${SUFFUSE_REPORT_PAGE}/figures.mjs
    ${SUFFUSE_REPORT_PAGE}/notices.txt ${SUFFUSE_REPORT_PAGE}/studio.html ${SUFFUSE_REPORT_PAGE}/studio.js
    ${SUFFUSE_REPORT_PAGE}/studio.css)
install(FILES ${page_files} DESTINATION share/suffuse/report-page COMPONENT program OPTIONAL)
install(CODE "
    if(NOT EXISTS \"${SUFFUSE_REPORT_PAGE}/page.js\")
        message(WARNING \"No page in ${SUFFUSE_REPORT_PAGE}: reports of what is installed are plain. page/build.sh makes it.\")
    endif()" COMPONENT program)
install(FILES suffuse/atlas/gradients.csv suffuse/atlas/filters.csv DESTINATION share/suffuse/atlas COMPONENT program)
install(FILES README.md CHANGELOG.md CITATION.cff DESTINATION ${documents} COMPONENT program)
install(DIRECTORY docs examples validation DESTINATION ${documents} COMPONENT program
    FILES_MATCHING PATTERN "*.md" PATTERN "*.toml" PATTERN "*.csv" PATTERN "*.txt" PATTERN "*.py" PATTERN "*.png" PATTERN "*.svg" PATTERN "*.bib"
    PATTERN "__pycache__" EXCLUDE)
foreach(package "suffuse|program" "python3-suffuse|python" "libsuffuse-dev|development")
    string(REPLACE "|" ";" package ${package})
    list(GET package 0 name)
    list(GET package 1 component)
    install(FILES packaging/copyright DESTINATION share/doc/${name} COMPONENT ${component})
endforeach()
# The program writes its manual page and what shells complete with.
foreach(written "man|share/man/man1|suffuse.1" "completions bash|share/bash-completion/completions|suffuse"
        "completions zsh|share/zsh/vendor-completions|_suffuse" "completions fish|share/fish/vendor_completions.d|suffuse.fish")
    string(REGEX MATCH "^([^|]+)[|]([^|]+)[|](.+)$" unused "${written}")
    separate_arguments(words UNIX_COMMAND "${CMAKE_MATCH_1}")
    set(file ${PROJECT_BINARY_DIR}/generated/${CMAKE_MATCH_2}/${CMAKE_MATCH_3})
    install(CODE "
        file(MAKE_DIRECTORY \"${PROJECT_BINARY_DIR}/generated/${CMAKE_MATCH_2}\")
        execute_process(COMMAND \"$<TARGET_FILE:suffuse>\" ${words} OUTPUT_FILE \"${file}\" COMMAND_ERROR_IS_FATAL ANY)"
        COMPONENT program)
    install(FILES ${file} DESTINATION ${CMAKE_MATCH_2} COMPONENT program)
endforeach()

# For programs in C++: find_package(suffuse), then link suffuse::suffuse.
add_library(suffuse_library INTERFACE)
set_target_properties(suffuse_library PROPERTIES EXPORT_NAME suffuse)
target_compile_features(suffuse_library INTERFACE cxx_std_20)
# Functions of headers, too, have the same bits on every processor.
target_compile_options(suffuse_library INTERFACE -ffp-contract=off)
get_property(rooms GLOBAL PROPERTY SUFFUSE_ROOMS)
target_link_libraries(suffuse_library INTERFACE ${rooms})
install(TARGETS suffuse_library ${rooms} suffuse_page_style EXPORT suffuse
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY suffuse DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
    FILES_MATCHING PATTERN "*.hpp" PATTERN "*_for_tests.hpp" EXCLUDE PATTERN "*_of_test.hpp" EXCLUDE PATTERN "*_tests.hpp" EXCLUDE)
set(config ${CMAKE_INSTALL_LIBDIR}/cmake/suffuse)
install(EXPORT suffuse NAMESPACE suffuse:: FILE suffuse-targets.cmake DESTINATION ${config} COMPONENT development)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/generated/suffuse-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/generated/suffuse-config-version.cmake cmake/suffuse-config.cmake cmake/suffuse_fftw.cmake
    DESTINATION ${config} COMPONENT development)
