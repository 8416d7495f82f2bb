# suffuse_module(NAME [WORDS] [AS_ONE] [TESTS_ALONE] LINK targets... PRIVATE_LINK targets...)
# A module is the folder suffuse/NAME: its *.cpp make the library suffuse_NAME, its *.test.cpp the test program
# suffuse_NAME_test, its *.bench.cpp the benchmark suffuse_NAME_bench. Adding a file is adding a file.
# AS_ONE: its sources share no names and are read eight at a time, like words. TESTS_ALONE: its tests share some.
# It depends on the modules that its line of tools/layers.txt names.
set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tools/layers.txt)
file(STRINGS ${PROJECT_SOURCE_DIR}/tools/layers.txt suffuse_layers REGEX "^[a-z]+ +:[a-z ]*$")

function(suffuse_module name)
    cmake_parse_arguments(ARG "WORDS;AS_ONE;TESTS_ALONE" "" "LINK;PRIVATE_LINK" ${ARGN})
    set(modules ${suffuse_layers})
    list(FILTER modules INCLUDE REGEX "^${name} ")
    string(REGEX REPLACE "^[a-z]+ +: *" "" modules "${modules}")
    separate_arguments(modules)
    list(TRANSFORM modules PREPEND suffuse_)
    set(folder ${PROJECT_SOURCE_DIR}/suffuse/${name})
    file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
    file(GLOB tests CONFIGURE_DEPENDS ${folder}/*.test.cpp)
    file(GLOB benches CONFIGURE_DEPENDS ${folder}/*.bench.cpp)
    if(tests OR benches)
        list(REMOVE_ITEM sources ${tests} ${benches})
    endif()
    set(kind physics)
    set(kind_of_tests tests)
    if(ARG_WORDS)
        set(kind words)
        set(kind_of_tests tests_of_words)
    endif()

    set(library suffuse_${name})
    if(sources)
        add_library(${library} STATIC ${sources})
        target_include_directories(${library} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
        target_link_libraries(${library} PUBLIC ${modules} ${ARG_LINK}
            PRIVATE $<BUILD_INTERFACE:suffuse_options> ${ARG_PRIVATE_LINK})
        suffuse_kind(${library} ${kind})
        if(ARG_AS_ONE)
            suffuse_read_as_one(${library})
        endif()
    else()
        add_library(${library} INTERFACE)
        target_include_directories(${library} INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
        target_link_libraries(${library} INTERFACE ${modules} ${ARG_LINK})
    endif()
    set_target_properties(${library} PROPERTIES EXPORT_NAME ${name})
    set_property(GLOBAL APPEND PROPERTY SUFFUSE_ROOMS ${library})

    if(SUFFUSE_TESTS AND tests)
        suffuse_test_program(${library}_test unit 1 ${kind_of_tests} ${tests})
        target_link_libraries(${library}_test PRIVATE ${library} ${ARG_PRIVATE_LINK})
        if(NOT ARG_TESTS_ALONE)
            suffuse_read_as_one(${library}_test)
        endif()
    endif()
    if(SUFFUSE_BENCHMARKS AND benches)
        add_executable(${library}_bench ${benches})
        target_link_libraries(${library}_bench PRIVATE ${library} suffuse_options benchmark::benchmark_main)
    endif()
endfunction()

# Drawing the charts of a report takes longer than most runs of tests: those that need drawings ask for them.
set(suffuse_without_stills SUFFUSE_STILLS=no)

# suffuse_test_program(TARGET LABEL SHARDS KIND sources...): a GoogleTest program, known to ctest under LABEL as so many processes
# that share its tests: a process for each test would take longer to start than most tests take. Each leaves its results in
# test-results/, which tools/count_tests.py sums. What writes samples for the browser's tests is no test.
function(suffuse_test_program target label shards kind)
    add_executable(${target} ${ARGN})
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
    target_link_libraries(${target} PRIVATE suffuse_test_support suffuse_options suffuse_light GTest::gtest GTest::gtest_main rapidcheck
        Eigen3::Eigen nlohmann_json::nlohmann_json)
    suffuse_kind(${target} ${kind})
    if(label STREQUAL "unit")
        add_dependencies(unit_tests ${target})
    endif()
    math(EXPR last "${shards} - 1")
    foreach(shard RANGE ${last})
        set(name ${target})
        if(shards GREATER 1)
            set(name ${target}.${shard})
        endif()
        add_test(NAME ${name} COMMAND ${target} --gtest_brief=1 --gtest_filter=-SampleRun.*
            --gtest_output=xml:${PROJECT_BINARY_DIR}/test-results/${name}.xml)
        set_tests_properties(${name} PROPERTIES LABELS ${label} ENVIRONMENT
            "GTEST_TOTAL_SHARDS=${shards};GTEST_SHARD_INDEX=${shard};${suffuse_without_stills}")
    endforeach()
endfunction()
