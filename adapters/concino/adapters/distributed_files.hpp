// Saves a distributed mesh in pieces, one for each process: save_pvtu(d, "m.pvtu", {{"temperature", u}}).
// Needs: MPI (Debian: petsc-dev brings it; libopenmpi-dev).
#pragma once

#include <concino/adapters/detail/distributed/distributed_piece.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/core/vec3.hpp>
#include <concino/io/support/piece_saver.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/mesh/property_set.hpp>

#include <mpi.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

/// A map of verts or polys of a distributed mesh and its name in a file, as in {"temperature", u}. It refers to the
/// map.
/// Needs:  numbers or vec3.
template<class M>
class named_values {
  std::string name_;
  element_kind kind_;
  const distributed<M>* mesh_;
  std::function<void(property_set&)> store_;

 public:
  template<class X, class T>
    requires((std::is_same_v<X, vert_t<M>> ||
              std::is_same_v<X, poly_t<M>>)&&(std::is_same_v<T, vec3> ||
                                              (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>)))
  named_values(std::string name, const element_map<distributed<M>, X, T>& map)
      : name_(std::move(name)), kind_(std::is_same_v<X, vert_t<M>> ? element_kind::vert : element_kind::poly),
        mesh_(&map.mesh()) {
    store_ = [name = name_, kind = kind_, &map](property_set& all) {
      all.remove(kind, name);
      auto* const values = static_cast<T*>(all.get(kind, name, detail::values_of<T>, map.values().size())->data());
      for (std::size_t i = 0; i < map.values().size(); ++i) values[i] = map.values()[i];
    };
  }

  const std::string& name() const { return name_; }
  element_kind kind() const { return kind_; }
  const distributed<M>& mesh() const { return *mesh_; }
  /// Copies the values to a property, which replaces one of the same name.
  void store(property_set& all) const { store_(all); }
};

/// Saves a distributed mesh: each process writes its polys, and the first one the .pvtu file that names the pieces. All
/// processes call it together, and see the same folder.
/// Needs:  a distributed mesh, with the same properties on all processes; values: maps of it, with the same names in
///         the same order on all processes. Values of ghosts are not used.
/// Result: for m.pvtu, the pieces m_0.vtu, m_1.vtu, ... in the same folder, one for each process, empty if it has no
///         polys. load_pvtu restores the whole mesh in its order, by the numbers "global_id" (std::int64_t) of verts
///         and polys. Their processes are in "owner" (int). The files get their names when all are written, that of the
///         .pvtu file last. The named properties of verts, polys and the mesh are saved too, if .vtu files can hold
///         them and no map has the name; remove_property(d, kind, name) before leaves one out. progress and report are
///         those of the process.
/// Cost:   as save_vtu for the part, and a copy of the values.
/// Errors: as save_vtu. invalid_argument for options.as_boundary; for names that are repeated, reserved or different
///         between processes; for a map of another mesh. Every error is thrown on all processes; until the files get
///         their names, the folder is then as it was.
template<class M>
void save_pvtu(const distributed<M>& m, const std::string& path, const std::vector<named_values<M>>& values = {},
               const save_options& options = {}) {
  const MPI_Comm all = m.communicator();
  int size = 1;
  (MPI_Comm_size)(all, &size);
  detail::check_named_values(m, values);
  detail::piece_of_process piece;
  detail::on_all(all, [&] {
    piece = detail::local_piece(m);
    for (const named_values<M>& v : values) v.store(piece.properties);
  });
  detail::update_ghosts(m, piece.properties);
  std::optional<core::piece_saver> saver;
  for (const bool is_first : {true, false})  // the first process creates the folder
    detail::on_all(all, [&] {
      if (is_first == (m.rank() == 0))
        saver.emplace(path, static_cast<std::size_t>(m.rank()), static_cast<std::size_t>(size), options.sync);
    });
  detail::on_all(all, [&] { saver->write(m.base(), piece.polys, piece.loose_verts, piece.properties, options); });
  for (const bool is_first : {false, true})
    detail::on_all(all, [&] {
      if (is_first == (m.rank() == 0)) saver->commit();
    });
}

}  // namespace concino
