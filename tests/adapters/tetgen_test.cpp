#include <concino/adapters/tetgen.hpp>

#include <concino/generate/box.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/generate/torus.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/edge_length.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/validate/check_laws.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

using namespace concino;

namespace {

/// Twice a surface: as it is, and scaled, with its polys reversed or not.
trimesh nested(const trimesh& m, double scale, bool reversed) {
  surface_arrays a{{}, {}, {}, 3};
  for (const double s : {1.0, scale}) {
    const auto first = static_cast<unsigned>(a.points.size());
    for (const auto v : verts(m)) a.points.push_back(s * point(m, v));
    for (const auto p : polys(m)) {
      const auto begin = static_cast<std::ptrdiff_t>(a.verts.size());
      for (const auto v : adj_p2v(m, p)) a.verts.push_back(vert_id{first + v.raw()});
      if (s != 1 && reversed) std::reverse(a.verts.begin() + begin, a.verts.end());
    }
  }
  return trimesh(std::move(a));
}

double largest_volume(const tetmesh& m) {
  double v = 0;
  for (const auto p : polys(m)) v = std::max(v, measure(m, p));
  return v;
}

bool are_joined(const tetmesh& m, vert_id a, vert_id b) {
  for (const auto v : adj_v2v(m, a))
    if (v == b) return true;
  return false;
}

trimesh cube() { return make_box<trimesh>({.cells = {2, 2, 2}}); }

}  // namespace

TEST_CASE_TEMPLATE("tetgen: fills surfaces of any polygons, with their boundary kept or refined", M, trimesh, quadmesh, polygonmesh) {
  for (const bool keep : {true, false})
    for (const bool quality : {true, false}) {
      const M m = make_torus<M>({.cells = {12, 6}});
      const auto t = tetrahedralize(m, tetgen, {.radius_edge = quality ? 2.0 : 0.0, .keep_boundary = keep});
      CHECK(check_laws(t.mesh).empty());
      for (const auto v : verts(m)) CHECK(point(t.mesh, t.vert_of(v)) == point(m, v));
      std::set<unsigned> covered;
      std::size_t boundary = 0;
      for (const auto f : faces(t.mesh)) {
        CHECK(t.poly_of(f).has_value() == is_boundary(t.mesh, f));
        if (!t.poly_of(f)) continue;
        ++boundary;
        covered.insert(t.poly_of(f)->raw());
      }
      CHECK(covered.size() == num_polys(m));
      std::size_t triangles = 0;
      for (const auto p : polys(m)) triangles += num_elements(adj_p2v(m, p)) - 2;
      if (keep) CHECK(boundary == triangles);
    }
}

TEST_CASE("tetgen: volumes, edge lengths and shapes that are asked for") {
  const trimesh m = cube();
  const auto fine = tetrahedralize(m, tetgen, {.max_volume = 1e-3, .keep_boundary = false});
  CHECK(largest_volume(fine.mesh) <= 1e-3);
  CHECK(fine.report.beyond_max_volume.empty());
  const auto kept = tetrahedralize(m, tetgen, {.max_volume = 1e-3});  // near the boundary, which is kept, tets stay large
  CHECK(std::count_if(polys(kept.mesh).begin(), polys(kept.mesh).end(), [&](const auto p) { return measure(kept.mesh, p) > 1e-3; }) ==
        static_cast<std::ptrdiff_t>(kept.report.beyond_max_volume.size()));
  CHECK(total_measure(fine.mesh) == doctest::Approx(total_measure(tetrahedralize(m, tetgen).mesh)).epsilon(1e-9));
  const auto length = [](const vec3& p) { return p.x < 0.5 ? 0.2 : 1.0; };
  const auto graded = tetrahedralize(m, tetgen, {.edge_length = length, .keep_boundary = false});
  std::vector<poly_id> longer;
  double longest = 0;  // beside what was asked for
  for (const auto p : polys(graded.mesh)) {
    double here = 0;
    for (const auto e : adj_p2e(graded.mesh, p)) here = std::max(here, edge_length(graded.mesh, e) / length(centroid(graded.mesh, p)));
    if (here > 1) longer.push_back(p);
    longest = std::max(longest, here);
  }
  CHECK(longest < 1.1);  // TetGen improves shapes at the end, and makes a few edges longer
  CHECK(graded.report.beyond_edge_length == longer);
  CHECK(longer.size() * 50 < num_polys(graded.mesh));
  const auto good = tetrahedralize(m, tetgen, {.radius_edge = 2, .min_dihedral_deg = 12, .keep_boundary = false});
  CHECK(good.report.beyond_radius_edge.empty());
  CHECK(good.report.beyond_min_dihedral.size() * 20 < num_polys(good.mesh));  // TetGen tries
}

TEST_CASE("tetgen: the report says in a sentence what was not met, and which option helps") {
  const trimesh m = cube();
  const auto kept = tetrahedralize(m, tetgen, {.max_volume = 1e-3});
  const std::string tets = std::to_string(num_polys(kept.mesh)), missed = std::to_string(kept.report.beyond_max_volume.size());
  CHECK(kept.report.beyond_max_volume.size() > 0);
  CHECK(kept.report.not_met == "Of " + tets + " tets, " + missed +
                                   " are larger than max_volume; the boundary is kept as it is, and keep_boundary = false lets it get more verts.");
  CHECK(tetrahedralize(m, tetgen, {.max_volume = 1e-3, .keep_boundary = false}).report.not_met.empty());
  CHECK(tetrahedralize(m, tetgen).report.not_met.empty());
}

TEST_CASE("tetgen: extra points, segments and facets are in the result") {
  const trimesh m = cube();
  const auto box = tetrahedralize(m, tetgen).mesh;
  vec3 low = {9, 9, 9}, high = {-9, -9, -9};
  for (const auto v : verts(box))
    for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], point(box, v)[k]), high[k] = std::max(high[k], point(box, v)[k]);
  const auto at = [&](double x, double y, double z) { return vec3{low.x + x * (high.x - low.x), low.y + y * (high.y - low.y), low.z + z * (high.z - low.z)}; };
  const std::vector<vec3> extra = {at(0.2, 0.3, 0.4), at(0.8, 0.7, 0.6), at(0.6, 0.2, 0.3), at(5, 5, 5)};
  const auto n = static_cast<std::uint32_t>(num_verts(m));
  const std::vector<std::array<std::uint32_t, 2>> segment = {{n, n + 1}};
  const std::vector<std::array<std::uint32_t, 3>> facet = {{n, n + 1, n + 2}};
  const auto t = tetrahedralize(m, tetgen, {.extra_points = extra, .segments = segment, .facets = facet});
  REQUIRE(t.extra_verts.size() == 4);
  for (std::size_t i = 0; i < 3; ++i) CHECK(point(t.mesh, t.extra_verts[i]) == extra[i]);
  CHECK(t.extra_verts[3].is_none());  // outside
  CHECK(are_joined(t.mesh, t.extra_verts[0], t.extra_verts[1]));
  CHECK(are_joined(t.mesh, t.extra_verts[1], t.extra_verts[2]));
  bool found = false;
  for (const auto f : faces(t.mesh)) {
    std::set<unsigned> corners;
    for (const auto v : adj_f2v(t.mesh, f)) corners.insert(v.raw());
    found = found || corners == std::set{t.extra_verts[0].raw(), t.extra_verts[1].raw(), t.extra_verts[2].raw()};
  }
  CHECK(found);
}

TEST_CASE("tetgen: cavities by orientation, holes and regions by a point") {
  const trimesh ball = make_sphere<trimesh>({.cells = 3});
  const double whole = total_measure(tetrahedralize(ball, tetgen).mesh), part = whole / 8;
  const trimesh with_cavity = nested(ball, 0.5, true), with_wall = nested(ball, 0.5, false);
  CHECK(total_measure(tetrahedralize(with_cavity, tetgen).mesh) == doctest::Approx(whole - part).epsilon(1e-9));
  CHECK(total_measure(tetrahedralize(with_wall, tetgen).mesh) == doctest::Approx(whole).epsilon(1e-9));
  const std::vector<vec3> hole = {{0, 0, 0}};
  const auto emptied = tetrahedralize(with_wall, tetgen, {.holes = hole});
  CHECK(total_measure(emptied.mesh) == doctest::Approx(whole - part).epsilon(1e-9));
  const std::vector<tet_region> regions = {{{0, 0, 0}, 4, 1e-3}, {{0, 0, 0.7}, 9}};
  const auto t = tetrahedralize(with_wall, tetgen, {.keep_boundary = false, .regions = regions});
  double inner = 0;
  std::size_t larger = 0;
  for (const auto p : polys(t.mesh)) {
    const bool is_inside = norm(centroid(t.mesh, p)) < 0.49;
    if (is_inside) CHECK(t.labels[p.raw()] == 4);
    if (t.labels[p.raw()] == 4) {
      inner += measure(t.mesh, p);
      CHECK(measure(t.mesh, p) <= 1e-3 * (1 + 1e-9));
    } else {
      CHECK(t.labels[p.raw()] == 9);
      larger += measure(t.mesh, p) > 1e-3;
    }
  }
  CHECK(t.report.beyond_max_volume.empty());
  CHECK(inner == doctest::Approx(part).epsilon(1e-9));
  CHECK(larger > 0);
}

TEST_CASE("tetgen: results do not depend on the process, and are the same each time") {
  const trimesh m = make_sphere<trimesh>({.cells = 3});
  const auto a = tetrahedralize(m, tetgen, {.radius_edge = 1.5}), b = tetrahedralize(m, tetgen, {.radius_edge = 1.5, .in_process = true});
  REQUIRE(num_verts(a.mesh) == num_verts(b.mesh));
  REQUIRE(num_polys(a.mesh) == num_polys(b.mesh));
  for (const auto v : verts(a.mesh)) CHECK(point(a.mesh, v) == point(b.mesh, v));
  for (const auto p : polys(a.mesh)) CHECK(std::equal(adj_p2v(a.mesh, p).begin(), adj_p2v(a.mesh, p).end(), adj_p2v(b.mesh, p).begin()));
}
