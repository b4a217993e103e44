// Reads the input files of Abaqus and CalculiX, .inp: surfaces and volumes with sets.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/abaqus/abaqus_format.hpp>
#include <concino/io/detail/formats/load_with.hpp>

#ifndef CONCINO_COMPILED
#include <concino/io/detail/abaqus/read_abaqus.hpp>
#endif

namespace concino {

/// Reads a mesh from an Abaqus file, whatever its extension; no other format is compiled.
/// Needs:  Loadable M.
/// Result: as load.
/// Cost:   as load.
/// Errors: as load, except that any extension is accepted.
template<Loadable M>
M load_abaqus(const std::string& path, const load_options& options = {}) {
  return detail::load_with<M>(path, file_format::abaqus, options);
}

}  // namespace concino
