// AnyMesh: a surface or a volume; Embedded: its verts have coordinates; EmbeddedMesh: both, what most algorithms on meshes name.
//
// Laws:
//   EM1  point(m, v) is three finite numbers
//   EM2  where polys are hexes by type, not all of them look as if their corners were listed in lexicographic order
#pragma once

#include <concino/concepts/surface_mesh.hpp>
#include <concino/concepts/volume_mesh.hpp>

namespace concino {

/// SurfaceMesh or VolumeMesh, written so that compilers say what the one lacks that `dimension` asks for.
template<class M>
concept AnyMesh = PrimalGraph<M> && DualGraph<M> && (SurfaceMesh<M> || requirement::is_volume<M>) && (VolumeMesh<M> || requirement::is_surface<M>);

namespace requirement {

template<class M> concept has_point = requires(const std::remove_cvref_t<M>& m, vert_t<M> v) {
  { traits<M>::point(m, v)[0] } -> std::convertible_to<double>;
  { traits<M>::point(m, v)[1] } -> std::convertible_to<double>;
  { traits<M>::point(m, v)[2] } -> std::convertible_to<double>;
};
template<class M> concept has_set_point = requires(std::remove_cvref_t<M>& m, vert_t<M> v, const double (&x)[3]) { traits<M>::set_point(m, v, x); };

// A forgotten &: what is returned, or set, belongs to a copy of the mesh that is gone. Views and meshes as small as a pointer may be copied.
template<class M> concept is_copied_freely = is_view_v<M> || std::is_trivially_copyable_v<std::remove_cvref_t<M>>;
template<class M, class P>
concept point_is_of_a_copy = (std::is_lvalue_reference_v<P> || std::is_pointer_v<P>) &&
    requires { static_cast<P (*)(std::remove_cvref_t<M>, vert_t<M>)>(&traits<M>::point); } && !is_copied_freely<M>;
template<class M>
concept has_point_of_the_mesh = requires(const std::remove_cvref_t<M>& m, vert_t<M> v) {
  requires !point_is_of_a_copy<M, decltype(traits<M>::point(m, v))>;
};
template<class M>
concept sets_point_of_a_copy =
    requires { static_cast<void (*)(std::remove_cvref_t<M>, vert_t<M>, const double (&)[3])>(&traits<M>::set_point); } && !is_copied_freely<M>;

}  // namespace requirement

template<class M>
concept Embedded = requirement::is_adapted<M> && requirement::has_vert<M> && requirement::has_point<M> && requirement::has_point_of_the_mesh<M>;

/// A mesh with coordinates, a graph of verts with coordinates: all that most algorithms need.
template<class M> concept EmbeddedMesh = AnyMesh<M> && Embedded<M>;
template<class M> concept EmbeddedGraph = PrimalGraph<M> && Embedded<M>;

/// set_point takes anything with x[0], x[1], x[2].
template<class M> concept MutablePoints = Embedded<M> && requirement::has_set_point<M> && !requirement::sets_point_of_a_copy<M>;

/// Fails to compile with one sentence that names the first thing M lacks to be Embedded and what to write.
template<class M>
consteval void explain_embedded() {
  using detail::missing;
  // One line per message, so that compilers show it in one.
  // clang-format off
  if constexpr (!requirement::is_adapted<M>)
    static_assert(missing<M>, "concino: Embedded: " CONCINO_NO_TRAITS);
  else if constexpr (!requirement::has_vert<M>)
    static_assert(missing<M>, "concino: Embedded needs mesh_traits<M>::vert: using vert = a std::regular type; names one vert");
  else if constexpr (!requirement::has_point<M>)
    static_assert(missing<M>, "concino: Embedded needs mesh_traits<M>::point: static P point(const M&, vert); P has p[0], p[1], p[2] that convert to double");
  else if constexpr (!requirement::has_point_of_the_mesh<M>)
    static_assert(missing<M>, "concino: Embedded needs mesh_traits<M>::point to take the mesh by reference, const M&: without the & it returns a reference into a copy that is gone");
  else static_assert(Embedded<M>);
  // clang-format on
}

/// Fails to compile with one sentence that names the first thing M lacks to have MutablePoints and what to write.
template<class M>
consteval void explain_mutable_points() {
  using detail::missing;
  if constexpr (!Embedded<M>) explain_embedded<M>();
  else if constexpr (!requirement::has_set_point<M>)
    static_assert(missing<M>, "concino: MutablePoints needs mesh_traits<M>::set_point: static void set_point(M&, vert, const X& x); X has x[0], x[1], x[2]");
  else if constexpr (requirement::sets_point_of_a_copy<M>)
    static_assert(missing<M>, "concino: MutablePoints needs mesh_traits<M>::set_point to take the mesh by reference, M&: without the & the point of a copy is set");
}

/// Fails to compile with one sentence that names the first thing M lacks to be an AnyMesh and what to write.
template<class M>
consteval void explain_any_mesh() {
  using detail::missing;
  // clang-format off
  if constexpr (!requirement::is_adapted<M>)
    static_assert(missing<M>, "concino: AnyMesh: " CONCINO_NO_TRAITS);
  else if constexpr (dimension_v<M> == 2) explain_surface_mesh<M>();
  else if constexpr (dimension_v<M> == 3) explain_volume_mesh<M>();
  else
    static_assert(missing<M>, "concino: AnyMesh needs mesh_traits<M>::dimension: static constexpr int dimension = 2 for a surface, 3 for a volume");
  // clang-format on
}

/// Fails to compile with one sentence that names the first thing M lacks to be an EmbeddedMesh or an EmbeddedGraph and what to write.
template<class M>
consteval void explain_embedded_mesh() {
  if constexpr (!AnyMesh<M>) explain_any_mesh<M>();
  else explain_embedded<M>();
}
template<class M>
consteval void explain_embedded_graph() {
  if constexpr (!PrimalGraph<M>) explain_primal_graph<M>();
  else explain_embedded<M>();
}

/// Whether x is an element of m now.
/// Needs:  mesh_traits<M>::index_of for elements of its kind.
/// Result: true or false.
/// Cost:   that of `contains` where the traits offer it, constant time on the meshes of this library; else a walk over the elements of its kind.
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

