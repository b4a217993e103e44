// A mesh seen at a size near 1: what is solved there is neither too large nor too small for double precision, wherever the coordinates lie.
#pragma once

#include <concino/concepts/views/forward.hpp>
#include <concino/core/vec3.hpp>
#include <concino/operators/discretisation.hpp>

#include <algorithm>
#include <cmath>

namespace concino {

namespace views {

/// The mesh with all coordinates times 2^-exponent, which changes no digit of them but those that fall below the least double.
template<class M>
class scaled : public view_base<M> {
  int exponent_;
  double half_, other_half_;  // of the factor, which may be no double

 public:
  scaled(const M& m, int exponent)
      : view_base<M>(m), exponent_(exponent), half_(std::ldexp(1.0, -(exponent / 2))), other_half_(std::ldexp(1.0, exponent / 2 - exponent)) {}
  int exponent() const { return exponent_; }
  vec3 scale_down(const vec3& x) const { return other_half_ * (half_ * x); }
};

}  // namespace views

template<class M>
struct mesh_traits<views::scaled<M>> : detail::forward_all<views::scaled<M>, M>, detail::fixed_arity<arity_v<M>> {
  static constexpr bool is_view = true;
  static vec3 point(const views::scaled<M>& m, const vert_t<M>& v) { return m.scale_down(to_vec3(traits<M>::point(m.base(), v))); }
};

namespace detail {

/// The power of two, as its exponent, that makes the largest coordinate at least 1/2 and less than 1. 0 where all are 0 or not finite.
template<AnyMesh M>
int length_exponent(const M& m) {
  double largest = 0;
  for (const vert_t<M> v : verts(m)) {
    const vec3 x = to_vec3(point(m, v));
    if (is_finite(x)) largest = std::max({largest, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
  }
  return largest > 0 ? std::ilogb(largest) + 1 : 0;
}

template<AnyMesh M>
views::scaled<M> scaled_to_unit(const M& m) {
  return {m, length_exponent(m)};
}

/// Whether D can be asked about the mesh at another size.
template<class D, class M>
concept scales_with = EmbeddedMesh<M> && requirement::scales_with_mesh<D> && !requirement::has_masses<D, M>;

/// Calls use(mesh, exponent) with the mesh at a size near 1, or, where lengths do not matter, with itself and 0.
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
