# Clipper 6: target Polyclipping::Polyclipping, spelled <polyclipping/clipper.hpp>.
find_path(Polyclipping_INCLUDE_DIR polyclipping/clipper.hpp)
find_library(Polyclipping_LIBRARY polyclipping)
mark_as_advanced(Polyclipping_INCLUDE_DIR Polyclipping_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Polyclipping REQUIRED_VARS Polyclipping_LIBRARY Polyclipping_INCLUDE_DIR)
if(Polyclipping_FOUND AND NOT TARGET Polyclipping::Polyclipping)
  add_library(Polyclipping::Polyclipping INTERFACE IMPORTED)
  set_target_properties(Polyclipping::Polyclipping PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${Polyclipping_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${Polyclipping_LIBRARY}")
endif()
