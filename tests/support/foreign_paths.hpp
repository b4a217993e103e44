// Paths and level sets on meshes of other libraries become edges of them.
#pragma once

#include <support/foreign_edits.hpp>

#include <concino/core/error.hpp>
#include <concino/geometry/edge_length.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/level_sets/embed.hpp>
#include <concino/level_sets/embed_path.hpp>
#include <concino/level_sets/isolines.hpp>
#include <concino/mesh/element_map.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace concino::testing {

/// Embeds a line across a flat surface, and refuses a path that is none.
template<class M>
void embeds_a_path(M m) {
  auto u = make_vert_map<double>(m);
  double low = 1e300, high = -1e300;
  for (const auto v : verts(m)) {
    const vec3 x = to_vec3(point(m, v));
    u[v] = x.x + 0.3 * x.y;
    low = std::min(low, u[v]), high = std::max(high, u[v]);
  }
  const auto line = isolines(m, u, 0.48 * low + 0.52 * high).front();
  const auto before = foreign_state(m);
  auto wrong = line.places;
  wrong.push_back({edge_point<M>{line.edge_points.front().edge, std::nan("")}, {}});
  CHECK_THROWS_AS(embed_path(m, wrong), invalid_argument);
  CHECK(foreign_state(m) == before);

  double whole = 0, length = 0, of_edges = 0, area_after = 0;
  for (const auto p : polys(m)) whole += area(m, p);
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) length += norm(line.points[i + 1] - line.points[i]);
  const std::size_t nv = num_verts(m);
  const auto path = embed_path(m, line.places);
  for (const auto e : path.edges) of_edges += edge_length(m, e);
  for (const auto p : polys(m)) area_after += area(m, p);
  CHECK(path.edges.size() + 1 == line.points.size());
  CHECK(of_edges == doctest::Approx(length).epsilon(1e-5));  // points may have single precision
  CHECK(area_after == doctest::Approx(whole).epsilon(1e-5));
  CHECK(num_verts(m) == nv + path.new_verts.size());
  CHECK(path.new_verts.size() > 2);
  foreign_laws_hold(m);
}

/// Embeds a level set of a map that the caller has, and refuses a map with a NaN.
template<class M, class U>
void embeds_a_level_set(M& m, U&& u) {
  double low = 1e300, high = -1e300, whole = 0, length = 0, of_edges = 0, area_after = 0;
  for (const auto v : verts(m)) {
    const vec3 x = to_vec3(point(m, v));
    u[v] = x.x * x.x + 0.3 * x.y;
    low = std::min(low, static_cast<double>(u[v])), high = std::max(high, static_cast<double>(u[v]));
  }
  const double value = 0.53 * low + 0.47 * high;
  const auto before = foreign_state(m);
  const auto first = *verts(m).begin();
  const double kept = u[first];
  u[first] = std::nan("");
  CHECK_THROWS_AS(embed_isolines(m, u, value), invalid_argument);
  CHECK(foreign_state(m) == before);
  u[first] = kept;

  for (const auto p : polys(m)) whole += area(m, p);
  std::size_t segments = 0;
  for (const auto& line : isolines(m, u, value)) {
    const std::size_t n = line.points.size(), of_line = line.closed ? n : n - 1;
    for (std::size_t i = 0; i < of_line; ++i) length += norm(line.points[(i + 1) % n] - line.points[i]);
    segments += of_line;
  }
  const std::size_t nv = num_verts(m);
  const auto cut = embed_isolines(m, u, value);
  for (const auto e : cut.edges) of_edges += edge_length(m, e);
  for (const auto p : polys(m)) area_after += area(m, p);
  CHECK(segments > 2);
  CHECK(cut.edges.size() == segments);
  CHECK(of_edges == doctest::Approx(length).epsilon(1e-5));  // points may have single precision
  CHECK(area_after == doctest::Approx(whole).epsilon(1e-5));
  CHECK(num_verts(m) == nv + cut.verts.size());
  for (const auto v : cut.verts) CHECK(u[v] == value);
  std::size_t straddling = 0;
  for (const auto e : edges(m)) {
    const auto ends = end_verts(m, e);
    straddling += (u[ends.first] < value && u[ends.second] > value) || (u[ends.first] > value && u[ends.second] < value);
  }
  CHECK(straddling == 0);
  CHECK(embed_isolines(m, u, value).verts.empty());  // it is embedded already
  foreign_laws_hold(m);
}

}  // namespace concino::testing
