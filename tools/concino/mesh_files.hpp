// Reading and writing meshes, with messages and exit codes.
#pragma once

#include "commands.hpp"

#include <concino/io/load_any.hpp>

#include <string>

namespace program {

struct load_choices {
  bool corners_only = false, collapses_repeated_verts = false;
};
/// Reads a mesh of any kind. What the reader changed or skipped is written to the standard error stream.
concino::any_mesh load_mesh(const std::string& path, const load_choices& choices = {});

/// Whether a path ends with an extension, such as ".png", in upper or lower case.
bool has_extension(const std::string& path, const char* extension);

/// Writes a line to the standard error stream.
void say(const std::string& message);

/// Calls f; an exception of the library becomes a failure with this code.
template<class F>
decltype(auto) or_fail(exit_code code, const F& f) {
  try {
    return f();
  } catch (const concino::error& e) {
    throw failure{code, e.what()};
  }
}

}  // namespace program
