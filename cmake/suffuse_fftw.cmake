# FFTW 3.3 in double and single precision as one target; Debian's package brings no configuration. An installed suffuse
# finds it by this file, too.
find_path(FFTW_INCLUDE fftw3.h REQUIRED)
find_library(FFTW_LIBRARY fftw3 REQUIRED)
find_library(FFTW_SINGLE_LIBRARY fftw3f REQUIRED)
if(NOT TARGET suffuse_fftw)
    add_library(suffuse_fftw INTERFACE IMPORTED)
    target_include_directories(suffuse_fftw SYSTEM INTERFACE ${FFTW_INCLUDE})
    target_link_libraries(suffuse_fftw INTERFACE ${FFTW_LIBRARY} ${FFTW_SINGLE_LIBRARY})
endif()
