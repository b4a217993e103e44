// For meshes that know little more than the verts of each polygon, or of each cell: build tables from those lists once, keep them beside the
// mesh, inherit from `indexed_surface` or `indexed_volume`, and say where the tables are:
//
//   template<> struct concino::mesh_traits<mine> : concino::indexed_surface<mine> {
//     static const concino::surface_tables<3>& tables(const mine& m) { return m.tables; }
//     static concino::vec3 point(const mine& m, concino::vert_id v) { ... }
//   };
//
// The tables are an object that the mesh's author owns and sees; after the lists change they must be built again. The library's own meshes
// are adapted by these very bases.
#pragma once

#include <concino/concepts/mesh_traits.hpp>

namespace concino {

namespace detail {

template<class M>
struct indexed_elements {
  using vert = vert_id;
  using edge = edge_id;
  using poly = poly_id;
  static constexpr bool edges_in_order = true;

  static auto verts(const M& m) { return mesh_traits<M>::tables(m).verts().all(); }
  static auto edges(const M& m) { return mesh_traits<M>::tables(m).edges().all(); }
  static auto polys(const M& m) { return mesh_traits<M>::tables(m).polys().all(); }
  static std::size_t num_verts(const M& m) { return mesh_traits<M>::tables(m).verts().size(); }
  static std::size_t num_edges(const M& m) { return mesh_traits<M>::tables(m).edges().size(); }
  static std::size_t num_polys(const M& m) { return mesh_traits<M>::tables(m).polys().size(); }
  static std::size_t vert_index_bound(const M& m) { return mesh_traits<M>::tables(m).verts().bound(); }
  static std::size_t edge_index_bound(const M& m) { return mesh_traits<M>::tables(m).edges().bound(); }
  static std::size_t poly_index_bound(const M& m) { return mesh_traits<M>::tables(m).polys().bound(); }
  static std::size_t index_of(const M&, vert_id v) { return v.raw(); }
  static std::size_t index_of(const M&, edge_id e) { return e.raw(); }
  static std::size_t index_of(const M&, poly_id p) { return p.raw(); }
  static bool contains(const M& m, vert_id v) { return mesh_traits<M>::tables(m).verts().contains(v); }
  static bool contains(const M& m, edge_id e) { return mesh_traits<M>::tables(m).edges().contains(e); }
  static bool contains(const M& m, poly_id p) { return mesh_traits<M>::tables(m).polys().contains(p); }

  static auto adj_v2v(const M& m, vert_id v) { return mesh_traits<M>::tables(m).adj_v2v(v); }
  static auto adj_v2e(const M& m, vert_id v) { return mesh_traits<M>::tables(m).adj_v2e(v); }
  static auto adj_v2p(const M& m, vert_id v) { return mesh_traits<M>::tables(m).adj_v2p(v); }
  static auto adj_e2v(const M& m, edge_id e) { return mesh_traits<M>::tables(m).adj_e2v(e); }
  static auto adj_e2p(const M& m, edge_id e) { return mesh_traits<M>::tables(m).adj_e2p(e); }
  static auto adj_p2v(const M& m, poly_id p) { return mesh_traits<M>::tables(m).adj_p2v(p); }
  static auto adj_p2e(const M& m, poly_id p) { return mesh_traits<M>::tables(m).adj_p2e(p); }
  static auto adj_p2p(const M& m, poly_id p) { return mesh_traits<M>::tables(m).adj_p2p(p); }
};

}  // namespace detail

/// tables(m) is a surface_tables.
template<class M>
struct indexed_surface : detail::indexed_elements<M> {
  static constexpr int dimension = 2;
};

/// tables(m) is a tet_tables, hex_tables or polyhedra_tables.
template<class M>
struct indexed_volume : detail::indexed_elements<M> {
  using base = detail::indexed_elements<M>;
  using face = face_id;
  static constexpr int dimension = 3;

  using base::contains;
  using base::index_of;
  static auto faces(const M& m) { return mesh_traits<M>::tables(m).faces().all(); }
  static std::size_t num_faces(const M& m) { return mesh_traits<M>::tables(m).faces().size(); }
  static std::size_t face_index_bound(const M& m) { return mesh_traits<M>::tables(m).faces().bound(); }
  static std::size_t index_of(const M&, face_id f) { return f.raw(); }
  static bool contains(const M& m, face_id f) { return mesh_traits<M>::tables(m).faces().contains(f); }

  static auto adj_v2f(const M& m, vert_id v) { return mesh_traits<M>::tables(m).adj_v2f(v); }
  static auto adj_e2f(const M& m, edge_id e) { return mesh_traits<M>::tables(m).adj_e2f(e); }
  static auto adj_f2v(const M& m, face_id f) { return mesh_traits<M>::tables(m).adj_f2v(f); }
  static auto adj_f2e(const M& m, face_id f) { return mesh_traits<M>::tables(m).adj_f2e(f); }
  static auto adj_f2p(const M& m, face_id f) { return mesh_traits<M>::tables(m).adj_f2p(f); }
  static auto adj_p2f(const M& m, poly_id p) { return mesh_traits<M>::tables(m).adj_p2f(p); }
  static bool face_is_outward(const M& m, poly_id p, face_id f) { return mesh_traits<M>::tables(m).face_is_outward(p, f); }
};

}  // namespace concino
