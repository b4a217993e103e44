// Test fields on verts, and the difference between maps.
#pragma once

#include <concino/mesh/element_map.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace concino::testing {

/// A field whose value at a vert depends only on the vert's number.
struct by_number {
  template<class V>
  double operator[](const V& v) const { return std::sin(static_cast<double>(v.raw())); }
};

/// Random values between -1 and 1, the same at every call.
template<class M>
vert_map<M, double> random_values(const M& m) {
  std::mt19937 random(7);
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = static_cast<double>(random() % 1000) / 500 - 1;
  return u;
}

template<class U, class W>
double largest_difference(const U& u, const W& w) {
  double worst = 0;
  for (const auto v : verts(u.mesh())) worst = std::max(worst, std::abs(u[v] - w[v]));
  return worst;
}

}  // namespace concino::testing
