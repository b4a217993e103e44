# Every `if constexpr` on the kind or dimension of a mesh has a reason: scripts/check_branches.awk says what a reason is.
cmake_minimum_required(VERSION 3.25)
file(GLOB_RECURSE headers RELATIVE ${source} ${source}/concepts/*.hpp ${source}/include/*.hpp ${source}/include/*.ipp ${source}/adapters/*.hpp)
find_program(awk NAMES awk REQUIRED)
execute_process(COMMAND ${awk} -f ${source}/scripts/check_branches.awk ${headers} WORKING_DIRECTORY ${source} OUTPUT_VARIABLE found RESULT_VARIABLE code)
if(found OR NOT code EQUAL 0)
  message(FATAL_ERROR "branches on the kind or dimension of a mesh without a reason:\n${found}")
endif()

# The check itself finds branches without a reason, and accepts reasons.
file(WRITE ${scratch}/with.hpp "// why\n  if constexpr (SurfaceMesh<M>) f();\n\n  if constexpr (dimension_v<M> == 3) {  // why\n")
file(WRITE ${scratch}/without.hpp "  f();\n  if constexpr (SurfaceMesh<M>) f();\n")
execute_process(COMMAND ${awk} -f ${source}/scripts/check_branches.awk ${scratch}/with.hpp RESULT_VARIABLE with)
execute_process(COMMAND ${awk} -f ${source}/scripts/check_branches.awk ${scratch}/without.hpp OUTPUT_VARIABLE found RESULT_VARIABLE without)
if(NOT with EQUAL 0 OR without EQUAL 0 OR NOT found MATCHES "without.hpp:2:")
  message(FATAL_ERROR "scripts/check_branches.awk does not distinguish branches with and without a reason: ${with} ${without} ${found}")
endif()
