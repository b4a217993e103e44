# Only one file for each need calls the operating system, starts threads or uses atomics: scripts/check_system_headers.awk lists them.
cmake_minimum_required(VERSION 3.25)
file(GLOB_RECURSE headers RELATIVE ${source} ${source}/concepts/*.hpp ${source}/include/*.hpp ${source}/include/*.ipp ${source}/adapters/*.hpp)
find_program(awk NAMES awk REQUIRED)
execute_process(COMMAND ${awk} -f ${source}/scripts/check_system_headers.awk ${headers} WORKING_DIRECTORY ${source} OUTPUT_VARIABLE found RESULT_VARIABLE code)
if(found OR NOT code EQUAL 0)
  message(FATAL_ERROR "headers that belong into one file, which scripts/check_system_headers.awk names:\n${found}")
endif()

# The check itself finds such headers, and accepts them where they belong.
file(WRITE ${scratch}/parallel.ipp "#include <thread>\n#include <vector>\n#include <cerrno>\n#include <zlib.h>\n")
file(WRITE ${scratch}/other.hpp "#include <thread>\n#include <sys/stat.h>\n  #  include <unistd.h>\n")
execute_process(COMMAND ${awk} -f ${source}/scripts/check_system_headers.awk ${scratch}/parallel.ipp OUTPUT_VARIABLE none RESULT_VARIABLE right)
execute_process(COMMAND ${awk} -f ${source}/scripts/check_system_headers.awk ${scratch}/other.hpp OUTPUT_VARIABLE found RESULT_VARIABLE wrong)
if(NOT right EQUAL 0 OR none OR wrong EQUAL 0 OR NOT found MATCHES "other.hpp:1:.*other.hpp:2:.*other.hpp:3:")
  message(FATAL_ERROR "scripts/check_system_headers.awk does not find system headers: ${right} ${none} ${wrong} ${found}")
endif()
