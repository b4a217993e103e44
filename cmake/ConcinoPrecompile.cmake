# concino_precompile(<target> [<header>...]): compiles what most programs include once for all files of the target, with its flags: the headers that
# are named, without any those of meshes, of reading and writing files and of harmonic maps. It pays with concino::compiled.
include_guard(GLOBAL)

function(concino_precompile target)
  set(headers ${ARGN})
  if(NOT headers)
    set(headers <concino/mesh.hpp> <concino/io.hpp> <concino/fields/harmonic_map.hpp>)
  endif()
  target_precompile_headers(${target} PRIVATE ${headers})
endfunction()
