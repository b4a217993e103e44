// mesh_traits: the customisation point for mesh types. Specialise it for a mesh type, and every algorithm of the
// library runs on that type.
//
// These are all members that any code of the library looks up; tests/headers/traits_members.cmake compares. All are
// static. x is an element of any kind.
//
// Needed, those that the concept in question lists (see the concept headers):
//   vert edge face poly                      descriptor types, std::regular, all different
//   dimension                                2: surface, 3: volume
//   verts edges faces polys                  (m): the elements of one kind
//   num_verts num_edges num_faces num_polys  (m): how many these are
//   vert_index_bound edge_index_bound face_index_bound poly_index_bound    (m): exclusive bounds of index_of
//   index_of                                 (m, x)
//   adj_v2v adj_v2e adj_v2f adj_v2p          (m, v): adjacencies; a2b returns the b's of one a
//   adj_e2v adj_e2f adj_e2p                  (m, e)
//   adj_f2v adj_f2e adj_f2p                  (m, f)
//   adj_p2v adj_p2e adj_p2f adj_p2p          (m, p)
//   face_is_outward                          (m, p, f): whether f's verts run counter-clockwise seen from outside p
//   point                                    (m, v): coordinates
//
// Editing (see <concino/concepts/editable.hpp>, <concino/edit.hpp> and docs/adapt-advanced.md):
//   set_point                                (m, v, x)
//   rewire                                   (m, c, made): replaces polys by others
//   why_not_rewire                           (m, c): why the library of m cannot represent what rewire(m, c, made)
//                                            would make; null if it can
//   split_edge flip_edge collapse_edge       operators of the mesh's own
//   add_vert add_face add_poly remove_vert remove_face remove_poly    single elements
//   reserve_removal                          (m, polys): allocates the memory for their removal
//   garbage_collect                          (m): numbers the elements without gaps
//   edits edits_if_any                       (m): the state of transactions; the second is null until there was one
//
// Optional, they refine what a mesh means:
//   arity                                    the number of verts of every poly, if that is fixed
//   is_view                                  true: cheap to copy, does not own its elements (maps then keep a copy of
//                                            it)
//   contains                                 (m, x): whether x is an element of m now, in constant time
//   edges_in_order                           false if adj_p2e or adj_f2e violates SM7 or VM8: then the verbs sort
//   properties                               (m): named properties, see <concino/mesh/property.hpp>
//   first_corner corner_index_bound          (m, p), (m): numbers of corners, for properties of these
//   number_in_messages                       (m, x): how messages name a vert or poly of a part of a larger mesh;
//                                            otherwise by index_of
//   base_requirements                        what a base class of the traits needs, see below
//   tables                                   (m): for indexed_surface and indexed_volume, the base classes of
//                                            <concino/mesh/indexed_base.hpp>
//   halfedge_links                           for halfedge_kernel: the traits with the links, which have laws of their
//                                            own
//   precompiled                              the meshes of this library: the name of the mesh, for which
//                                            concino::compiled has algorithms
//
// Include the adapter, or specialise, before the first use of the type with this library: a call of an algorithm, a
// check of a concept. A later specialisation for one type is an error. So is a later one for many types, as adapters
// have, with g++; clang++ accepts it without a warning, but the types used before still model no concept.
#pragma once

#include <concino/concepts/cavity.hpp>
#include <concino/concepts/descriptors.hpp>
#include <concino/concepts/ranges.hpp>
#include <concino/concepts/requirement.hpp>

namespace concino {

/// The base of mesh_traits that are not specialised: the type models no concept, and asking is not an error.
struct no_traits {};

template<class M>
struct mesh_traits : no_traits {};

template<class M>
using traits = mesh_traits<std::remove_cvref_t<M>>;

template<class M> using vert_t = typename traits<M>::vert;
template<class M> using edge_t = typename traits<M>::edge;
template<class M> using face_t = typename traits<M>::face;
template<class M> using poly_t = typename traits<M>::poly;

/// What the verb `rewire` replaces in a mesh of type M, and where it writes the descriptors of new elements.
template<class M> using cavity = cavity_of<vert_t<M>, poly_t<M>>;
template<class M> using cavity_result = cavity_result_of<vert_t<M>, poly_t<M>>;

namespace requirement {

// A comment on the same line, since compilers print that line in their message.
template<class M>
concept is_adapted = !std::is_base_of_v<no_traits, traits<M>>;  // else include <concino/adapters/openmesh.hpp> or another adapter, or specialise mesh_traits
// The most common reason is a missing adapter.
struct adapted_requirement {
  template<class M> static constexpr bool holds = is_adapted<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::missing<M>, "concino: no mesh_traits<M>: include the adapter of the library that M is from, <concino/adapters/...>: boost_graph.hpp, cgal_polyhedron.hpp, cgal_surface_mesh.hpp, cgal_triangulation.hpp, cgal_lcc.hpp, eigen.hpp, openmesh.hpp, span.hpp; or specialise concino::mesh_traits for M");
  }
};

// A base class of traits that has its own requirements, such as halfedge_kernel, declares
//   using base_requirements = requirement::bound<...>;
template<class M> concept has_base_requirements = requires { typename traits<M>::base_requirements; };
struct base_requirement {
  template<class M> static constexpr bool holds = true;  // if the traits have no such base; else see below
};
template<has_base_requirements M>
struct check<base_requirement, M> : std::bool_constant<traits<M>::base_requirements::template holds<M>> {
  using first_missing = typename traits<M>::base_requirements;
};

/// The first requirements of every list on mesh_traits. Without those of the base nothing else holds, so they are
/// explained first.
using traits_requirements = list<adapted_requirement, base_requirement>;

}  // namespace requirement

namespace detail {

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

/// 2 for surfaces, 3 for volumes, 0 if the traits have no dimension.
template<class M> inline constexpr int dimension_v = detail::dimension_of<traits<M>>::value;
/// The number of verts of every poly if the type fixes it, else 0.
template<class M> inline constexpr int arity_v = detail::arity_of<traits<M>>::value;
/// Whether M is a view of another mesh and does not own its elements.
template<class M> inline constexpr bool is_view_v = detail::view_of<traits<M>>::value;

namespace requirement {

/// An argument that a result may refer to after the call: an lvalue, or a view, which is copied. Functions that return
/// maps require this of their mesh, so that a call with a temporary mesh does not compile, instead of leaving a
/// dangling pointer.
template<class M> concept is_lvalue_or_view = std::is_lvalue_reference_v<M> || is_view_v<M>;

}  // namespace requirement

/// Parameter types of deleted functions, with a text that says what to write instead of a call that cannot compile. g++
/// prints the text in the type of the parameter, clang++ prints the line of the function. Arguments with that mistake
/// convert to such a type. The conversion and `...` have the lowest rank in overload resolution, so that any function
/// that accepts the call is preferred.
namespace mistake {

template<std::size_t N>
struct sentence {
  char text[N] = {};
  consteval sentence(const char (&words)[N]) {
    for (std::size_t i = 0; i < N; ++i) text[i] = words[i];
  }
};

/// Converts from a class without mesh_traits.
template<sentence Remedy>
struct no_mesh_traits {
  template<class M>
    requires(std::is_class_v<M> && !requirement::is_adapted<M>)
  no_mesh_traits(const M&);
};
inline constexpr sentence include_adapter("include the adapter of the mesh's library, such as #include <concino/adapters/openmesh.hpp>, or specialise concino::mesh_traits");

/// The type of a default template argument with a text: compilers print it, for mistakes that no parameter type can
/// express.
template<sentence Remedy> struct remedy {};

}  // namespace mistake

namespace detail {

/// The common base class of the verbs.
struct verb {
  void operator()(mistake::no_mesh_traits<mistake::include_adapter>, ...) const = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter
};

}  // namespace detail

}  // namespace concino

#include <concino/concepts/verbs.hpp>
