#include <concino/generate/subdivide_catmull_clark.hpp>

#include <concino/generate/box.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/sphere.hpp>

#include <support/kinds.hpp>
#include <support/subdivisions.hpp>

using namespace concino;
using namespace concino::testing;

TEST_CASE("subdivide_catmull_clark: a cube, by hand") {
  const quadmesh cube = make_box<quadmesh>({.cells = {1, 1, 1}, .min = {-1, -1, -1}, .max = {1, 1, 1}});
  const quadmesh s = subdivide_catmull_clark(cube);
  check_sound(s, 2);
  REQUIRE(num_polys(s) == 24);
  REQUIRE(num_verts(s) == 26);
  std::size_t corners = 0, middles = 0, centres = 0;
  for (const vert_id v : verts(s)) {
    const vec3 x = point(s, v);
    const double far = std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)});
    if (v.raw() < 8) {
      // (mean of polys + 2 mean of edges) / 3 = (1/3 + 2 * 2/3) / 3
      CHECK(norm(x - 5.0 / 9 * point(cube, v)) < 1e-15);
      ++corners;
    } else if (v.raw() < 20) {
      CHECK(far == doctest::Approx(0.75).epsilon(1e-15));
      ++middles;
    } else {
      CHECK(far == 1);
      ++centres;
    }
  }
  CHECK(corners == 8);
  CHECK(middles == 12);
  CHECK(centres == 6);
}

TEST_CASE_TEMPLATE("subdivide_catmull_clark: properties, correspondence, repetition", M, CONCINO_SURFACE_KINDS) {
  check_subdivision(grid<M>(1), [](const auto& m, const subdivide_options& o) { return subdivide_catmull_clark(m, o); });
}

TEST_CASE("subdivide_catmull_clark: creases and corners stay") {
  const quadmesh box = make_box<quadmesh>({.cells = {1, 1, 1}});
  auto crease = make_edge_map<int>(box, 1);
  const quadmesh s = subdivide_catmull_clark(box, crease, {.times = 3});
  check_sound(s, 2);
  CHECK(total_measure(s) == doctest::Approx(6).epsilon(1e-13));
  CHECK(enclosed_volume(s) == doctest::Approx(1).epsilon(1e-13));
  // A named property is a map too.
  quadmesh marked = box;
  const auto mark = edge_property<int>(marked, "crease");
  for (const edge_id e : edges(marked)) mark[e] = 1;
  CHECK(enclosed_volume(subdivide_catmull_clark(marked, find_edge_property<int>(marked, "crease"), {.times = 2})) == doctest::Approx(1).epsilon(1e-13));
  // A single crease ends smoothly: nothing is fixed, and every vert moves.
  for (const edge_id e : edges(box)) crease[e] = e.raw() == 0;
  const quadmesh d = subdivide_catmull_clark(box, crease);
  for (const vert_id v : verts(box)) CHECK(norm(point(d, v) - point(box, v)) > 0.05);
}

TEST_CASE("subdivide_catmull_clark: verts with two polys, and edges with three") {
  // Two quads on the same four verts: each vert has two edges and two polys.
  const quadmesh pillow(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, std::vector<std::vector<unsigned>>{{0, 1, 2, 3}, {3, 2, 1, 0}});
  correspondence c;
  const quadmesh s = subdivide_catmull_clark(pillow, {.times = 3, .correspondence = &c});
  CHECK(check_laws(s).empty());
  for (std::size_t i = 0; i < c.verts.size(); ++i)
    for (const origin x : c.verts[i]) CHECK(x.weight >= 0);
  const quadmesh fin(std::vector<vec3>{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 1}, {-1, 1, 0}, {-1, 1, 1}, {-1, -1, 0}, {-1, -1, 1}},
                     std::vector<std::vector<unsigned>>{{0, 2, 3, 1}, {0, 4, 5, 1}, {0, 6, 7, 1}});
  const quadmesh three = subdivide_catmull_clark(fin, {.times = 2});
  CHECK(check_laws(three).empty());
  CHECK(num_polys(three) == 48);
  for (const vert_id v : {vert_id{0u}, vert_id{1u}}) CHECK(norm(point(three, v) - point(fin, v)) < 1e-16);  // more than two creases meet there
}
