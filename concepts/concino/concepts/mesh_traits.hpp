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
//   edges_in_order                           optional: static constexpr bool; false where adj_p2e or adj_f2e breaks SM7 or VM8: then the verbs sort
//
// Include the adapter, or specialise, before anything asks about the type: an algorithm called, a concept named. A specialisation for one
// type that comes later is an error. So is a later one for many types, as adapters have, with g++; clang++ takes it without a word, but keeps
// the answer "no" for the types that were asked about.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/concepts/ranges.hpp>
#include <concino/concepts/requirement.hpp>

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
// The commonest reason is a forgotten adapter.
struct adapted_requirement {
  template<class M> static constexpr bool holds = is_adapted<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::missing<M>, "concino: no mesh_traits<M>: include the adapter of the library that M is from, <concino/adapters/...>: boost_graph.hpp, cgal_polyhedron.hpp, cgal_surface_mesh.hpp, cgal_triangulation.hpp, cgal_lcc.hpp, eigen.hpp, openmesh.hpp, span.hpp; or specialise concino::mesh_traits for M");
  }
};

// A base that traits may inherit from and that has requirements of its own, such as halfedge_kernel, says so by
//   using base_requirements = requirement::bound<...>;
template<class M> concept has_base_requirements = requires { typename traits<M>::base_requirements; };
struct base_requirement {
  template<class M> static constexpr bool holds = true;  // where the traits have no such base; else see below
};
template<has_base_requirements M>
struct check<base_requirement, M> : std::bool_constant<traits<M>::base_requirements::template holds<M>> {
  using first_missing = typename traits<M>::base_requirements;
};

/// What every list of requirements on mesh_traits begins with. Without what a base needs nothing can be had of it, so that this is explained first.
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

/// 2 for surfaces, 3 for volumes, 0 where the traits do not say.
template<class M> inline constexpr int dimension_v = detail::dimension_of<traits<M>>::value;
/// Verts of every poly where the type fixes it, else 0.
template<class M> inline constexpr int arity_v = detail::arity_of<traits<M>>::value;
/// Whether M shows another mesh rather than owning one.
template<class M> inline constexpr bool is_view_v = detail::view_of<traits<M>>::value;

namespace requirement {

/// What a result may refer to after the call: a mesh with a name, or a view, which is copied. A function that returns a map asks for
/// this of its argument, so that handing it a temporary mesh does not compile instead of leaving a dangling pointer.
template<class M> concept is_lvalue_or_view = std::is_lvalue_reference_v<M> || is_view_v<M>;

}  // namespace requirement

/// Parameter types of deleted functions that say what to write instead of a call that cannot compile: g++ shows the sentence in the type of the
/// parameter, clang++ the line of the function. A class converts to such a type where it makes that mistake; a conversion and `...` are the
/// worst match there is, so that any function that takes the call is preferred.
namespace mistake {

template<std::size_t N>
struct sentence {
  char text[N] = {};
  consteval sentence(const char (&words)[N]) {
    for (std::size_t i = 0; i < N; ++i) text[i] = words[i];
  }
};

/// Made of a class of which no mesh_traits are known.
template<sentence Remedy>
struct no_mesh_traits {
  template<class M>
    requires(std::is_class_v<M> && !requirement::is_adapted<M>)
  no_mesh_traits(const M&);
};
inline constexpr sentence include_adapter("include the adapter of the mesh's library, #include <concino/adapters/openmesh.hpp> or a sibling, or specialise concino::mesh_traits");

/// Made of a mesh without a name, which would be gone when the result is used.
template<sentence Remedy>
struct temporary_mesh {
  template<class M>
    requires(requirement::is_adapted<M> && !requirement::is_lvalue_or_view<M>)
  temporary_mesh(M&&);
};
inline constexpr sentence name_the_mesh("the result refers to the mesh, which must not be a temporary: give it a name, auto m = ...;");

/// The type of a default template argument: compilers show it where no parameter can say what is wrong.
template<sentence Remedy> struct remedy {};

}  // namespace mistake

namespace detail {

/// What the verbs have in common.
struct verb {
  void operator()(mistake::no_mesh_traits<mistake::include_adapter>, ...) const = delete;  // #include <concino/adapters/openmesh.hpp> or a sibling
};

}  // namespace detail

}  // namespace concino

#include <concino/concepts/verbs.hpp>
