// A vector field at polys, checked once and scaled so that its products neither overflow nor underflow.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/vec3.hpp>
#include <concino/concepts/mesh.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace concino::detail {

[[noreturn, gnu::cold, gnu::noinline]] inline void throw_points_not_finite(std::size_t poly) {
  core::throw_joined<invalid_mesh>({"integral_line: poly ", poly, " has points that are not finite"});
}

/// Errors: invalid_argument, naming the poly whose vector is not finite.
template<class M, class G>
class field_reader {
  const G* g_;
  double scale_ = 1, factor_ = 1;

 public:
  field_reader(const M& m, const G& g, const char* caller) : g_(&g) {
    double most = 0;
    for (const poly_t<M> p : polys(m)) {
      const vec3 x = to_vec3(g[p]);
      if (!is_finite(x))
        core::throw_joined<invalid_argument>(
            {caller, ": the vector at poly ", index_of(m, p), " is not finite; give each poly a finite vector"});
      most = std::max({most, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
    }
    if (most > 0) scale_ = std::ldexp(1.0, -std::clamp(std::ilogb(most), -1022, 1022));
    factor_ = scale_;
  }
  /// For a field that is known to be finite, and near 1.
  explicit field_reader(const G& g) : g_(&g) {}
  /// 1: forward, -1: backward.
  void set_sense(double s) { factor_ = s * scale_; }
  vec3 of(const poly_t<M>& p) const { return factor_ * to_vec3((*g_)[p]); }
};

}  // namespace concino::detail
