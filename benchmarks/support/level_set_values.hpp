// Functions whose level sets are measured: the squared distances of verts from the centre of a mesh.
#pragma once

#include "../floor/buffer.hpp"
#include "program.hpp"

#include <concino/geometry/bounding_box.hpp>
#include <concino/level_sets.hpp>
#include <concino/mesh.hpp>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bench {

namespace cn = concino;

inline void expect(bool same, const std::string& work, const char* what) {
  if (!same) throw std::runtime_error(work + ": " + what);
}

/// The squared distance of each vert from a point.
inline floors::buffer<double> squared_distances(const std::vector<cn::vec3>& points, const cn::vec3& centre) {
  floors::buffer<double> u(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) u[v] = cn::dot(points[v] - centre, points[v] - centre);
  return u;
}

template<class M>
auto as_map(const M& m, const floors::buffer<double>& values) {
  auto u = cn::make_vert_map<double>(m);
  for (const auto v : cn::verts(m)) u[v] = values[cn::index_of(m, v)];
  return u;
}

/// A function on a surface, and the mean of its smallest and its largest value.
template<class M>
struct middle_level {
  floors::buffer<double> values;
  double level;
  decltype(cn::make_vert_map<double>(std::declval<const M&>())) u;

  explicit middle_level(const M& m)
      : values(squared_distances(m.points(), cn::bounding_box(m).centre())),
        level((*std::min_element(values.begin(), values.end()) + *std::max_element(values.begin(), values.end())) / 2),
        u(as_map(m, values)) {}
};

/// A sphere in a grid of cells. Its radius, as a part of the width of the grid, is such that it cuts about 3 % of the cells.
template<class M>
struct sphere {
  floors::buffer<double> values;
  double level;
  decltype(cn::make_vert_map<double>(std::declval<const M&>())) u;
  std::size_t cut = 0, cut_edges = 0, outside = 0;  // polys and edges that are cut, and polys outside

  sphere(const bench::program& p, const std::string& work, const M& m, double radius)
      : sphere(p, work, m, cn::bounding_box(m), radius) {}

 private:
  sphere(const bench::program& p, const std::string& work, const M& m, const cn::box& b, double radius)
      : values(squared_distances(m.points(), b.centre())), level(square(radius * (b.max.x - b.min.x))), u(as_map(m, values)) {
    const auto above = [&](auto v) { return u[v] >= level; };
    for (const auto q : cn::polys(m)) {
      std::size_t n = 0, all = 0;
      for (const auto v : cn::adj_p2v(m, q)) n += above(v), ++all;
      cut += n > 0 && n < all;
      outside += n == all;
    }
    for (const auto e : cn::edges(m)) {
      const auto ends = cn::adj_e2v(m, e);
      cut_edges += above(*ends.begin()) != above(*std::next(ends.begin()));
    }
    const double share = static_cast<double>(cut) / static_cast<double>(cn::num_polys(m));
    expect(p.data.tiny || (0.029 < share && share < 0.031), work, "the sphere does not cut about 3 % of the polys");
  }
  static double square(double x) { return x * x; }
};

}  // namespace bench
