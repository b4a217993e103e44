# Writes the batches of a folder of tests (tests/batches.cmake), for scripts that compile tests themselves, into <working folder>/batches, and prints a line
# with the path of each.
# usage: cmake -D tests=<folder of tests> [-D CONCINO_TEST_BATCH_SIZE=<bytes>] -P test_batches.cmake
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../tests/batches.cmake)
set(CONCINO_TEST_BATCHES ON)
file(GLOB_RECURSE files ${tests}/*_test.cpp)
list(FILTER files EXCLUDE REGEX "_long_test\\.cpp$")
cmake_path(GET tests FILENAME name)
concino_batches(sources ${name} ${files})
foreach(source IN LISTS sources)
  execute_process(COMMAND ${CMAKE_COMMAND} -E echo ${source})
endforeach()
