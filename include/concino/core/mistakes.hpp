// Parameter types of deleted functions. Compilers print their template argument: a sentence that says what to write
// instead. See mesh_traits.hpp, mesh.hpp.
//
//   template<class... T> void f(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
//
// The pack accepts explicit template arguments, as in f<vec3>(m), and `...` accepts any other arguments, braces too.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/concepts/mesh.hpp>

#include <concepts>
#include <initializer_list>
#include <type_traits>

namespace concino::mistake {

/// Converts from a mesh or graph whose verts have no coordinates.
template<sentence Remedy>
struct no_points {
  template<class M>
    requires(requirement::is_adapted<M> && !requirement::is_incomplete<M> && requirement::is_lvalue_or_view<const M&> &&
             requirement::has_vert<M> && !requirement::has_point<M>)
  no_points(const M&);
};
inline constexpr sentence give_points(
    "needs an Embedded mesh: write mesh_traits<M>::point(m, v), or call with with_points(m, map)");

/// Converts from a graph without polys or without points, which has no default discretisation.
template<sentence Remedy>
struct bare_graph {
  template<class M>
    requires(PrimalGraph<M> && !requirement::is_incomplete<M> && requirement::is_lvalue_or_view<const M&> &&
             !EmbeddedMesh<M>)
  bare_graph(const M&);
};
inline constexpr sentence name_discretisation(
    "the default discretisation needs polys and mesh_traits<M>::point(m, v): write what is missing, or name another, as in laplacian(m, uniform) or harmonic_map(m, values, uniform)");

/// Converts from a graph of polys alone that is not dual(m), for functions on verts.
template<sentence Remedy>
struct polys_alone {
  template<class M>
    requires(DualGraph<M> && !requirement::is_incomplete<M> && requirement::is_lvalue_or_view<const M&> &&
             !requirement::has_vert<M>)
  polys_alone(const M&);
};
inline constexpr sentence name_dual(
    "the graph has polys but no verts: pass dual(m), as in connected_components(dual(m))");

/// Converts from any mesh or graph.
struct any_mesh {
  template<class M>
    requires(requirement::is_adapted<M> && !requirement::is_incomplete<M>)
  any_mesh(const M&);
};

/// Converts from a number, or from a list of numbers or of pairs of them, where elements of a mesh are expected.
template<sentence Remedy>
struct number {
  struct and_value {
    int element;
    double value;
  };
  template<class I>
    requires(std::is_arithmetic_v<I>)
  number(const I&);
  template<class R>
    requires requires(const R& r) { requires std::is_arithmetic_v<std::remove_cvref_t<decltype(*r.begin())>>; }
  number(const R&);
  number(std::initializer_list<int>);
  number(std::initializer_list<and_value>);
};
inline constexpr sentence name_the_element(
    "elements of a mesh have types of their own: vert_id{0}, edge_id{0}, face_id{0} or poly_id{0}, not 0");

inline constexpr sentence give_numbers_at_verts("the map has to give a number at each vert: make_vert_map<double>(m)");
inline constexpr sentence give_numbers_or_points_at_verts(
    "the map has to give a number or a point at each vert: make_vert_map<double>(m)");
inline constexpr sentence give_vectors_at_polys("the field has to give a vector at each poly: make_poly_map<vec3>(m)");
inline constexpr sentence give_writable_numbers_at_verts(
    "the values change: pass the name of a property of verts, or a map of numbers that can be written, such as make_vert_map<double>(m)");
inline constexpr sentence give_line_start(
    "a line starts at a vert, a poly or a mesh_point, such as mesh_point<M>{edge_point<M>{e, 0.5}, position}");
inline constexpr sentence use_general_polys(
    "the parts of quads and hexes have other shapes: cut convert<polygonmesh>(m) or convert<polyhedralmesh>(m)");
inline constexpr sentence use_simplices("this is defined on triangles and tets: pass to_triangles(m) or to_tets(m)");
inline constexpr sentence give_labels_at_polys("the map has to give an int at each poly: make_poly_map<int>(m)");

}  // namespace concino::mistake
