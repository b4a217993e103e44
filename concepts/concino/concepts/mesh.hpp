// AnyMesh: a surface or a volume; Embedded: its verts have coordinates. What most algorithms on meshes name.
//
// Laws:
//   EM1  point(m, v) is three finite numbers
#pragma once

#include <concino/concepts/surface_mesh.hpp>
#include <concino/concepts/volume_mesh.hpp>

namespace concino {

template<class M> concept AnyMesh = SurfaceMesh<M> || VolumeMesh<M>;

namespace requirement {

template<class M> concept has_point = requires(const std::remove_cvref_t<M>& m, vert_t<M> v) {
  { traits<M>::point(m, v)[0] } -> std::convertible_to<double>;
  { traits<M>::point(m, v)[1] } -> std::convertible_to<double>;
  { traits<M>::point(m, v)[2] } -> std::convertible_to<double>;
};
template<class M> concept has_set_point = requires(std::remove_cvref_t<M>& m, vert_t<M> v, const double (&x)[3]) { traits<M>::set_point(m, v, x); };

}  // namespace requirement

template<class M> concept Embedded = requirement::is_adapted<M> && requirement::has_vert<M> && requirement::has_point<M>;

/// set_point takes anything with x[0], x[1], x[2].
template<class M> concept MutablePoints = Embedded<M> && requirement::has_set_point<M>;

/// Fails to compile with one sentence that names the first thing M lacks to be Embedded and what to write.
template<class M>
consteval void explain_embedded();

/// Whether x is an element of m now. Constant time where the traits offer `contains`, else one walk over the elements of its kind.
inline constexpr struct contains_verb {
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

