# Installs the library, builds every_function/ against it without optimisation, and runs the program in a scratch folder.
set(here ${CMAKE_CURRENT_LIST_DIR})
file(REMOVE_RECURSE ${scratch})
file(MAKE_DIRECTORY ${scratch}/files)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said WORKING_DIRECTORY ${scratch}/files)
  if(NOT code EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "failed: ${command}\n${said}")
  endif()
  set(said "${said}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${library_build} --prefix ${scratch}/prefix)
# A batch of a unity build shares the headers. Batches stay small, for the memory of the compiler.
run(${CMAKE_COMMAND} -S ${here}/every_function -B ${scratch}/build -G ${generator} -DCMAKE_CXX_COMPILER=${compiler} -DCMAKE_PREFIX_PATH=${scratch}/prefix
  -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG= -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=3)
run(${CMAKE_COMMAND} --build ${scratch}/build)
run(${scratch}/build/consumer)
message(STATUS "${said}")
