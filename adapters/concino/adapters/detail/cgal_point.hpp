// Conversion of CGAL's points to three doubles and back, for all adapters of CGAL.
#pragma once

#include <concino/core/vec3.hpp>

#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>

namespace concino::detail {

template<class P, int Dimension> concept cgal_point = requires { requires P::Ambient_dimension::value == Dimension; };

/// Another type of point: an array, an Eigen vector, a vec3.
template<class P> concept plain_point = !requires { typename P::Ambient_dimension; } && requires(const P& p) {
  { p[0] } -> std::convertible_to<double>;
  { p[1] } -> std::convertible_to<double>;
  { p[2] } -> std::convertible_to<double>;
};

template<class P> concept readable_point = cgal_point<P, 3> || cgal_point<P, 2> || plain_point<P>;

/// The coordinates of p: of a CGAL point as a vec3 (in the plane with z = 0), otherwise p itself, as stored in the
/// mesh.
template<readable_point P>
decltype(auto) read_point(const P& p) {
  if constexpr (cgal_point<P, 3>) return vec3{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  else if constexpr (cgal_point<P, 2>) return vec3{CGAL::to_double(p.x()), CGAL::to_double(p.y()), 0};
  else return (p);
}

/// Exactly the 3D point of a kernel: others, such as weighted points, have more than coordinates.
template<class P>
concept kernel_point = cgal_point<P, 3> && std::same_as<P, typename CGAL::Kernel_traits<P>::Kernel::Point_3>;
template<class P> concept writable_point = kernel_point<P> || (plain_point<P> && requires(P& p) {
  p[0] = 0;
  p[1] = 0;
  p[2] = 0;
});

template<writable_point P, class X>
void assign_point(P& p, const X& x) {
  const vec3 to = to_vec3(x);
  if constexpr (kernel_point<P>) {
    p = P(to.x, to.y, to.z);
  } else {
    using number = std::remove_cvref_t<decltype(p[0])>;
    p[0] = static_cast<number>(to.x);
    p[1] = static_cast<number>(to.y);
    p[2] = static_cast<number>(to.z);
  }
}

}  // namespace concino::detail
