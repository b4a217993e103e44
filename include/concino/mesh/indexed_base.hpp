// Base classes of mesh_traits for meshes that store little more than the verts of each polygon or cell. Build tables
// from those lists once, store them beside the mesh, inherit from `indexed_surface` or `indexed_volume`, and say where
// the tables are:
//
//   template<> struct concino::mesh_traits<mine> : concino::indexed_surface<mine> {
//     static const concino::surface_tables<3>& tables(const mine& m) { return m.tables; }
//     static concino::vec3 point(const mine& m, concino::vert_id v) { ... }
//   };
//
// The author of the mesh owns the tables and must build them again after the lists change. The native meshes are
// adapted by these same base classes. `arity` may be declared if the type of the tables fixes it: surface_tables<3>,
// tet_tables, hex_tables.
#pragma once

#include <concino/concepts/mesh.hpp>

namespace concino {

namespace requirement {

template<class M> concept has_tables = requires(const M& m) { mesh_traits<M>::tables(m); };
struct tables_requirement {
  template<class M> static constexpr bool holds = has_tables<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_result<requires { &mesh_traits<M>::tables; }, has_tables<M>, M>());
    static_assert(
        detail::missing<M>,
        "concino: mesh_traits<M> needs tables: static const auto& tables(const M&); the surface_tables, tet_tables, hex_tables or polyhedra_tables of the mesh");
  }
};

using indexed_base_requirements = list<tables_requirement>;

}  // namespace requirement

namespace detail {

/// The number of verts of every poly if the type of the tables fixes it, else 0.
template<class T> inline constexpr int arity_of_tables = 0;
template<class T>
  requires requires { T::arity; }
inline constexpr int arity_of_tables<T> = static_cast<int>(T::arity);

/// Whether tables(M) takes the mesh by value.
template<class M, class R> concept takes_a_copy = requires { static_cast<R (*)(M)>(&mesh_traits<M>::tables); };

// One line per message, so that compilers print it in one line.
// clang-format off
template<class M, class R>
consteval void check_tables() {
  if constexpr (!std::is_lvalue_reference_v<R>)
    static_assert(missing<M>, "concino: mesh_traits<M>::tables must return a reference, static const auto& tables(const M&): without the & adjacencies would be read from a copy of the mesh that no longer exists");
  else if constexpr (takes_a_copy<M, R>)
    static_assert(missing<M>, "concino: mesh_traits<M>::tables must take the mesh by reference, static const auto& tables(const M&): without the & it returns a reference into a copy that no longer exists");
  // the messages differ
  else if constexpr (arity_v<M> != 0 && arity_v<M> != arity_of_tables<std::remove_cvref_t<R>> && dimension_v<M> == 2)
    static_assert(missing<M>, "concino: mesh_traits<M>::arity needs tables(m) to be surface_tables<arity>: leave arity out, or use that type");
  else if constexpr (arity_v<M> != 0 && arity_v<M> != arity_of_tables<std::remove_cvref_t<R>>)  // the messages differ
    static_assert(missing<M>, "concino: mesh_traits<M>::arity = 4 needs tables(m) to be tet_tables, 8 hex_tables, whose lists keep the standard order of corners; polyhedra_tables do not: leave arity out, or use tet_tables or hex_tables");
}
// clang-format on

template<class M>
const auto& tables_of(const M& m) {
  check_tables<M, decltype(mesh_traits<M>::tables(m))>();
  return mesh_traits<M>::tables(m);
}

template<class M>
struct indexed_elements {
  using vert = vert_id;
  using edge = edge_id;
  using poly = poly_id;
  using base_requirements = requirement::bound<requirement::indexed_base_requirements, M>;

  // Concepts check verts first. It is missing if there are no tables, so that the other requirements are not checked. X
  // defers the check until mesh_traits<M> is complete.
  template<class X = M>
    requires requirement::has_tables<X>
  static auto verts(const M& m) { return detail::tables_of<M>(m).verts().all(); }
  template<class X = M>
    requires requirement::has_tables<X>
  static auto edges(const M& m) { return detail::tables_of<M>(m).edges().all(); }
  template<class X = M>
    requires requirement::has_tables<X>
  static auto polys(const M& m) { return detail::tables_of<M>(m).polys().all(); }
  static std::size_t num_verts(const M& m) { return detail::tables_of<M>(m).verts().size(); }
  static std::size_t num_edges(const M& m) { return detail::tables_of<M>(m).edges().size(); }
  static std::size_t num_polys(const M& m) { return detail::tables_of<M>(m).polys().size(); }
  static std::size_t vert_index_bound(const M& m) { return detail::tables_of<M>(m).verts().bound(); }
  static std::size_t edge_index_bound(const M& m) { return detail::tables_of<M>(m).edges().bound(); }
  static std::size_t poly_index_bound(const M& m) { return detail::tables_of<M>(m).polys().bound(); }
  static std::size_t index_of(const M&, vert_id v) { return v.raw(); }
  static std::size_t index_of(const M&, edge_id e) { return e.raw(); }
  static std::size_t index_of(const M&, poly_id p) { return p.raw(); }
  static bool contains(const M& m, vert_id v) { return detail::tables_of<M>(m).verts().contains(v); }
  static bool contains(const M& m, edge_id e) { return detail::tables_of<M>(m).edges().contains(e); }
  static bool contains(const M& m, poly_id p) { return detail::tables_of<M>(m).polys().contains(p); }

  static auto adj_v2v(const M& m, vert_id v) { return detail::tables_of<M>(m).adj_v2v(v); }
  static auto adj_v2e(const M& m, vert_id v) { return detail::tables_of<M>(m).adj_v2e(v); }
  static auto adj_v2p(const M& m, vert_id v) { return detail::tables_of<M>(m).adj_v2p(v); }
  static auto adj_e2v(const M& m, edge_id e) { return detail::tables_of<M>(m).adj_e2v(e); }
  static auto adj_e2p(const M& m, edge_id e) { return detail::tables_of<M>(m).adj_e2p(e); }
  static auto adj_p2v(const M& m, poly_id p) { return detail::tables_of<M>(m).adj_p2v(p); }
  static auto adj_p2e(const M& m, poly_id p) { return detail::tables_of<M>(m).adj_p2e(p); }
  static auto adj_p2p(const M& m, poly_id p) { return detail::tables_of<M>(m).adj_p2p(p); }
};

}  // namespace detail

/// tables(m) is a reference to a surface_tables.
template<class M>
struct indexed_surface : detail::indexed_elements<M> {
  static constexpr int dimension = 2;

};

/// tables(m) is a reference to a tet_tables, hex_tables or polyhedra_tables.
template<class M>
struct indexed_volume : detail::indexed_elements<M> {
  using base = detail::indexed_elements<M>;
  using face = face_id;
  static constexpr int dimension = 3;

  using base::contains;
  using base::index_of;
  template<class X = M>
    requires requirement::has_tables<X>
  static auto faces(const M& m) { return detail::tables_of<M>(m).faces().all(); }
  static std::size_t num_faces(const M& m) { return detail::tables_of<M>(m).faces().size(); }
  static std::size_t face_index_bound(const M& m) { return detail::tables_of<M>(m).faces().bound(); }
  static std::size_t index_of(const M&, face_id f) { return f.raw(); }
  static bool contains(const M& m, face_id f) { return detail::tables_of<M>(m).faces().contains(f); }

  static auto adj_v2f(const M& m, vert_id v) { return detail::tables_of<M>(m).adj_v2f(v); }
  static auto adj_e2f(const M& m, edge_id e) { return detail::tables_of<M>(m).adj_e2f(e); }
  static auto adj_f2v(const M& m, face_id f) { return detail::tables_of<M>(m).adj_f2v(f); }
  static auto adj_f2e(const M& m, face_id f) { return detail::tables_of<M>(m).adj_f2e(f); }
  static auto adj_f2p(const M& m, face_id f) { return detail::tables_of<M>(m).adj_f2p(f); }
  static auto adj_p2f(const M& m, poly_id p) { return detail::tables_of<M>(m).adj_p2f(p); }
  static bool face_is_outward(const M& m, poly_id p, face_id f) {
    return detail::tables_of<M>(m).face_is_outward(p, f);
  }
};

}  // namespace concino
