// The one way in: specialise `mesh_traits` for a mesh type and every algorithm of the library runs on it.
//
// What a specialisation says (all static; only what the wanted concept lists is needed, see the concept headers):
//
//   using vert = ...; edge, face, poly       descriptor types, std::regular, all different
//   dimension                                2: surface, 3: volume
//   arity                                    verts of every poly, where that is fixed
//   is_view                                  true: cheap to copy, does not own what it shows (maps then keep a copy of it)
//   verts(m) num_verts(m) vert_index_bound(m) index_of(m, v)    and the same for edges, faces, polys
//   adj_v2v(m, v) ...                        neighbours: a2b gives the b's of one a
//   face_is_outward(m, p, f)                 seen from outside poly p, f's verts run counter-clockwise
//   point(m, v) set_point(m, v, x)           coordinates
//   contains(m, x)                           optional: is x an element now, in constant time
//   edges_in_order                           optional: static constexpr bool, see mesh_requirements.hpp
//
// Include the adapter, or specialise, before anything asks about the type: an algorithm called, a concept named. A specialisation for one
// type that comes later is an error. So is a later one for many types, as adapters have, with g++; clang++ takes it without a word, but keeps
// the answer "no" for the types that were asked about.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/concepts/ranges.hpp>

/// What all of explain_... say about a type of which nothing is known: the commonest reason is a forgotten adapter.
#define CONCINO_NO_TRAITS                                                                                                                   \
  "no mesh_traits<M>: include the adapter of the library that M is from, <concino/adapters/...>: boost_graph.hpp, cgal_polyhedron.hpp, "     \
  "cgal_surface_mesh.hpp, cgal_triangulation.hpp, cgal_lcc.hpp, eigen.hpp, openmesh.hpp, span.hpp; or specialise concino::mesh_traits for M"

namespace concino {

/// Nothing is known about the type: every question is answered "no", none is an error.
struct no_traits {};

template<class M>
struct mesh_traits : no_traits {};

template<class M>
using traits = mesh_traits<std::remove_cvref_t<M>>;

template<class M> using vert_t = typename traits<M>::vert;
template<class M> using edge_t = typename traits<M>::edge;
template<class M> using face_t = typename traits<M>::face;
template<class M> using poly_t = typename traits<M>::poly;

namespace requirement {

// What stands behind the concept is there to be read in the compiler's message.
template<class M>
concept is_adapted = !std::is_base_of_v<no_traits, traits<M>>;  // else include <concino/adapters/openmesh.hpp> or a sibling, or specialise mesh_traits

}  // namespace requirement

namespace detail {

/// False, but only once M is known: what the assertions of explain_primal_graph<M>() and its siblings stand on.
template<class M> inline constexpr bool missing = false;

template<class T> struct dimension_of : std::integral_constant<int, 0> {};
template<class T>
  requires requires { T::dimension; }
struct dimension_of<T> : std::integral_constant<int, T::dimension> {};

template<class T> struct arity_of : std::integral_constant<int, 0> {};
template<class T>
  requires requires { T::arity; }
struct arity_of<T> : std::integral_constant<int, T::arity> {};

template<class T> struct view_of : std::false_type {};
template<class T>
  requires requires { T::is_view; }
struct view_of<T> : std::bool_constant<T::is_view> {};

}  // namespace detail

/// 2 for surfaces, 3 for volumes, 0 where the traits do not say.
template<class M> inline constexpr int dimension_v = detail::dimension_of<traits<M>>::value;
/// Verts of every poly where the type fixes it, else 0.
template<class M> inline constexpr int arity_v = detail::arity_of<traits<M>>::value;
/// Whether M shows another mesh rather than owning one.
template<class M> inline constexpr bool is_view_v = detail::view_of<traits<M>>::value;

}  // namespace concino

#include <concino/concepts/verbs.hpp>
