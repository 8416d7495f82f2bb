# Compiler settings, in one interface target that every module links privately.
add_library(suffuse_options INTERFACE)
target_compile_options(suffuse_options INTERFACE
    -Wall -Wextra -Wpedantic -Wconversion
    $<$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>:-Wshadow> # there, names of other files are in sight
    -Wno-missing-field-initializers # what a designated initializer leaves out has its default in the struct
    # The same bits on every processor: no fused multiply-add unless written. No traps or errno are read, and saying so
    # lets the compiler turn branches into selects; neither changes a value.
    -ffp-contract=off -fno-math-errno -fno-trapping-math
    -Wno-psabi) # vectors wider than the least processor has are only passed where everything is inlined
# What computes little (words, pages, tests) need not take long to build; values are the same.
add_library(suffuse_light INTERFACE)
target_compile_options(suffuse_light INTERFACE $<$<CONFIG:Release>:-O1>)
# What is words throughout reads its large headers once for eight files: a first build takes half of the time. Whoever
# works on a file has it built alone (SUFFUSE_UNITY is OFF).
function(suffuse_words)
    foreach(target ${ARGN})
        target_link_libraries(${target} PRIVATE suffuse_light)
        if(SUFFUSE_UNITY)
            set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
        endif()
    endforeach()
endfunction()
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
    set(CMAKE_CXX_COMPILER_LAUNCHER ${SUFFUSE_CCACHE})
endif()
