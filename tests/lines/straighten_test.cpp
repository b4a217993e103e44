#include <concino/lines/straighten.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/fields/exact_geodesics.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/torus.hpp>
#include <concino/geometry/edge_length.hpp>
#include <concino/graph/homology.hpp>
#include <concino/graph/shortest_path.hpp>

#include <support/corpus.hpp>
#include <support/geodesic_errors.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M>
double length_of(const M& m, const std::vector<vert_id>& path) {
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += distance(point(m, path[i - 1]), point(m, path[i]));
  return sum;
}

template<class M>
double sum_of_pieces(const geodesic_path<M>& g, bool closed = false) {
  double sum = closed && g.points.size() > 1 ? distance(g.points.back().position, g.points.front().position) : 0;
  for (std::size_t i = 1; i < g.points.size(); ++i) sum += distance(g.points[i - 1].position, g.points[i].position);
  return sum;
}

}  // namespace

TEST_CASE_TEMPLATE("straighten: makes paths on the plane straight", M, trimesh, polygonmesh) {
  const M m = square_or_cube<M>(9);
  std::mt19937 random(3);
  for (int k = 0; k < 20; ++k) {
    const vert_id v{static_cast<unsigned>(random() % num_verts(m))}, w{static_cast<unsigned>(random() % num_verts(m))};
    const auto path = shortest_path(m, v, w);
    const auto g = straighten(m, path);
    CHECK(g.length <= length_of(m, path) * (1 + 1e-12));
    CHECK(sum_of_pieces(g) == doctest::Approx(g.length).epsilon(1e-10));
    const double apart = distance(point(m, v), point(m, w));
    CHECK(g.points.front().position == point(m, v));
    CHECK(g.points.back().position == point(m, w));
    bool is_inside = true;  // the straight line, if the square has a boundary that is not
    for (const auto& x : g.points) is_inside = is_inside && norm(cross(x.position - point(m, v), point(m, w) - point(m, v))) < 1e-9;
    CHECK((is_inside ? g.length == doctest::Approx(apart).epsilon(1e-12) : g.length > apart));
  }
}

TEST_CASE("straighten: ends in shortest paths where they can be reached") {
  const trimesh m = bumpy_ball(3);
  const auto prepared = prepare_straighten(m);
  const auto exact = prepare_exact_geodesics(m);
  std::mt19937 random(5);
  int shortest = 0;
  const int n = long_run() ? 300 : 40;
  for (int k = 0; k < n; ++k) {
    const vert_id v{static_cast<unsigned>(random() % num_verts(m))}, w{static_cast<unsigned>(random() % num_verts(m))};
    const auto path = shortest_path(m, v, w);
    const auto g = prepared.straighten(path);
    const double least = exact.path_between(v, w).length;
    CHECK(g.length <= length_of(m, path) * (1 + 1e-12));
    CHECK(g.length >= least * (1 - 1e-10));
    CHECK(sum_of_pieces(g) == doctest::Approx(g.length).epsilon(1e-9));
    shortest += g.length <= least * (1 + 1e-10);
  }
  CHECK(shortest > 0.7 * n);
}

TEST_CASE("straighten: closes loops") {
  const trimesh m = make_torus<trimesh>({.cells = {24, 12}});
  // A loop that winds around the inner side of the torus over the top of the tube.
  double radius = 1e9;
  vert_id inner{0};
  for (const vert_id v : verts(m))
    if (const double r = std::hypot(point(m, v).x, point(m, v).y); r < radius) {
      radius = r;
      inner = v;
    }
  std::vector<vert_id> loop;
  const auto far = nearest(m, {-point(m, inner).x, -point(m, inner).y, 0.6}), left = nearest(m, {-1.6 * point(m, inner).y, 1.6 * point(m, inner).x, 0.5}),
             right = nearest(m, {1.6 * point(m, inner).y, -1.6 * point(m, inner).x, 0.5});
  for (const auto& [a, b] : {std::pair(inner, left), std::pair(left, far), std::pair(far, right), std::pair(right, inner)}) {
    const auto part = shortest_path(m, a, b);
    loop.insert(loop.end(), part.begin(), part.end());
  }
  const auto g = straighten(m, loop, {.closed = true});
  CHECK(sum_of_pieces(g, true) == doctest::Approx(g.length).epsilon(1e-9));
  CHECK(g.length < 2 * std::numbers::pi * radius * 1.001);  // the circle around the hole
  CHECK(g.length > 2 * std::numbers::pi * radius * 0.9);

  // Loops that cannot shrink to a vert, with parts that are passed twice.
  for (const auto& walk : homology_generators(m)) {
    const auto straight = straighten(m, walk.verts, {.closed = true});
    double before = 0;
    for (const edge_id e : walk.edges) before += edge_length(m, e);
    CHECK(straight.length <= before * (1 + 1e-12));
    CHECK(straight.length > 2);
    CHECK(sum_of_pieces(straight, true) == doctest::Approx(straight.length).epsilon(1e-9));
  }

  // A loop about a vert shrinks to nothing.
  std::vector<vert_id> ring;
  const trimesh square = grid<trimesh>(3);
  for (const unsigned v : {0u, 1u, 2u, 6u, 10u, 9u, 8u, 4u}) ring.push_back(vert_id{v});
  const auto gone = straighten(square, ring, {.closed = true});
  CHECK(gone.points.empty());
  CHECK(gone.length == 0);
}

TEST_CASE("straighten: removes detours, keeps short paths, and works on an archetype") {
  const quadmesh m = grid<quadmesh>(3);
  const auto there_and_back = straighten(m, {vert_id{0}, vert_id{1}, vert_id{2}, vert_id{1}, vert_id{0}});
  CHECK(there_and_back.points.size() == 1);
  CHECK(there_and_back.length == 0);
  CHECK(straighten(m, std::vector<vert_id>()).points.empty());
  CHECK(straighten(m, {vert_id{4}}).length == 0);
  const auto edge = straighten(m, {vert_id{4}, vert_id{5}});
  CHECK(edge.points.size() == 2);
  CHECK(edge.length == doctest::Approx(1.0 / 3));
  const auto diagonal = straighten(m, {vert_id{0}, vert_id{1}, vert_id{5}, vert_id{6}, vert_id{10}, vert_id{11}, vert_id{15}});
  CHECK(diagonal.length == doctest::Approx(std::sqrt(2.0)).epsilon(1e-12));
  const auto weak = only_embedded_mesh(m);
  const auto same = straighten(weak, {weak.vert(vert_id{0}), weak.vert(vert_id{1}), weak.vert(vert_id{5}), weak.vert(vert_id{9})});
  CHECK(same.length == doctest::Approx(std::hypot(1, 2) / 3).epsilon(1e-12));
}

TEST_CASE("straighten: throw if an argument or the mesh is invalid") {
  const trimesh m = grid<trimesh>(2);
  CHECK_THROWS_WITH_AS(straighten(m, {vert_id{0}, vert_id{99}}), "straighten: the path has a vert that is not one of the mesh; take it from verts(m)", invalid_mesh);
  CHECK_THROWS_WITH_AS(straighten(m, {vert_id{0}, vert_id{8}}), doctest::Contains("straighten: no edge with polys joins vert 0 to vert 8"), invalid_argument);
  const trimesh two_fans({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}});
  CHECK_THROWS_WITH_AS(straighten(two_fans, {vert_id{1}, vert_id{0}}), doctest::Contains("straighten: the polys at vert 0 are not one fan"), unsupported);
  const trimesh band({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}, {2, 0, 1}}, {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}});
  CHECK_THROWS_WITH_AS(straighten(band, {vert_id{0}, vert_id{1}}), doctest::Contains("straighten: the surface is not orientable"), unsupported);
}
