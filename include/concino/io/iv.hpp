// Reads .iv, Open Inventor files in ASCII.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/formats/load_with.hpp>
#include <concino/io/detail/iv/iv_format.hpp>

#ifndef CONCINO_COMPILED
#include <concino/io/detail/iv/read_iv.hpp>
#endif

namespace concino {

/// Reads a mesh from an Open Inventor file, whatever its extension; no other format is compiled.
/// Needs:  Loadable M, a surface.
/// Result: as load.
/// Cost:   as load.
/// Errors: as load, except that any extension is accepted.
template<Loadable M>
M load_iv(const std::string& path, const load_options& options = {}) {
  return detail::load_with<M>(path, file_format::iv, options);
}

}  // namespace concino
