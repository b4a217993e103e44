# CONCINO_WITH_<NAME>=ON without the library: configuring fails and names the Debian package. OFF: it succeeds and leaves the adapter out.
string(TOUPPER ${adapter} upper)
function(configure with code said)
  file(REMOVE_RECURSE ${scratch})
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${source} -B ${scratch} -G ${generator} -D CMAKE_CXX_COMPILER=${compiler}
    -D CONCINO_WITH_${upper}=${with} -D CMAKE_DISABLE_FIND_PACKAGE_${package}=TRUE -D CONCINO_BUILD_TESTS=OFF -D CONCINO_BUILD_EXAMPLES=OFF -D CONCINO_BUILD_TOOLS=OFF
    RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
  set(${code} ${result} PARENT_SCOPE)
  string(REGEX REPLACE "[ \n]+" " " text "${text}")  # CMake wraps lines anywhere
  set(${said} "${text}" PARENT_SCOPE)
endfunction()

configure(ON code said)
if(code EQUAL 0 OR NOT said MATCHES "CONCINO_WITH_${upper}=ON, but ${package} was not found. On Debian: apt-get install ${debian}")
  message(FATAL_ERROR "CONCINO_WITH_${upper}=ON without ${package} ended with ${code}:\n${said}")
endif()
configure(AUTO code said)
if(NOT code EQUAL 0 OR NOT said MATCHES "concino::${adapter}: not found .${package}; Debian: ${debian}")
  message(FATAL_ERROR "CONCINO_WITH_${upper}=AUTO without ${package} ended with ${code}:\n${said}")
endif()
configure(OFF code said)
if(NOT code EQUAL 0 OR NOT said MATCHES "concino::${adapter}: off")
  message(FATAL_ERROR "CONCINO_WITH_${upper}=OFF ended with ${code}:\n${said}")
endif()
