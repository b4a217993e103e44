// AnyMesh: a surface or a volume; Embedded: its verts have coordinates; EmbeddedMesh: both, which most algorithms on
// meshes require.
//
// Laws:
//   EM1  point(m, v) is three finite numbers
//   EM2  if the type fixes that polys are hexes, not all of them look as if their corners were listed in lexicographic
//        order
#pragma once

// In this order, from the base up, so that compilers list few headers before the message.
#include <concino/concepts/requirement.hpp>
#include <concino/concepts/mesh_traits.hpp>
#include <concino/concepts/primal_graph.hpp>
#include <concino/concepts/dual_graph.hpp>
#include <concino/concepts/mesh_requirements.hpp>
#include <concino/concepts/surface_mesh.hpp>
#include <concino/concepts/volume_mesh.hpp>

namespace concino {

namespace requirement {

template<class M> concept has_dimension = is_surface<M> || is_volume<M>;
struct dimension_requirement {
  template<class M> static constexpr bool holds = has_dimension<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_constant<requires { traits<M>::dimension; }, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs dimension: static constexpr int dimension = 2; of a surface, 3 of a volume");
  }
};

}  // namespace requirement

/// SurfaceMesh or VolumeMesh, written so that compilers report what is missing for the one that `dimension` selects.
template<class M>
concept AnyMesh = PrimalGraph<M> && DualGraph<M> && requirement::has_dimension<M> &&
    (SurfaceMesh<M> || requirement::is_volume<M>) && (VolumeMesh<M> || requirement::is_surface<M>);

namespace requirement {

struct surface_or_volume_requirement {
  template<class M> static constexpr bool holds = AnyMesh<M>;  // explained as SurfaceMesh or VolumeMesh, according to
                                                               // the dimension
};
template<class M>
struct check<surface_or_volume_requirement, M>
    : check<std::conditional_t<is_surface<M>, surface_mesh_requirements, volume_mesh_requirements>, M> {};

using any_mesh_requirements = list<traits_requirements, dimension_requirement, surface_or_volume_requirement>;

template<class M> concept has_point = requires(const std::remove_cvref_t<M>& m, vert_t<M> v) {
  { traits<M>::point(m, v)[0] } -> std::convertible_to<double>;
  { traits<M>::point(m, v)[1] } -> std::convertible_to<double>;
  { traits<M>::point(m, v)[2] } -> std::convertible_to<double>;
};
struct point_requirement {
  template<class M> static constexpr bool holds = has_point<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_value<requires { &traits<M>::point; }, point_verb, M, vert_t<M>>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs point: static P point(const M&, vert); P has p[0], p[1], p[2] that convert to double");
  }
};

// Detects a forgotten &: the point that is returned or set belongs to a copy of the mesh, which no longer exists. Views
// and trivially copyable meshes may be copied.
template<class M> concept is_copied_freely = is_view_v<M> || std::is_trivially_copyable_v<std::remove_cvref_t<M>>;
template<class M, class P>
concept point_is_of_a_copy = (std::is_lvalue_reference_v<P> || std::is_pointer_v<P>) &&
    requires { static_cast<P (*)(std::remove_cvref_t<M>, vert_t<M>)>(&traits<M>::point); } && !is_copied_freely<M>;
template<class M>
concept has_point_of_the_mesh = requires(const std::remove_cvref_t<M>& m, vert_t<M> v) {
  requires !point_is_of_a_copy<M, decltype(traits<M>::point(m, v))>;
};
struct point_of_the_mesh_requirement {
  template<class M> static constexpr bool holds = has_point_of_the_mesh<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::missing<M>, "concino: mesh_traits<M>::point has to take the mesh by reference, const M&: without the & it returns a reference into a copy that no longer exists");
  }
};

using embedded_requirements =
    list<traits_requirements, vert_requirement, point_requirement, point_of_the_mesh_requirement>;
using embedded_mesh_requirements = list<any_mesh_requirements, embedded_requirements>;
using embedded_graph_requirements = list<primal_graph_requirements, embedded_requirements>;

template<class M> concept has_set_point = requires(std::remove_cvref_t<M>& m, vert_t<M> v, const double (&x)[3]) {
  traits<M>::set_point(m, v, x);
};
struct set_point_requirement {
  template<class M> static constexpr bool holds = has_set_point<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs set_point: static void set_point(M&, vert, const X& x); X has x[0], x[1], x[2]");
  }
};

template<class M>
concept sets_point_of_the_mesh = is_copied_freely<M> || !requires {
  static_cast<void (*)(std::remove_cvref_t<M>, vert_t<M>, const double (&)[3])>(&traits<M>::set_point);
};
struct set_point_of_the_mesh_requirement {
  template<class M> static constexpr bool holds = sets_point_of_the_mesh<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::missing<M>, "concino: mesh_traits<M>::set_point has to take the mesh by reference, M&: without the & the point of a copy is set");
  }
};

using mutable_points_requirements =
    list<embedded_requirements, set_point_requirement, set_point_of_the_mesh_requirement>;

}  // namespace requirement

template<class M>
concept Embedded = requirement::is_adapted<M> && requirement::has_vert<M> && requirement::has_point<M> &&
    requirement::has_point_of_the_mesh<M>;

/// A mesh, or a graph of verts, with coordinates: all that most algorithms need.
template<class M> concept EmbeddedMesh = AnyMesh<M> && Embedded<M>;
template<class M> concept EmbeddedGraph = PrimalGraph<M> && Embedded<M>;

/// set_point takes anything with x[0], x[1], x[2].
template<class M>
concept MutablePoints = Embedded<M> && requirement::has_set_point<M> && requirement::sets_point_of_the_mesh<M>;

/// Fails to compile with one sentence that names the first thing M lacks to be Embedded and what to write.
template<class M>
consteval void explain_embedded() {
  if constexpr (!Embedded<M>) requirement::first_missing<requirement::embedded_requirements, M>::template explain<M>();
}

/// Fails to compile with one sentence that names the first thing M lacks to have MutablePoints and what to write.
template<class M>
consteval void explain_mutable_points() {
  if constexpr (!MutablePoints<M>)
    requirement::first_missing<requirement::mutable_points_requirements, M>::template explain<M>();
}

/// Fails to compile with one sentence that names the first thing M lacks to be an AnyMesh and what to write.
template<class M>
consteval void explain_any_mesh() {
  if constexpr (!AnyMesh<M>) requirement::first_missing<requirement::any_mesh_requirements, M>::template explain<M>();
}

/// Fails to compile with one sentence that names the first thing M lacks to be an EmbeddedMesh and what to write.
template<class M>
consteval void explain_embedded_mesh() {
  if constexpr (!EmbeddedMesh<M>)
    requirement::first_missing<requirement::embedded_mesh_requirements, M>::template explain<M>();
}

/// Fails to compile with one sentence that names the first thing M lacks to be an EmbeddedGraph and what to write.
template<class M>
consteval void explain_embedded_graph() {
  if constexpr (!EmbeddedGraph<M>)
    requirement::first_missing<requirement::embedded_graph_requirements, M>::template explain<M>();
}

namespace requirement {

// Of a graph of verts alone or of polys alone nothing else is declared.
template<class M>
concept is_graph_of_verts = PrimalGraph<M> && dimension_v<M> == 0 && !requires { typename poly_t<M>; };
template<class M> concept is_graph_of_polys = DualGraph<M> && !requires { typename vert_t<M>; } && dimension_v<M> == 0;

/// There are mesh_traits<M>, but those of no mesh and of no graph: a member is missing, not static, or of another type,
/// or does not take const M&.
template<class M>
concept is_incomplete = is_adapted<M> && !AnyMesh<M> && !is_graph_of_verts<M> && !is_graph_of_polys<M>;

}  // namespace requirement

namespace mistake {

/// Converts from a class that is no mesh and no graph: without mesh_traits, or with incomplete ones. For algorithms;
/// the verbs have no_mesh_traits, since traits call them before they are complete.
template<sentence Remedy>
struct no_mesh {
  template<class M>
    requires((std::is_class_v<M> && !requirement::is_adapted<M>) || requirement::is_incomplete<M>)
  no_mesh(const M&);
};
inline constexpr sentence adapt_the_mesh("include the adapter of the mesh's library, such as #include <concino/adapters/openmesh.hpp>, or specialise concino::mesh_traits; if they are incomplete, explain_any_mesh<M>() (a graph: explain_primal_graph<M>()) names what is missing");

/// Converts from a temporary mesh, which would no longer exist when the result is used.
template<sentence Remedy>
struct temporary_mesh {
  template<class M>
    requires(requirement::is_adapted<M> && !requirement::is_lvalue_or_view<M> && !requirement::is_incomplete<M>)
  temporary_mesh(M&&);
};
inline constexpr sentence name_the_mesh("the result refers to the mesh, which must not be a temporary: give it a name, auto m = ...;");

}  // namespace mistake

/// Whether x is an element of m now.
/// Needs:  mesh_traits<M>::index_of for elements of its kind.
/// Result: true or false.
/// Cost:   that of `contains` if the traits have it (constant time on the meshes of this library); else a search
///         through the elements of its kind.
/// Errors: none.
inline constexpr struct contains_verb : detail::verb {
  using verb::operator();
  template<class M, class X>
    requires requires(const M& m, const X& x) { traits<M>::index_of(m, x); }
  constexpr bool operator()(const M& m, const X& x) const {
    if constexpr (requires { traits<M>::contains(m, x); }) {
      return traits<M>::contains(m, x);
    } else {
      if constexpr (requires { requires std::same_as<X, vert_t<M>>; }) return found(traits<M>::verts(m), x);
      else if constexpr (requires { requires std::same_as<X, edge_t<M>>; }) return found(traits<M>::edges(m), x);
      else if constexpr (requires { requires std::same_as<X, poly_t<M>>; }) return found(traits<M>::polys(m), x);
      else if constexpr (requires { requires std::same_as<X, face_t<M>>; }) return found(traits<M>::faces(m), x);
      else if constexpr (requires { requires std::convertible_to<X, vert_t<M>>; }) return found(traits<M>::verts(m), x);
      else if constexpr (requires { requires std::convertible_to<X, edge_t<M>>; }) return found(traits<M>::edges(m), x);
      else if constexpr (requires { requires std::convertible_to<X, poly_t<M>>; }) return found(traits<M>::polys(m), x);
      else return found(traits<M>::faces(m), x);
    }
  }

 private:
  template<class R, class X>
  static constexpr bool found(const R& all, const X& x) {
    const auto end = all.end();
    for (auto it = all.begin(); it != end; ++it)
      if (*it == x) return true;
    return false;
  }
} contains{};

}  // namespace concino

