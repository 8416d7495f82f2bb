# suffuse_module(NAME DEPENDS modules... LINK targets...)
# A module is the folder suffuse/NAME: its *.cpp make the library suffuse_NAME, its *.test.cpp the test program
# suffuse_NAME_test, its *.bench.cpp the benchmark suffuse_NAME_bench. Adding a file is adding a file.
function(suffuse_module name)
    cmake_parse_arguments(ARG "" "" "DEPENDS;LINK;PRIVATE_LINK" ${ARGN})
    set(folder ${PROJECT_SOURCE_DIR}/suffuse/${name})
    file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
    file(GLOB tests CONFIGURE_DEPENDS ${folder}/*.test.cpp)
    file(GLOB benches CONFIGURE_DEPENDS ${folder}/*.bench.cpp)
    if(tests OR benches)
        list(REMOVE_ITEM sources ${tests} ${benches})
    endif()
    list(TRANSFORM ARG_DEPENDS PREPEND suffuse_)

    set(library suffuse_${name})
    if(sources)
        add_library(${library} STATIC ${sources})
        target_include_directories(${library} PUBLIC ${PROJECT_SOURCE_DIR})
        target_link_libraries(${library} PUBLIC ${ARG_DEPENDS} ${ARG_LINK} PRIVATE suffuse_options ${ARG_PRIVATE_LINK})
    else()
        add_library(${library} INTERFACE)
        target_include_directories(${library} INTERFACE ${PROJECT_SOURCE_DIR})
        target_link_libraries(${library} INTERFACE ${ARG_DEPENDS} ${ARG_LINK})
    endif()

    if(SUFFUSE_TESTS AND tests)
        suffuse_test_program(${library}_test unit ${tests})
        target_link_libraries(${library}_test PRIVATE ${library} ${ARG_PRIVATE_LINK})
    endif()
    if(SUFFUSE_BENCHMARKS AND benches)
        add_executable(${library}_bench ${benches})
        target_link_libraries(${library}_bench PRIVATE ${library} suffuse_options benchmark::benchmark_main)
    endif()
endfunction()

# suffuse_test_program(TARGET LABEL sources...): a GoogleTest program, each test known to ctest under LABEL.
function(suffuse_test_program target label)
    add_executable(${target} ${ARGN})
    target_compile_definitions(${target} PRIVATE SUFFUSE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
    target_link_libraries(${target} PRIVATE suffuse_options GTest::gtest GTest::gtest_main rapidcheck
        Eigen3::Eigen nlohmann_json::nlohmann_json ZLIB::ZLIB) # the reference's files are compressed JSON
    gtest_discover_tests(${target} DISCOVERY_MODE PRE_TEST PROPERTIES LABELS ${label} DISCOVERY_TIMEOUT 60)
endfunction()
