# Debian packages of what suffuse_install.cmake installs, a package each component: `cpack -G DEB` in the build's folder.
set(CPACK_PACKAGE_NAME suffuse)
set(CPACK_PACKAGE_VENDOR "The suffuse developers")
set(CPACK_PACKAGE_CONTACT "The suffuse developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "internal erosion of soils, grain by grain")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development)
if(TARGET suffuse_python)
    list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME suffuse)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "Discrete elements, pore-scale flow and an erosion loop: from a
grading curve and a hydraulic gradient to a soil that has lost its fines,
with its strength before and after, and a report.")
# Figures as files are drawn by Node, and by rsvg-convert where they are no SVG, in a font of Helvetica's widths; Chromium
# prints reports.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "nodejs (>= 18), librsvg2-bin, fonts-liberation")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "chromium, python3-suffuse")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-suffuse)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "The Python module of suffuse: packings, steps, flow and erosion on arrays
of NumPy.")
math(EXPR next_python "${Python_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3 (<< ${Python_VERSION_MAJOR}.${next_python}), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS suffuse) # whose page reports have

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libsuffuse-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Headers, static libraries and CMake's files for programs that are built
with suffuse.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libcgal-dev, libfftw3-dev, libfmt-dev, libgmp-dev, libhdf5-dev, libmpfr-dev, libssl-dev, libtomlplusplus-dev, nlohmann-json3-dev, zlib1g-dev")
include(CPack)
