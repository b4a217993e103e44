// Values at verts that tests make up, and how far maps are apart.
#pragma once

#include <concino/mesh/element_map.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace concino::testing {

/// A field that needs no mesh: its values differ from vert to vert.
struct by_number {
  template<class V>
  double operator[](const V& v) const { return std::sin(static_cast<double>(v.raw())); }
};

/// Between -1 and 1, the same every time.
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
