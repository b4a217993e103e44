# Runs the program by mpirun: it ends with an error and says why, and does not wait for the process that has failed.
#   cmake -D run=<mpirun -n 3> -D program=<program> -D how=<argument> -D expected=<regular expression> -P failing_process.cmake
execute_process(COMMAND ${run} ${program} ${how} TIMEOUT 40 RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(code MATCHES "timeout")
  message(FATAL_ERROR "the processes wait for the one that has failed:\n${said}")
endif()
if(code EQUAL 0 OR NOT said MATCHES "${expected}")
  message(FATAL_ERROR "ended with ${code}, and does not say \"${expected}\":\n${said}")
endif()
