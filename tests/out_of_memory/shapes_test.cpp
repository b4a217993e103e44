// Circles, kernels, widths, bones, tubes, skeletons and UV maps of surfaces that run out of memory throw std::bad_alloc and leak nothing.
#include <concino/geometry/enclosing_ball.hpp>
#include <concino/geometry/inscribed_circle.hpp>
#include <concino/geometry/kernel.hpp>
#include <concino/geometry/width.hpp>
#include <concino/generate/torus.hpp>
#include <concino/graph/min_cut.hpp>
#include <concino/graph/segment.hpp>
#include <concino/mesh.hpp>
#include <concino/parametrize.hpp>
#include <concino/skeleton.hpp>

#include <support/failing_allocations.hpp>
#include <support/kinds.hpp>
#include <support/polygons.hpp>
#include <support/skeletons.hpp>
#include <support/threads.hpp>

#include <doctest/doctest.h>

#include <cstddef>

using namespace concino;

namespace {

/// Runs find() with failing allocations, and checks that it has the same result whenever none fails.
template<class F>
void check_failures(const F& find, std::size_t sparsity = 0) {
  const auto expected = find();
  std::size_t wrong = 0;
  const auto result = testing::for_each_failing_allocation(
      [&](const auto& attempt) {
        auto found = decltype(find()){};
        if (!attempt([&] { found = find(); })) wrong += found != expected;
      },
      sparsity);
  CHECK(result.failed > 2);
  CHECK(result.leaks == 0);
  CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("circles, kernels and widths that run out of memory") {
  const auto comb = testing::comb_polygon(1, 2), star = testing::star_polygon(7, 0.4);
  for (const auto& x : {comb, star}) {
    check_failures([&] { return inscribed_circle(x, {.tolerance = 1e-3}).radius; });
    check_failures([&] { return enclosing_circle(x).radius; });
    check_failures([&] { return kernel(x).area; });
    check_failures([&] { return width(x).direction; });
  }
  const auto cells = testing::grid<polyhedralmesh>(1);
  check_failures([&] { return kernel(cells, poly_id{0}).volume; });
  check_failures([&] { return width(cells, poly_id{0}).width; });
  check_failures([&] { return enclosing_ball(cells).radius; });
}

TEST_CASE("cuts that run out of memory") {
  const auto m = testing::grid<quadmesh>(2);
  const auto cost = [](poly_id p, int l) { return static_cast<double>((p.raw() + static_cast<unsigned>(l)) % 3); };
  check_failures([&] { return min_cut(m, poly_id{0}, poly_id{3}, [](auto, auto) { return 1.0; }).capacity + 1; });
  for (const label_moves moves : {label_moves::expansion, label_moves::swap})
    check_failures([&] { return segment_polys(m, cost, {.labels = 3, .smoothness = 0.25, .moves = moves}).rounds; });
}

TEST_CASE("curve skeletons that run out of memory") {
  const testing::with_num_threads one(1);
  const skeleton k = testing::theta_skeleton(), y = testing::y_skeleton();
  check_failures([&] { return bones(k).size(); });
  check_failures([&] { return respace(y, 0.5).num_verts(); });
  check_failures([&] { return split_bone(y, bones(y)[0], 0.3).result.num_verts(); });
  check_failures([&] { return num_polys(tube(y)); }, 20);
  const auto torus = make_torus<trimesh>({.cells = {9, 4}, .tube_radius = 0.2});
  check_failures([&] { return skeleton_of(torus).skeleton.points(); }, 10);
  const auto nodes = bones(y);
  check_failures([&] { return nearest_bone(torus, nodes)[vert_id{3}] + 1; });
}

TEST_CASE("UV maps that run out of memory") {
  const testing::with_num_threads one(1);
  auto arrays = testing::polygon_grid(2);
  for (vec3& x : arrays.points) x.z = x.x * x.y;
  const polygonmesh m(arrays);
  const auto place = [&](const auto& uv) { return uv[vert_id{7}]; };
  const auto start = lscm(m);
  check_failures([&] { return place(tutte(m).uv); });
  check_failures([&] { return place(lscm(m)); });
  check_failures([&] { return place(spectral_conformal(m)); }, 5);
  check_failures([&] { return place(arap_map(m, {.max_iterations = 1}).uv); }, 5);
  check_failures([&] { return place(injective_map(m, start, {.max_iterations = 1}).uv); }, 5);
  check_failures([&] { return map_distortion(m, start).max_angle; });
}
