// Bodies of load_standard.hpp: reads files and texts in any of the library's formats.
#pragma once

#include <concino/io/detail/formats/load_standard.hpp>

#include <cstddef>
#include <string>
#include <string_view>

#ifdef CONCINO_COMPILED
#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/mesh/trimesh.hpp>
#endif

namespace concino::detail {

template<bool Surfaces, bool Volumes, class Contents>
void read_standard_file(const std::string& path, const wanted_mesh& wanted, const load_options& options,
                        Contents& contents) {
  read_file<Surfaces, Volumes>(path, standard_formats, wanted, options, contents);
}
template<bool Surfaces, bool Volumes, class Contents>
void read_standard_text(std::string_view text, std::string_view name, const wanted_mesh& wanted,
                        const load_options& options, Contents& contents) {
  constexpr format_rows known = format_rows_of(standard_formats);
  const std::size_t chosen =
      choose_format(readable(name, candidates_for({}, standard_formats, options.format), known), known, &text);
  read_text<Surfaces, Volumes>(text, name, standard_formats, chosen, wanted, options, contents);
}

#ifdef CONCINO_COMPILED

#define CONCINO_DEFINE_READERS(SURFACES, VOLUMES, CONTENTS)                                             \
  template void read_standard_file<SURFACES, VOLUMES, CONTENTS>(const std::string&, const wanted_mesh&, \
                                                                const load_options&, CONTENTS&);        \
  template void read_standard_text<SURFACES, VOLUMES, CONTENTS>(std::string_view, std::string_view,     \
                                                                const wanted_mesh&, const load_options&, CONTENTS&)
CONCINO_DEFINE_READERS(true, false, file_contents);
CONCINO_DEFINE_READERS(false, true, volume_contents);
CONCINO_DEFINE_READERS(true, true, volume_contents);
#undef CONCINO_DEFINE_READERS

template<class M>
M make_precompiled_from_file(const std::string& path, const load_options& options) {
  return make_from_standard_file<M>(path, options);
}
template<class M>
M make_precompiled_from_text(std::string_view text, std::string_view name, const load_options& options) {
  return make_from_standard_text<M>(text, name, options);
}

#define CONCINO_DEFINE_LOADERS(MESH)                                                          \
  template MESH make_precompiled_from_file<MESH>(const std::string&, const load_options&); \
  template MESH make_precompiled_from_text<MESH>(std::string_view, std::string_view, const load_options&)
CONCINO_DEFINE_LOADERS(trimesh);
CONCINO_DEFINE_LOADERS(quadmesh);
CONCINO_DEFINE_LOADERS(polygonmesh);
CONCINO_DEFINE_LOADERS(tetmesh);
CONCINO_DEFINE_LOADERS(hexmesh);
CONCINO_DEFINE_LOADERS(polyhedralmesh);
#undef CONCINO_DEFINE_LOADERS

#endif

}  // namespace concino::detail
