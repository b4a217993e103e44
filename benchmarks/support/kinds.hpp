// The data sets that are read from files, each with its mesh type, its floor and the construction of both from arrays.
#pragma once

#include "program.hpp"

#include <concino/mesh.hpp>

namespace bench {

// A kind has the members mesh (the library's type), write(arrays, path), read(path) (the floor), flat(arrays) and build(flat) (the floor without the file).

template<u32 K, class M>
struct surface_kind {
  using mesh = M;
  static constexpr const char* ending = ".obj";
  static void write(const surface_arrays& a, const std::string& path) { write_obj(a, path); }
  static auto read(const std::string& path) { return floors::read_obj<K>(path); }
  static auto flat(const surface_arrays& a) { return flat_surface<K>(a); }
};

template<class S, class M>
struct cell_kind {
  using mesh = M;
  static constexpr const char* ending = ".mesh";
  static void write(const cell_arrays& a, const std::string& path) { write_mesh(a, path); }
  static auto read(const std::string& path) { return floors::read_mesh<S>(path); }
  static auto flat(const cell_arrays& a) { return flat_cells<S>(a); }
};

struct polyhedral_kind {
  using mesh = concino::polyhedralmesh;
  static constexpr const char* ending = ".hedra";
  static void write(const polyhedra_arrays& a, const std::string& path) { write_hedra(a, path); }
  static auto read(const std::string& path) { return floors::read_hedra(path); }
  static auto flat(const polyhedra_arrays& a) { return flat_polyhedra(a); }
};

/// Writes every data set that `p` wants for one of `works` ("load", ...) to a file, and calls visit(name, path, arrays, kind) for it.
template<class F>
void for_each_file(const program& p, std::initializer_list<const char*> works, F&& visit) {
  const auto with = [&](auto kind, const std::string& name, auto make) {
    bool wanted = false;
    for (const char* work : works) wanted = wanted || p.wants(work + ("." + name));
    if (!wanted) return;
    const auto arrays = make(p.data);
    const std::string path = p.file(name + kind.ending);
    kind.write(arrays, path);
    visit(name, path, arrays, kind);
    std::filesystem::remove(path);
  };
  with(surface_kind<3, concino::trimesh>{}, "bunny", [](const data_sets& d) { return d.bunny(); });
  with(surface_kind<3, concino::trimesh>{}, "tri1m", [](const data_sets& d) { return d.tri1m(); });
  with(surface_kind<0, concino::polygonmesh>{}, "poly228k", [](const data_sets& d) { return d.poly228k(); });
  with(surface_kind<4, concino::quadmesh>{}, "quad343k", [](const data_sets& d) { return d.quad343k(); });
  with(cell_kind<floors::tet_shape, concino::tetmesh>{}, "tet1m", [](const data_sets& d) { return d.tet1m(); });
  with(cell_kind<floors::hex_shape, concino::hexmesh>{}, "hex1m", [](const data_sets& d) { return d.hex1m(); });
  with(polyhedral_kind{}, "hex216k", [](const data_sets& d) { return d.hex216k(); });
  with(polyhedral_kind{}, "dual200k", [](const data_sets& d) { return d.dual200k(); });
}

}  // namespace bench
