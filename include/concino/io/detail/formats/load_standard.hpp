// Reads files and texts in any of the library's formats. The wanted kind of mesh is an argument, not a type, so these
// functions are part of the compiled library. It also contains the functions that load native meshes.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/precompiled.hpp>
#include <concino/io/detail/formats/load_with.hpp>
#include <concino/io/formats.hpp>

#include <string>
#include <string_view>
#include <type_traits>

namespace concino::detail {

/// The same as read_file and read_text, with standard_formats.
template<bool Surfaces, bool Volumes, class Contents>
void read_standard_file(const std::string& path, const wanted_mesh& wanted, const load_options& options,
                        Contents& contents);
template<bool Surfaces, bool Volumes, class Contents>
void read_standard_text(std::string_view text, std::string_view name, const wanted_mesh& wanted,
                        const load_options& options, Contents& contents);

template<class M>
using standard_contents = contents_for<M, std::remove_const_t<decltype(standard_formats)>>;

template<class M>
M make_from_standard_file(const std::string& path, const load_options& options) {
  standard_contents<M> contents;
  read_standard_file<from_surface<M>, wants_volumes<M>>(path, wanted_for<M>, options, contents);
  return mesh_of<M>(contents, path, options.report);
}
template<class M>
M make_from_standard_text(std::string_view text, std::string_view name, const load_options& options) {
  standard_contents<M> contents;
  read_standard_text<from_surface<M>, wants_volumes<M>>(text, name, wanted_for<M>, options, contents);
  return mesh_of<M>(contents, name, options.report);
}

/// The same as make_from_standard_file for a native mesh, defined in the compiled library only.
template<class M>
M make_precompiled_from_file(const std::string& path, const load_options& options);
template<class M>
M make_precompiled_from_text(std::string_view text, std::string_view name, const load_options& options);

template<class M>
M load_standard(const std::string& path, const load_options& options) {
  const core::profiled_options profiled(options, "load");
  if constexpr (core::is_precompiled<M>) return make_precompiled_from_file<M>(path, *profiled);
  else return make_from_standard_file<M>(path, *profiled);
}
template<class M>
M load_standard_text(std::string_view text, std::string_view name, const load_options& options) {
  const core::profiled_options profiled(options, "load_text");
  if constexpr (core::is_precompiled<M>) return make_precompiled_from_text<M>(text, name, *profiled);
  else return make_from_standard_text<M>(text, name, *profiled);
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/formats/load_standard.ipp>
#endif
