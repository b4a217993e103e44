#include <concino/render/graph_tubes.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/facets.hpp>
#include <concino/io/skeleton_graph.hpp>

#include <doctest/doctest.h>
#include <support/drawables.hpp>
#include <support/kinds.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

using namespace concino;
using testing::check_closed;

namespace {

using edge_set = std::multiset<std::pair<std::uint32_t, std::uint32_t>>;

edge_set edges_of(const detail::graph_lines& t) {
  edge_set all;
  std::size_t first = 0;
  for (std::size_t line = 0; line < t.lines.ends.size(); ++line) {
    const std::size_t last = t.lines.ends[line];
    for (std::size_t i = first; i + (t.lines.closed[line] ? 0 : 1) < last; ++i) all.insert(std::minmax(t.verts[i], t.verts[i + 1 < last ? i + 1 : first]));
    first = last;
  }
  return all;
}

double length_of(const detail::graph_lines& t) {
  double sum = 0;
  std::size_t first = 0;
  for (std::size_t line = 0; line < t.lines.ends.size(); first = t.lines.ends[line++])
    for (std::size_t i = first + 1; i < t.lines.ends[line]; ++i) sum += distance(t.lines.points[i - 1], t.lines.points[i]);
  return sum;
}

}  // namespace

TEST_CASE("make_graph_tubes: lines of a graph have each edge once and go straight on") {
  const quadmesh m = testing::grid<quadmesh>(4);
  detail::flat_graph g;
  edge_set wanted;
  for (const auto v : verts(m)) g.points.push_back(point(m, v));
  for (const auto e : edges(m)) {
    const auto [a, b] = end_verts(m, e);
    g.edges.push_back({a.raw(), b.raw()});
    wanted.insert(std::minmax(a.raw(), b.raw()));
  }
  const detail::graph_lines t = detail::graph_lines_of(g);
  CHECK(edges_of(t) == wanted);
  CHECK(t.lines.ends.size() <= 10);  // about one for each line of the grid
  CHECK(length_of(t) == doctest::Approx(10));

  // A star of many edges, an edge given twice, a loop of two edges, a triangle.
  detail::flat_graph star{{{0, 0, 0}}, {}};
  for (int i = 1; i <= 101; ++i) {
    star.points.push_back({std::cos(i), std::sin(i), 0});
    star.edges.push_back({0, static_cast<std::uint32_t>(i)});
  }
  CHECK(edges_of(detail::graph_lines_of(star)).size() == 101);
  CHECK(detail::graph_lines_of(star).lines.ends.size() == 51);
  const detail::flat_graph twice{{{0, 0, 0}, {1, 0, 0}}, {{0, 1}, {0, 1}}};
  CHECK(edges_of(detail::graph_lines_of(twice)).size() == 2);
  const detail::flat_graph triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1}, {1, 2}, {2, 0}}};
  CHECK(detail::graph_lines_of(triangle).lines.closed == std::vector<std::uint8_t>{1});
  CHECK(edges_of(detail::graph_lines_of(triangle)).size() == 3);
}

TEST_CASE_TEMPLATE("make_graph_tubes: draws the edges of meshes and of bare graphs", M, polygonmesh, hexmesh) {
  const M m = testing::grid<M>(2);
  const drawable d = make_graph_tubes(m, {.radius = 0.01});
  check_closed(d);
  double length = 0, farthest = 0;
  for (const auto e : edges(m)) {
    const auto [v, w] = end_verts(m, e);
    length += distance(to_vec3(point(m, v)), to_vec3(point(m, w)));
  }
  CHECK(testing::area_of(d) == doctest::Approx(2 * 3.14159265 * 0.01 * length).epsilon(0.1));
  for (const vec3& p : d.points) {
    double nearest = 1;
    for (const auto e : edges(m)) {
      const auto [v, w] = end_verts(m, e);
      const vec3 a = to_vec3(point(m, v)), b = to_vec3(point(m, w));
      nearest = std::min(nearest, distance(p, a + (b - a) * std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0)));
    }
    farthest = std::max(farthest, nearest);
  }
  CHECK(farthest == doctest::Approx(0.01).epsilon(0.04));
  CHECK(make_graph_tubes(only_embedded_graph(m), {.radius = 0.01}).points.size() == d.points.size());

  const auto on_border = [&](const auto& e) { return is_boundary(m, e); };
  std::vector<edge_t<M>> border;
  for (const auto e : edges(m))
    if (on_border(e)) border.push_back(e);
  const drawable part = make_graph_tubes(m, on_border, {.radius = 0.01});
  check_closed(part);
  CHECK(part.points == make_graph_tubes(m, border, {.radius = 0.01}).points);
  if constexpr (dimension_v<M> == 2) CHECK(testing::euler_characteristic(part) == 0);
  CHECK(make_graph_tubes(M{}).triangles.empty());
}

TEST_CASE("make_graph_tubes: skeletons with radii, values by vert, and verts without edges") {
  skeleton k({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {5, 5, 5}}, {{vert_id{0}, vert_id{1}}, {vert_id{1}, vert_id{2}}, {vert_id{1}, vert_id{3}}},
             {0.1, 0.2, 0.1, 0.1, 0.3});
  const std::vector<double> values = {0, 1, 2, 3, 4};
  const drawable d = make_graph_tubes(k, {.values = values, .radii = k.radii(), .corners = 16});
  check_closed(d);
  CHECK(testing::euler_characteristic(d) == 2 * 3);
  for (std::size_t i = 0; i < d.points.size(); ++i)
    if (distance(d.points[i], {5, 5, 5}) < 1) {
      CHECK(d.values[i] == 4);
      CHECK(distance(d.points[i], {5, 5, 5}) == doctest::Approx(0.3));
    }
  CHECK(d.look.scale.high() == 4);
  CHECK_THROWS_AS(make_graph_tubes(k, {.values = std::span(values).first(3)}), invalid_argument);
  CHECK_THROWS_AS(make_graph_tubes(k, {.radii = std::span(values).first(3)}), invalid_argument);
  const vec3 bad{0, std::numeric_limits<double>::infinity(), 0};
  k.set_point(vert_id{4}, bad);
  CHECK_THROWS_AS(make_graph_tubes(k), invalid_mesh);
  CHECK(!make_graph_tubes(k, [](edge_id) { return true; }).triangles.empty());
  k.set_point(vert_id{3}, bad);
  CHECK_THROWS_AS(make_graph_tubes(k, [](edge_id) { return true; }), invalid_mesh);
}
