# Configures concino with the reference BLAS, which makes CHOLMOD slow, and with a fast one: only the first causes a warning. Debian installs each in a
# folder of its name; here the libraries are empty files. Nothing is built.
file(REMOVE_RECURSE ${scratch})
foreach(row IN ITEMS "blas|TRUE" "openblas-serial|FALSE")
  string(REGEX MATCH "^(.*)[|](.*)$" _ ${row})
  set(folder ${CMAKE_MATCH_1})
  set(slow ${CMAKE_MATCH_2})
  file(WRITE ${scratch}/${folder}/libblas.so.3.11.0 "")
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${source} -B ${scratch}/build_${folder} -G ${generator} -DCMAKE_CXX_COMPILER=${compiler}
    -DCONCINO_BUILD_TOOLS=OFF -DCONCINO_BUILD_TESTS=OFF -DCONCINO_BUILD_EXAMPLES=OFF -DCHOLMOD_BLAS_LIBRARY=${scratch}/${folder}/libblas.so.3.11.0
    RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "concino cannot be configured:\n${said}")
  endif()
  set(warned FALSE)
  if(said MATCHES "reference BLAS.*libopenblas0-serial")
    set(warned TRUE)
  endif()
  if(NOT warned STREQUAL slow)
    message(FATAL_ERROR "beside ${folder}/libblas.so.3 a warning of a slow BLAS is expected: ${slow}, but is: ${warned}\n${said}")
  endif()
endforeach()
