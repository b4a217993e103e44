# Builds and runs one consumer in a new folder, and checks what it must and must not get from the library.
set(here ${CMAKE_CURRENT_LIST_DIR})
file(REMOVE_RECURSE ${scratch})
file(MAKE_DIRECTORY ${scratch})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT code EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "failed: ${command}\n${said}")
  endif()
  set(said "${said}" PARENT_SCOPE)
endfunction()

function(expect_output said)
  file(READ ${here}/expected.txt expected)
  if(NOT said STREQUAL expected)
    message(FATAL_ERROR "the consumer printed\n${said}instead of\n${expected}")
  endif()
endfunction()

if(way STREQUAL "plain_dash_I")
  run(${compiler} -std=c++20 ${includes} ${here}/main.cpp -o ${scratch}/consumer)
  run(${scratch}/consumer)
  expect_output("${said}")
  return()
endif()

if(NOT DEFINED link)
  set(link concino)
endif()
# A unity build takes half the time.
set(arguments -DCONCINO_LINK=${link} -G ${generator} -DCMAKE_CXX_COMPILER=${compiler} -DCONCINO_SOURCE=${source} -DCMAKE_UNITY_BUILD=ON)
if(link STREQUAL "compiled")  # without optimisation, which this build has tried when it compiled the library itself
  list(APPEND arguments -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=)
endif()
if(way STREQUAL "find_package")
  set(prefix ${scratch}/prefix)
  run(${CMAKE_COMMAND} --install ${library_build} --prefix ${prefix})
  foreach(header IN ITEMS concepts/mesh_traits.hpp core/error.hpp core/detail/error.ipp)
    if(NOT EXISTS ${prefix}/include/concino/${header})
      message(FATAL_ERROR "concino/${header} is not installed in exactly one include folder")
    endif()
  endforeach()
  list(APPEND arguments -DCMAKE_PREFIX_PATH=${prefix})

  # If the compiled library is not installed, a message says so.
  if(link STREQUAL "compiled")
    file(REMOVE_RECURSE ${scratch}/header_only)
    file(COPY ${prefix}/ DESTINATION ${scratch}/header_only)
    file(GLOB_RECURSE of_library ${scratch}/header_only/*concino-compiled-config*.cmake)
    file(REMOVE ${of_library})
    execute_process(COMMAND ${CMAKE_COMMAND} -S ${here}/${way} -B ${scratch}/without_library ${arguments} -DCMAKE_PREFIX_PATH=${scratch}/header_only
      RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said)
    string(REGEX REPLACE "[ \n]+" " " words "${said}")
    if(code EQUAL 0 OR NOT words MATCHES "component 'compiled' was not built into this installation: configure concino with -DCONCINO_BUILD_COMPILED=ON")
      message(FATAL_ERROR "an installation without the compiled library does not say so:\n${said}")
    endif()
  endif()

  # The vocabulary needs no other library.
  run(${CMAKE_COMMAND} -S ${here}/concepts_only -B ${scratch}/concepts_only ${arguments}
    -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON -DCMAKE_DISABLE_FIND_PACKAGE_Boost=ON)
  run(${CMAKE_COMMAND} --build ${scratch}/concepts_only)

  # A component that was not built is an error that names it.
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${here}/missing_component -B ${scratch}/missing ${arguments}
    RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(code EQUAL 0 OR NOT said MATCHES "there is no component 'warp_drive'")
    message(FATAL_ERROR "the error of a missing component does not name it:\n${said}")
  endif()

  # Using a target whose component was not requested is an error that names the component.
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${here}/forgotten_component -B ${scratch}/forgotten ${arguments}
    RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said)
  string(REGEX REPLACE "[ \n]+" " " words "${said}")
  if(code EQUAL 0 OR NOT words MATCHES "consumer links to concino::span: .*find_package[(]concino REQUIRED COMPONENTS span[)]")
    message(FATAL_ERROR "the error of a component that was not requested does not name it:\n${said}")
  endif()
endif()
run(${CMAKE_COMMAND} -S ${here}/${way} -B ${scratch}/build ${arguments})
run(${CMAKE_COMMAND} --build ${scratch}/build)
run(${scratch}/build/consumer)
expect_output("${said}")

# As a subproject, concino adds no tests and no flags.
if(NOT way STREQUAL "find_package")
  run(${CMAKE_COMMAND} --build ${scratch}/build --target help)
  if(said MATCHES "tests_|example_|concino_program|all_headers")
    message(FATAL_ERROR "concino builds its own programs in the project of a user:\n${said}")
  endif()
  if(EXISTS ${scratch}/build/compile_commands.json)
    file(READ ${scratch}/build/compile_commands.json commands)
    if(commands MATCHES "-Werror|-Wconversion|-march")
      message(FATAL_ERROR "concino changes the flags of a user:\n${commands}")
    endif()
  endif()
endif()
