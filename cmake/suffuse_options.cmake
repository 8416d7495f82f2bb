# Compiler settings, in one interface target that every module links privately.
add_library(suffuse_options INTERFACE)
target_compile_options(suffuse_options INTERFACE
    -Wall -Wextra -Wpedantic -Wconversion
    # Of eight files that are read as one, names of the others are in sight: there, only a function's own may not be hidden, and
    # clang cannot distinguish them.
    $<IF:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>,$<$<CXX_COMPILER_ID:GNU>:-Wshadow=local>,-Wshadow>
    -Wno-missing-field-initializers # what a designated initializer leaves out has its default in the struct
    # The same bits on every processor: no fused multiply-add unless written. No traps or errno are read, and saying so
    # lets the compiler turn branches into selects; neither changes a value.
    -ffp-contract=off -fno-math-errno -fno-trapping-math
    -Wno-psabi) # vectors wider than the least processor has are only passed where everything is inlined
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # The compiler tidies its memory from half a gigabyte on only: a fifth less time for words.
    target_compile_options(suffuse_options INTERFACE "SHELL:--param ggc-min-heapsize=500000")
endif()
# What computes little (words, pages, tests) need not take long to build; values are the same.
add_library(suffuse_light INTERFACE)
target_compile_options(suffuse_light INTERFACE $<$<CONFIG:Release>:-O1>)
# The same objects make the program and the Python module.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
if(SUFFUSE_WERROR)
    target_compile_options(suffuse_options INTERFACE -Werror)
endif()
if(SUFFUSE_SANITIZE)
    add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=address,undefined)
endif()
if(SUFFUSE_FUZZ)
    add_compile_options(-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=address,undefined)
endif()
find_program(SUFFUSE_CCACHE ccache)
if(SUFFUSE_CCACHE)
    # The cache finds compiled headers again only where this says that they hold no dates.
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${SUFFUSE_CCACHE})
    if(SUFFUSE_QUICK_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
        add_compile_options(-fpch-preprocess)
    endif()
endif()
# Two ways to build everything in less time (SUFFUSE_QUICK_BUILD); without it, each file is built alone, with all that it
# includes. First: what sources of one kind include most is compiled once for all of them, which must have the same options
# and definitions.
set(suffuse_common_headers algorithm array cmath cstdint filesystem functional limits map numeric optional span string
    string_view utility vector fmt/format.h)
# suffuse_kind_of_source(KIND [PROGRAMS] LINK targets... HEADERS headers...)
function(suffuse_kind_of_source kind)
    cmake_parse_arguments(ARG "PROGRAMS" "" "LINK;HEADERS" ${ARGN})
    if(SUFFUSE_QUICK_BUILD)
        set(source ${PROJECT_BINARY_DIR}/generated/headers_of_${kind}.cpp)
        file(GENERATE OUTPUT ${source} CONTENT "")
        set(owner suffuse_headers_of_${kind})
        add_library(${owner} OBJECT ${source})
        target_link_libraries(${owner} PRIVATE suffuse_options fmt::fmt ${ARG_LINK})
        list(TRANSFORM ARG_HEADERS REPLACE "(.+)" "<\\1>")
        target_precompile_headers(${owner} PRIVATE ${ARG_HEADERS})
        if(ARG_PROGRAMS) # a library would compile them with -fPIC
            set_target_properties(${owner} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
            target_compile_options(${owner} PRIVATE -fPIE)
        endif()
    endif()
endfunction()
# Second: what is words reads its other headers once for eight files.
function(suffuse_read_as_one target)
    if(SUFFUSE_QUICK_BUILD)
        set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    endif()
endfunction()
# suffuse_kind(TARGET KIND): the sources of the target are of that kind.
function(suffuse_kind target kind)
    if(SUFFUSE_QUICK_BUILD)
        target_precompile_headers(${target} REUSE_FROM suffuse_headers_of_${kind})
    endif()
    if(kind MATCHES words)
        target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:suffuse_light>)
        suffuse_read_as_one(${target})
    endif()
endfunction()
