# Files have at most 250 lines, but tables of numbers, which scripts/check_file_lengths.awk names.
cmake_minimum_required(VERSION 3.25)
file(GLOB_RECURSE headers RELATIVE ${source} ${source}/concepts/*.hpp ${source}/include/*.hpp ${source}/include/*.ipp
  ${source}/adapters/*.hpp ${source}/adapters/*.cpp)
find_program(awk NAMES awk REQUIRED)
execute_process(COMMAND ${awk} -f ${source}/scripts/check_file_lengths.awk ${headers} WORKING_DIRECTORY ${source}
  OUTPUT_VARIABLE found RESULT_VARIABLE code)
if(found OR NOT code EQUAL 0)
  message(FATAL_ERROR "files of more than 250 lines; divide them into files of one purpose each:\n${found}")
endif()

# The check itself finds long files, the last one too, and accepts short ones and tables.
string(REPEAT "x\n" 250 lines)
file(WRITE ${scratch}/short.hpp "${lines}")
file(WRITE ${scratch}/long.hpp "${lines}x\n")
file(WRITE ${scratch}/longer.hpp "${lines}x\nx")
file(WRITE ${scratch}/font_table.hpp "${lines}x\n")
execute_process(COMMAND ${awk} -f ${source}/scripts/check_file_lengths.awk ${scratch}/short.hpp ${scratch}/font_table.hpp
  OUTPUT_VARIABLE found_short RESULT_VARIABLE short)
execute_process(COMMAND ${awk} -f ${source}/scripts/check_file_lengths.awk ${scratch}/long.hpp ${scratch}/short.hpp ${scratch}/longer.hpp
  OUTPUT_VARIABLE found RESULT_VARIABLE long)
if(NOT short EQUAL 0 OR found_short OR NOT long EQUAL 1 OR NOT found MATCHES "long.hpp: 251 lines\n[^\n]*longer.hpp: 252 lines")
  message(FATAL_ERROR "scripts/check_file_lengths.awk does not distinguish long files from short ones: ${short} ${found_short} ${long} ${found}")
endif()
