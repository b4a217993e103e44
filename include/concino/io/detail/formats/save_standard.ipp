// Bodies of save_standard.hpp: writes meshes in any of the library's formats.
#pragma once

#include <concino/io/detail/formats/save_standard.hpp>

#include <string>

namespace concino::detail {

template<int Dimension>
void save_standard(flat_mesh_source mesh, const std::string& path, const save_options& options) {
  save_flat<Dimension>(mesh, path, standard_formats, options);
}
template<int Dimension>
std::string standard_text(flat_mesh_source mesh, const save_options& options) {
  return flat_text<Dimension>(mesh, standard_formats, options);
}

#ifdef CONCINO_COMPILED
template void save_standard<2>(flat_mesh_source, const std::string&, const save_options&);
template void save_standard<3>(flat_mesh_source, const std::string&, const save_options&);
template std::string standard_text<2>(flat_mesh_source, const save_options&);
template std::string standard_text<3>(flat_mesh_source, const save_options&);
#endif

}  // namespace concino::detail
