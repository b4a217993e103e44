# Boost's Parallel BGL and Boost.MPI: target ParallelBGL::ParallelBGL.
find_package(Boost 1.74 QUIET COMPONENTS graph_parallel mpi)
set(ParallelBGL_HAS_TARGETS FALSE)
if(TARGET Boost::graph_parallel AND TARGET Boost::mpi)
  set(ParallelBGL_HAS_TARGETS TRUE)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(ParallelBGL REQUIRED_VARS ParallelBGL_HAS_TARGETS VERSION_VAR Boost_VERSION)
if(ParallelBGL_FOUND AND NOT TARGET ParallelBGL::ParallelBGL)
  add_library(ParallelBGL::ParallelBGL INTERFACE IMPORTED)
  # the definition: its headers use names of Boost.Bind which are announced as deprecated in each compilation
  set_target_properties(ParallelBGL::ParallelBGL PROPERTIES INTERFACE_LINK_LIBRARIES "Boost::graph_parallel;Boost::mpi" INTERFACE_COMPILE_DEFINITIONS BOOST_BIND_GLOBAL_PLACEHOLDERS)
endif()
