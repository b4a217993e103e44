// Small random meshes to be cut, functions on their verts, and what every level set of them must fulfil.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/maps.hpp>
#include <concino/concepts/oriented_edges.hpp>
#include <concino/edit/elements.hpp>
#include <concino/edit/remove_unreferenced.hpp>
#include <concino/generate/agglomerate.hpp>
#include <concino/generate/grid.hpp>
#include <concino/generate/jitter.hpp>
#include <concino/generate/random_labels.hpp>
#include <concino/generate/random_points.hpp>
#include <concino/generate/voronoi_polyhedra.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/mesh_point.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace concino::testing {

/// A grid of the unit square or cube; in half of the cases with polys that are not regular, and with gaps, edges and verts where parts only touch.
template<class M>
M grid_to_cut(std::mt19937& random, unsigned n) {
  M m = make_grid<M>({.cells = {n, n, n}});
  if (random() % 2) jitter(m, 0.3, {.seed = random()});
  if (random() % 2) return m;
  std::vector<poly_t<M>> gone;
  for (const poly_t<M> p : polys(m))
    if (random() % 5 == 0) gone.push_back(p);
  for (const poly_t<M> p : gone) remove_poly(m, p);
  remove_unreferenced(m);
  return m;
}

/// Polys of many shapes: concave ones, such with holes in their middle, and convex ones with many faces.
template<class M>
M mesh_to_cut(std::mt19937& random) {
  const unsigned n = 2 + static_cast<unsigned>(random() % 2);
  const auto groups = [&](const auto& m, std::size_t size) { return agglomerate(m, random_labels(m, size, random())); };
  if constexpr (std::same_as<M, polygonmesh>) {
    return random() % 2 ? groups(make_grid<trimesh>({.cells = {n + 1, n + 1, 1}}), 6) : groups(grid_to_cut<quadmesh>(random, n + 1), 3);
  } else if constexpr (std::same_as<M, polyhedralmesh>) {
    if (random() % 3 == 0) {
      const box whole{{0, 0, 0}, {1, 1, 1}};
      return voronoi_polyhedra(random_points(10, whole, random()), whole);
    }
    return random() % 2 ? groups(make_grid<tetmesh>({.cells = {n, n, n}}), 10) : groups(grid_to_cut<hexmesh>(random, n), 3);
  } else {
    return grid_to_cut<M>(random, n);
  }
}

/// A function whose values are 0, 1, 2, so that it is equal to 1 at a third of the verts; or one of many values.
template<class M>
auto random_values(const M& m, std::mt19937& random, bool whole_numbers) {
  auto u = make_vert_map<double>(m);
  for (const vert_t<M> v : verts(m)) u[v] = whole_numbers ? static_cast<double>(random() % 3) : static_cast<double>(random() % 10000) / 5000;
  return u;
}

/// Unit cubes, merged to cells by their labels, 0 to the largest. Other than agglomerate(), it also merges cells that are no balls.
inline polyhedralmesh merged_cubes(unsigned x, unsigned y, unsigned z, const std::vector<std::size_t>& labels) {
  const auto grid = make_grid<hexmesh>({.cells = {x, y, z}, .max = {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}});
  polyhedra_arrays arrays;
  for (const vert_id v : verts(grid)) arrays.points.push_back(point(grid, v));
  std::vector<std::vector<std::pair<face_id, std::uint8_t>>> cells(*std::max_element(labels.begin(), labels.end()) + 1);
  arrays.face_offsets = {0};
  for (const face_id f : faces(grid)) {
    std::vector<poly_id> around;
    for (const poly_id p : adj_f2p(grid, f)) around.push_back(p);
    if (around.size() == 2 && labels[around[0].raw()] == labels[around[1].raw()]) continue;
    const face_id here(static_cast<std::uint32_t>(arrays.face_offsets.size() - 1));
    for (const poly_id p : around) cells[labels[p.raw()]].emplace_back(here, face_is_outward(grid, p, f));
    for (const vert_id v : adj_f2v(grid, f)) arrays.face_verts.push_back(v);
    arrays.face_offsets.push_back(static_cast<std::uint32_t>(arrays.face_verts.size()));
  }
  arrays.poly_offsets = {0};
  for (const auto& cell : cells) {
    for (const auto& [f, outward] : cell) {
      arrays.poly_faces.push_back(f);
      arrays.outward.push_back(outward);
    }
    arrays.poly_offsets.push_back(static_cast<std::uint32_t>(arrays.poly_faces.size()));
  }
  return polyhedralmesh(arrays);
}

/// Whether a point of a mesh is at an element of the boundary, or at an edge with three polys or more.
template<class M>
bool may_end_at(const M& m, const mesh_point<M>& x) {
  if (const auto* v = std::get_if<vert_t<M>>(&x.element)) {
    for (const edge_t<M> e : adj_v2e(m, *v))
      if (num_elements(adj_e2p(m, e)) != 2) return true;
    return false;
  }
  const auto* on_edge = std::get_if<edge_point<M>>(&x.element);
  return on_edge && num_elements(adj_e2p(m, on_edge->edge)) != 2;
}

template<class M>
bool is_on_boundary(const M& m, const mesh_point<M>& x) {
  if (const auto* v = std::get_if<vert_t<M>>(&x.element)) return is_boundary(m, *v);
  if (const auto* e = std::get_if<edge_point<M>>(&x.element)) return is_boundary(m, e->edge);
  if constexpr (dimension_v<M> == 3)  // in surfaces, a face is the inside of a poly
    if (const auto* f = std::get_if<face_t<M>>(&x.element)) return is_boundary(m, *f);
  return false;
}

/// Whether a number of polys around a vert form one fan, open or closed.
template<class Q>
bool is_one_fan(const Q& q, vert_t<Q> v) {
  std::vector<poly_t<Q>> seen, open;
  for (const poly_t<Q> p : adj_v2p(q, v)) {
    open.push_back(p);
    break;
  }
  seen = open;
  while (!open.empty()) {
    const poly_t<Q> p = open.back();
    open.pop_back();
    for (const edge_t<Q> e : adj_p2e(q, p)) {
      const auto ends = end_verts(q, e);
      if (ends.first != v && ends.second != v) continue;
      for (const poly_t<Q> other : adj_e2p(q, e))
        if (std::find(seen.begin(), seen.end(), other) == seen.end()) {
          seen.push_back(other);
          open.push_back(other);
        }
    }
  }
  return !seen.empty() && seen.size() == num_elements(adj_v2p(q, v));
}

/// Checks that a surface s in m is an oriented manifold that ends at the boundary of m only, without elements of size zero or twice the same.
template<class M, class S>
void check_level_surface(const M& m, const S& s) {
  const auto& q = s.mesh;
  std::size_t wrong_edges = 0, open_edges = 0, turned = 0, wrong_verts = 0, repeated = 0;
  for (const auto e : edges(q)) {
    const auto ends = end_verts(q, e);
    wrong_edges += num_elements(adj_e2p(q, e)) > 2 || ends.first == ends.second;
    if (num_elements(adj_e2p(q, e)) == 1) open_edges += !is_on_boundary(m, s.place_of(ends.first)) || !is_on_boundary(m, s.place_of(ends.second));
    int direction = 0;
    for (const auto p : adj_e2p(q, e))
      for (const auto& side : oriented_edges(q, p))
        if (side.edge == e) direction += side.from == ends.first ? 1 : -1;
    turned += num_elements(adj_e2p(q, e)) == 2 && direction != 0;
  }
  for (const auto v : verts(q)) wrong_verts += !is_one_fan(q, v);
  std::set<std::vector<std::size_t>> corners;
  for (const auto p : polys(q)) {
    std::vector<std::size_t> list;
    for (const auto v : adj_p2v(q, p)) list.push_back(index_of(q, v));
    std::sort(list.begin(), list.end());
    repeated += list.size() < 3 || std::adjacent_find(list.begin(), list.end()) != list.end() || !corners.insert(list).second;
  }
  CHECK(wrong_edges == 0);
  CHECK(open_edges == 0);
  CHECK(turned == 0);
  CHECK(wrong_verts == 0);
  CHECK(repeated == 0);
}

/// A number for each place of a mesh, the same for the same element.
template<class M>
class place_key {
  using key = std::tuple<int, std::size_t, double, double, double>;
  const M& m_;

 public:
  explicit place_key(const M& m) : m_(m) {}
  key operator()(const mesh_point<M>& x) const {
    if (const auto* v = std::get_if<vert_t<M>>(&x.element)) return {0, index_of(m_, *v), 0, 0, 0};
    if (const auto* e = std::get_if<edge_point<M>>(&x.element)) return {1, index_of(m_, e->edge), 0, 0, 0};
    return {2, 0, x.position.x, x.position.y, x.position.z};
  }
};

/// Checks that lines end at boundaries or edges with other than two polys only, and that each point between is used by exactly two segments of its line.
template<class M, class Lines>
void check_level_lines(const M& m, const Lines& lines) {
  std::size_t wrong_ends = 0, short_lines = 0, wrong_points = 0, empty_segments = 0;
  std::map<std::tuple<double, int, std::size_t, double, double, double>, int> uses;
  const place_key<M> key(m);
  for (const auto& line : lines) {
    const std::size_t n = line.points.size();
    short_lines += n < (line.closed ? 3u : 2u) || line.places.size() != n;
    if (!line.closed && n > 0) wrong_ends += !may_end_at(m, line.places.front()) || !may_end_at(m, line.places.back());
    for (std::size_t i = 0; i < n; ++i) {
      const auto k = key(line.places[i]);
      if (i + 1 < n || line.closed) empty_segments += k == key(line.places[(i + 1) % n]);
      if (std::get<0>(k) == 1 && !may_end_at(m, line.places[i])) uses[std::tuple_cat(std::tuple(line.value), k)] += line.closed || (i > 0 && i + 1 < n) ? 2 : 1;
    }
  }
  for (const auto& [k, n] : uses) wrong_points += n != 2;
  CHECK(wrong_ends == 0);
  CHECK(short_lines == 0);
  CHECK(wrong_points == 0);
  CHECK(empty_segments == 0);
}

/// The length of a polyline.
template<class Line>
double length_of(const Line& line) {
  double sum = 0;
  const std::size_t n = line.points.size();
  for (std::size_t i = 0; i + 1 < n + (line.closed ? 1 : 0); ++i) sum += norm(line.points[(i + 1) % n] - line.points[i]);
  return sum;
}

}  // namespace concino::testing
