# Lines have at most 120 columns: scripts/check_columns.awk says which may be longer.
cmake_minimum_required(VERSION 3.25)
file(GLOB_RECURSE headers RELATIVE ${source} ${source}/concepts/*.hpp ${source}/include/*.hpp ${source}/include/*.ipp ${source}/adapters/*.hpp ${source}/adapters/*.cpp)
find_program(awk NAMES awk REQUIRED)
execute_process(COMMAND ${awk} -f ${source}/scripts/check_columns.awk ${headers} WORKING_DIRECTORY ${source} OUTPUT_VARIABLE found RESULT_VARIABLE code)
if(found OR NOT code EQUAL 0)
  message(FATAL_ERROR "lines of more than 120 columns; clang-format divides them:\n${found}")
endif()

# The check itself finds long lines, and accepts those that may be long.
string(REPEAT "x" 120 x)
file(WRITE ${scratch}/short.hpp
  "${x}\n#include <${x}>\nvoid f(int) = delete;  // ${x}\nstatic_assert(f, \"${x}\");\n    \"${x}\");\n// clang-format off\nint ${x};\n// clang-format on\n")
file(WRITE ${scratch}/long.hpp "\nf(\"${x}\");\n// ${x}\n")
execute_process(COMMAND ${awk} -f ${source}/scripts/check_columns.awk ${scratch}/short.hpp OUTPUT_VARIABLE found_short RESULT_VARIABLE short)
execute_process(COMMAND ${awk} -f ${source}/scripts/check_columns.awk ${scratch}/long.hpp OUTPUT_VARIABLE found RESULT_VARIABLE long)
if(NOT short EQUAL 0 OR NOT long EQUAL 1 OR NOT found MATCHES "long.hpp:2: .*long.hpp:3: ")
  message(FATAL_ERROR "scripts/check_columns.awk does not distinguish long lines from short ones: ${short} ${found_short} ${long} ${found}")
endif()
