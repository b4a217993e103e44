# If the environment says so, test programs record the errors that they throw. docs/messages.awk makes a page of the records.
#   cmake -D source=<repository> -D program=<tests_core> -D scratch=<folder> -P recorded_messages.cmake
find_program(awk NAMES mawk gawk awk REQUIRED)
file(REMOVE_RECURSE ${scratch})
file(MAKE_DIRECTORY ${scratch}/records)

# run(<folder or nothing>): runs the tests of core/error_test.cpp, recording in that folder.
function(run folder)
  set(ENV{CONCINO_TEST_MESSAGES} "${folder}")
  execute_process(COMMAND ${program} --source-file=*core/error_test.cpp RESULT_VARIABLE code OUTPUT_VARIABLE text WORKING_DIRECTORY ${scratch})
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "core/error_test.cpp fails with CONCINO_TEST_MESSAGES=${folder}:\n${text}")
  endif()
endfunction()

# expect(<what> <text> <wanted text>)
function(expect what text wanted)
  if(NOT text STREQUAL wanted)
    message(FATAL_ERROR "${what} should be\n${wanted}\nbut is\n${text}")
  endif()
endfunction()

run("")
run(${scratch}/absent)
file(GLOB_RECURSE files RELATIVE ${scratch} ${scratch}/*)
expect("what is written without a folder" "${files}" "")
run(${scratch}/records)
file(GLOB files ${scratch}/records/*.tsv)
file(READ ${files} text)
set(wanted "")
foreach(type IN ITEMS invalid_mesh invalid_argument solver_error unsupported io_error cancelled)
  string(APPEND wanted "core/error_test.cpp\tevery error is a concino::error with its message\t${type}\twhat happened\n")
endforeach()
string(APPEND wanted "core/error_test.cpp\ta parse error names file, line, what was expected and what was found\tparse_error\t"
  "a.obj:7: expected a number, found 'x'\n")
expect("the record of core/error_test.cpp" "${text}" "${wanted}")

# page(<variable> <records>): what messages.awk prints of these records, without the introduction.
function(page variable records)
  string(REPLACE " -> " "\t" records "${records}")
  file(WRITE ${scratch}/some.tsv "${records}")
  execute_process(COMMAND ${awk} -f ${source}/docs/messages.awk ${scratch}/some.tsv OUTPUT_VARIABLE text ERROR_VARIABLE wrong)
  string(REGEX REPLACE "^# Error messages[^#]*" "" text "${text}")
  set(${variable} "${wrong}${text}" PARENT_SCOPE)
endfunction()

set(head "\n\n| message | type | provoked by |\n|---|---|---|\n")
set(records "geometry/camera_test.cpp -> angles -> invalid_argument -> camera: the angle is 190; it must be below 180
geometry/camera_test.cpp -> no angle -> invalid_argument -> camera: the angle is nan; it must be below 180
io/fuzz_test.cpp -> any bytes -> parse_error -> /tmp/concino_test_Ab3xYz/a:7: expected x, found 'a|b'
io/obj_test.cpp -> lines -> parse_error -> some.obj:12: expected x, found the end of the line
io/obj_test.cpp -> lines -> parse_error -> some.obj:12: expected x, found vert 3 twice
io/obj_test.cpp -> lines -> io_error -> /tmp/concino_test_Ab3xYz/b.obj: cannot be read: it is `c|d`\\x5c
core/error_test.cpp -> made up -> invalid_mesh -> what happened
")
set(camera "| `camera: the angle is 190; it must be below 180` | invalid_argument | `geometry/camera_test.cpp`: angles |\n")
set(files "| `FILE: cannot be read: it is \\x60c\\|d\\x60\\` | io_error | `io/obj_test.cpp`: lines |
| `FILE:LINE: expected x, found the end of the line` | parse_error | `io/obj_test.cpp`: lines |
| `FILE:LINE: expected x, found vert 3 twice` | parse_error | `io/obj_test.cpp`: lines |
")
page(text "${records}")
expect("the page" "${text}" "## Files${head}${files}\n## geometry${head}${camera}")
