// A total order of the verts of a mesh by their values, for functions whose critical points, pairs and trees are asked
// for.
#pragma once

#include <concino/concepts/mesh_traits.hpp>
#include <concino/concepts/verbs.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/parallel.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

[[noreturn]] void throw_value_not_finite(const char* caller, std::size_t vert);

/// The verts by ascending values; of equal values, the smaller index comes first. So no two verts are equal, as if the
/// values had been disturbed by infinitely small amounts.
class vert_order {
  std::vector<double> values_;  // by index

 public:
  /// Errors: invalid_argument that names a vert whose value is not finite.
  template<class M, class U>
  vert_order(const M& m, const U& u, const char* caller) : values_(vert_index_bound(m)) {
    parallel_for_each(verts(m), [&](const vert_t<M>& v) {
      const double value = static_cast<double>(u[v]);
      if (!std::isfinite(value)) throw_value_not_finite(caller, index_of(m, v));
      values_[index_of(m, v)] = value;
    });
  }

  double value(std::size_t i) const { return values_[i]; }
  const std::vector<double>& values() const { return values_; }
  bool is_below(std::size_t a, std::size_t b) const {
    return values_[a] < values_[b] || (values_[a] == values_[b] && a < b);
  }
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/topology/vert_order.ipp>
#endif
