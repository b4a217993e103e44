#include <concino/fields/parallel_transport.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/solve/multigrid.hpp>

#include <support/geodesic_errors.hpp>
#include <support/tangents.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr vec3 up{0, 0, 1};

}  // namespace

TEST_CASE_TEMPLATE("parallel_transport: does not turn vectors on the plane", M, trimesh, polygonmesh) {
  const M m = square_or_cube<M>(10);
  const vert_id source = nearest(m, {0.3, 0.6, 0});
  const auto x = parallel_transport(m, {{source, {3, -4}}});
  const vec3 constant = in_space(m, source, up, {3, -4});
  for (const vert_id v : verts(m)) CHECK(norm(in_space(m, v, up, x[v]) - constant) < 1e-10);
}

TEST_CASE("parallel_transport: turns vectors with great circles on the sphere") {
  double before = 1;
  for (const unsigned k : {2u, 3u}) {
    const trimesh m = icosphere(k);
    const vert_id source{5};
    const vec3 from = point(m, source), at_source = in_space(m, source, from, {1, 0});
    const auto x = parallel_transport(m, std::map<vert_id, tangent_vector>{{source, {1, 0}}});
    double worst = 0;
    for (const vert_id v : verts(m)) {
      const vec3 to = point(m, v), axis = cross(from, to);
      if (dot(from, to) < -0.8 || v == source) continue;
      // turned about the axis by the arc between both verts
      const vec3 n = axis / norm(axis), beside = cross(n, at_source);
      const vec3 exact = dot(n, at_source) * n + dot(from, to) * (at_source - dot(n, at_source) * n) + norm(axis) * beside;
      worst = std::max(worst, norm(in_space(m, v, to, x[v]) - exact));
      CHECK(norm(x[v]) == doctest::Approx(1));
    }
    CHECK(worst < before);
    before = worst;
  }
  CHECK(before < 0.01);
}

TEST_CASE("parallel_transport: takes lengths and directions from the nearest source") {
  const trimesh m = square_or_cube<trimesh>(20);
  const vert_id left = nearest(m, {0, 0.5, 0}), right = nearest(m, {1, 0.5, 0});
  const auto x = parallel_transport(m, {{left, {2, 0}}, {right, {0, 5}}});
  const vec3 a = in_space(m, left, up, {2, 0}), b = in_space(m, right, up, {0, 5});
  for (const vert_id v : verts(m)) {
    const double at = point(m, v).x;
    if (std::abs(at - 0.5) < 0.2) continue;
    CHECK(norm(in_space(m, v, up, x[v]) - (at < 0.5 ? a : b)) < 0.06);
  }
  const auto transport = prepare_parallel_transport(m);
  const auto twice = transport.transport_from({{left, {4, 0}}, {right, {0, 10}}});
  for (const vert_id v : verts(m)) CHECK(norm(twice[v] - 2 * x[v]) < 1e-9);
  const auto none = transport.transport_from({{left, {0, 0}}});
  CHECK(none[right] == tangent_vector());
}

TEST_CASE("parallel_transport: work on an archetype") {
  const polygonmesh m = square_or_cube<polygonmesh>(3);
  const auto weak = only_embedded_mesh(m);
  const auto x = parallel_transport(m, {{vert_id{6}, {1, 2}}});
  const auto of_weak = parallel_transport(weak, {{weak.vert(vert_id{6}), {1, 2}}});
  for (const auto v : verts(weak)) CHECK(norm(of_weak[v] - x[weak.base(v)]) < 1e-9);
}

TEST_CASE("parallel_transport: throw if an argument or the mesh is invalid") {
  const trimesh m = grid<trimesh>(2);
  CHECK_THROWS_WITH_AS(parallel_transport(m, {{vert_id{9}, {1, 0}}}), "parallel_transport: a source is not a vert of the mesh; take it from verts(m)", invalid_mesh);
  const std::vector<std::pair<vert_id, tangent_vector>> none;
  CHECK_THROWS_WITH_AS(parallel_transport(m, none), "parallel_transport: there is no source; give at least one vert and its vector", invalid_argument);
  CHECK_THROWS_WITH_AS(parallel_transport(m, {{vert_id{1}, {std::nan(""), 0}}}), "parallel_transport: the vector at vert 1 is not finite", invalid_argument);
  CHECK_THROWS_AS(prepare_parallel_transport(m, {.time = std::numeric_limits<double>::infinity()}), invalid_argument);
  CHECK_THROWS_AS(prepare_parallel_transport(m, {}, multigrid()), unsupported);
  CHECK_THROWS_AS(prepare_parallel_transport(m, {.progress = [](double, auto) { return false; }}), cancelled);
  const trimesh empty;
  CHECK_THROWS_AS(parallel_transport(empty, {{vert_id{0}, {1, 0}}}), invalid_mesh);
}
