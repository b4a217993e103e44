# Installs the library, builds the folder `component` against it, which asks find_package for that component, and runs the program by `run`, if given. It prints
# `expected`. Others get nothing of MPI.
set(here ${CMAKE_CURRENT_LIST_DIR})
file(REMOVE_RECURSE ${scratch})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE errors)
  if(NOT code EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "failed: ${command}\n${said}${errors}")
  endif()
  set(said "${said}" PARENT_SCOPE)
endfunction()

set(arguments -G ${generator} -DCMAKE_CXX_COMPILER=${compiler} -DCMAKE_PREFIX_PATH=${scratch}/prefix -DCONCINO_LINK=concino)
run(${CMAKE_COMMAND} --install ${library_build} --prefix ${scratch}/prefix)
run(${CMAKE_COMMAND} -S ${here}/${component} -B ${scratch}/build ${arguments})
run(${CMAKE_COMMAND} --build ${scratch}/build)
run(${run} ${scratch}/build/consumer)
if(NOT said STREQUAL "${expected}\n")
  message(FATAL_ERROR "the program printed\n${said}instead of\n${expected}")
endif()

run(${CMAKE_COMMAND} -S ${here}/find_package -B ${scratch}/other ${arguments})
file(READ ${scratch}/other/compile_commands.json commands)
file(READ ${scratch}/other/build.ninja links)
if("${commands}${links}" MATCHES "libpetsc|petscdir|libmpi|openmpi|mpich|OMPI_")
  message(FATAL_ERROR "a program that asks for concino alone is compiled or linked with ${CMAKE_MATCH_0}")
endif()
