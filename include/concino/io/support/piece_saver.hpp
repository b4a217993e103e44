// Saves one piece of a mesh, as each process of a parallel program does, and with the first piece the .pvtu file.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/files/folder_files.hpp>
#include <concino/io/detail/formats/save_with.hpp>
#include <concino/mesh/property_set.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace concino::core {

/// Piece k of n of m.pvtu is m_k.vtu. Its files get their names in commit(); until then the folder stays as it was.
class piece_saver {
  std::string path_, folder_, file_name_;
  std::size_t piece_, num_pieces_;
  detail::folder_files files_;

  void write_flat(detail::flat_mesh_source mesh, std::span<const std::uint32_t> polys,
                  std::span<const std::uint32_t> more_verts, const property_set& properties,
                  const save_options& options);

 public:
  /// Errors: io_error if there is no folder and none can be created.
  piece_saver(const std::string& path, std::size_t k, std::size_t n, bool sync);

  /// Writes some polys of a mesh, in increasing order, and their verts, and more verts.
  /// Needs:  properties by index of the elements of the mesh, the same for all pieces.
  /// Errors: as save_vtu; invalid_argument for options.as_boundary.
  template<class M>
  void write(const M& m, std::span<const std::uint32_t> polys, std::span<const std::uint32_t> more_verts,
             const property_set& properties, const save_options& options) {
    write_flat(detail::visitable_mesh<M>{m}, polys, more_verts, properties, options);
  }
  void commit() { files_.commit(); }
};

}  // namespace concino::core

#ifndef CONCINO_COMPILED
#include <concino/io/detail/pvtu/piece_saver.ipp>
#endif
