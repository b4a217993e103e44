// A view of a mesh scaled to a size near 1, so that values stay within the range of double precision whatever the
// coordinates.
#pragma once

#include <concino/concepts/views/forward.hpp>
#include <concino/core/vec3.hpp>
#include <concino/operators/discretisation.hpp>

#include <algorithm>
#include <cmath>

namespace concino {

namespace views {

/// The mesh with all coordinates times 2^-exponent. This is exact, except for digits that fall below the smallest
/// double.
template<class M>
class scaled : public view_base<M> {
  int exponent_;
  double half_, other_half_;  // factors whose product is the scale, which may not be representable

 public:
  scaled(const M& m, int exponent)
      : view_base<M>(m), exponent_(exponent), half_(std::ldexp(1.0, -(exponent / 2))),
        other_half_(std::ldexp(1.0, exponent / 2 - exponent)) {}
  int exponent() const { return exponent_; }
  vec3 scale_down(const vec3& x) const { return other_half_ * (half_ * x); }
};

}  // namespace views

template<class M>
struct mesh_traits<views::scaled<M>> : detail::forward_all<views::scaled<M>, M>,
                                       detail::forward_numbers<views::scaled<M>, M>,
                                       detail::fixed_arity<arity_v<M>> {
  static constexpr bool is_view = true;
  static vec3 point(const views::scaled<M>& m, const vert_t<M>& v) {
    return m.scale_down(to_vec3(traits<M>::point(m.base(), v)));
  }
};

namespace detail {

/// The largest coordinate, by its absolute value, of the points that are finite.
template<AnyMesh M>
double largest_finite_coordinate(const M& m) {
  double largest = 0;
  for (const vert_t<M> v : verts(m)) {
    const vec3 x = to_vec3(point(m, v));
    if (is_finite(x)) largest = std::max({largest, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
  }
  return largest;
}

/// The exponent of the power of two that divides the largest coordinate into [1/2, 1). 0 if all coordinates are 0 or
/// not finite.
inline int length_exponent(double largest) { return largest > 0 ? std::ilogb(largest) + 1 : 0; }

template<AnyMesh M>
views::scaled<M> scaled_to_unit(const M& m) {
  return {m, length_exponent(largest_finite_coordinate(m))};
}

/// Whether D can be evaluated on a scaled mesh.
template<class D, class M>
concept scales_with = EmbeddedMesh<M> && requirement::scales_with_mesh<D> && !requirement::has_masses<D, M>;

/// Calls use(mesh, exponent) with the mesh scaled to a size near 1 or, if D does not depend on lengths, with the mesh
/// itself and 0.
template<class M, class D, class Use>
auto at_unit_size(const M& m, const D&, const Use& use) {
  if constexpr (scales_with<D, M>) {
    const views::scaled<M> at = scaled_to_unit(m);
    return use(at, at.exponent());
  } else {
    return use(m, 0);
  }
}

}  // namespace detail

}  // namespace concino
