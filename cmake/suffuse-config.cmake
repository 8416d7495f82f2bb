# What find_package(suffuse) reads: the libraries that ours were built with, then our own.
include(CMakeFindDependencyMacro)
get_property(languages GLOBAL PROPERTY ENABLED_LANGUAGES)
if(NOT C IN_LIST languages) # HDF5 is sought with its compiler
    enable_language(C)
endif()
find_dependency(Threads)
find_dependency(fmt 9)
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE) # ours is built already
find_dependency(CGAL 5.5)
find_dependency(tomlplusplus 3.3)
find_dependency(nlohmann_json 3.11)
set(HDF5_PREFER_PARALLEL FALSE)
find_dependency(HDF5 1.10 COMPONENTS C)
find_dependency(ZLIB)
find_dependency(OpenSSL 3 COMPONENTS Crypto)
include(${CMAKE_CURRENT_LIST_DIR}/suffuse_fftw.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/suffuse-targets.cmake)
