# CHOLMOD of SuiteSparse: target SuiteSparse::CHOLMOD. CHOLMOD_BLAS_IS_REFERENCE says whether the BLAS it would run on here is the slow one.
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
find_file(CHOLMOD_BLAS_LIBRARY NAMES libblas.so.3 PATHS /usr/lib /usr/lib64 /usr/local/lib PATH_SUFFIXES ${CMAKE_LIBRARY_ARCHITECTURE})
mark_as_advanced(CHOLMOD_INCLUDE_DIR CHOLMOD_LIBRARY CHOLMOD_BLAS_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CHOLMOD REQUIRED_VARS CHOLMOD_LIBRARY CHOLMOD_INCLUDE_DIR)
set(CHOLMOD_BLAS_IS_REFERENCE FALSE)
if(CHOLMOD_BLAS_LIBRARY)
  file(REAL_PATH ${CHOLMOD_BLAS_LIBRARY} CHOLMOD_BLAS_FILE)  # Debian: libblas.so.3 is a link to whichever is installed
  if(CHOLMOD_BLAS_FILE MATCHES "/blas/libblas[^/]*$")
    set(CHOLMOD_BLAS_IS_REFERENCE TRUE)
  endif()
endif()
set_property(GLOBAL PROPERTY concino_cholmod_blas_is_reference ${CHOLMOD_BLAS_IS_REFERENCE})  # for whoever calls from inside a function
if(CHOLMOD_FOUND AND NOT TARGET SuiteSparse::CHOLMOD)
  add_library(SuiteSparse::CHOLMOD INTERFACE IMPORTED)
  set_target_properties(SuiteSparse::CHOLMOD PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${CHOLMOD_INCLUDE_DIR}" INTERFACE_LINK_LIBRARIES "${CHOLMOD_LIBRARY}")
endif()
