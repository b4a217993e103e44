# lib3mf 1.8: target Lib3MF::Lib3MF, spelled <Model/COM/NMR_DLLInterfaces.h>. Version 2 has other headers.
find_path(Lib3MF_INCLUDE_DIR Model/COM/NMR_DLLInterfaces.h PATH_SUFFIXES lib3mf)
find_library(Lib3MF_LIBRARY 3MF)
mark_as_advanced(Lib3MF_INCLUDE_DIR Lib3MF_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Lib3MF REQUIRED_VARS Lib3MF_LIBRARY Lib3MF_INCLUDE_DIR)
if(Lib3MF_FOUND AND NOT TARGET Lib3MF::Lib3MF)
  add_library(Lib3MF::Lib3MF INTERFACE IMPORTED)
  set_target_properties(Lib3MF::Lib3MF PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${Lib3MF_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${Lib3MF_LIBRARY}")
endif()
