#include <concino/repair/repair.hpp>

#include <concino/edit/elements.hpp>
#include <concino/edit/flip_winding.hpp>
#include <concino/edit/garbage_collect.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/unite.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/geometry/self_intersections.hpp>
#include <concino/validate.hpp>

#include <support/kinds.hpp>
#include <support/same_mesh.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// The volume inside a closed surface of triangles.
double volume_in(const trimesh& m) {
  double six = 0;
  for (const auto p : polys(m)) {
    vec3 x[3];
    int n = 0;
    for (const auto v : adj_p2v(m, p)) x[n++] = point(m, v);
    six += dot(x[0], cross(x[1], x[2]));
  }
  return six / 6;
}

trimesh moved(trimesh m, const vec3& by, double scale = 1) {
  for (const auto v : verts(m)) set_point(m, v, scale * point(m, v) + by);
  return m;
}
trimesh ball() { return icosphere(1); }

const trimesh tet_surface({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});

}  // namespace

TEST_CASE("repair: polys are wound like most of their component, and outward where it is closed") {
  trimesh m = ball();
  const double volume = volume_in(m);
  for (const unsigned p : {3u, 17u, 60u}) flip_winding(m, poly_id{p});
  const auto fix = repair(m, {.orient = true});
  CHECK(fix.count(repair_kind::turned_polys) == 3);
  CHECK(fix.records[0].elements == std::vector<std::uint32_t>{3, 17, 60});
  CHECK(fix.done == std::vector<std::string>{"3 polys were turned: polys 3, 17 and 60"});
  CHECK(record_of(m) == record_of(ball()));
  flip_winding(m);
  CHECK(volume_in(m) == doctest::Approx(-volume));
  CHECK(repair(m).done.empty());
  CHECK(repair(m, {.orient = true}).count(repair_kind::turned_polys) == num_polys(m));
  CHECK(volume_in(m) == doctest::Approx(volume));
  for (const double scale : {1e-200, 1e200}) {
    trimesh scaled = moved(m, {0, 0, 0}, scale);
    CHECK(repair(scaled, {.orient = true}).done.empty());
    flip_winding(scaled);
    CHECK(repair(scaled, {.orient = true}).count(repair_kind::turned_polys) == num_polys(m));
  }
  // open ones stay as most of their polys are
  trimesh open = grid<trimesh>(3);
  flip_winding(open);
  flip_winding(open, poly_id{4});
  CHECK(repair(open, {.orient = true}).records[0].elements == std::vector<std::uint32_t>{4});
}

TEST_CASE("repair: cavities stay inward, balls in them and beside them become outward") {
  trimesh outer = moved(ball(), {0, 0, 0}, 10), cavity = moved(ball(), {0, 0, 0}, 5), inner = ball(), beside = moved(ball(), {30, 0, 0});
  flip_winding(cavity);
  const trimesh hollow = unite(unite(outer, cavity), unite(inner, beside));
  trimesh m = hollow;
  CHECK(repair(m, {.orient = true}).done.empty());
  flip_winding(inner), flip_winding(beside), flip_winding(outer);
  m = unite(unite(outer, cavity), unite(inner, beside));
  CHECK(repair(m, {.orient = true}).count(repair_kind::turned_polys) == 3 * num_polys(inner));
  CHECK(record_of(m) == record_of(hollow));
}

TEST_CASE("repair: a one-sided strip is left, and the result says so") {
  std::vector<vec3> points;
  std::vector<std::vector<unsigned>> quads;
  for (unsigned i = 0; i < 12; ++i) {
    const double a = i * 3.14159265358979 / 6, b = a / 2;
    for (const double r : {-0.4, 0.4}) points.push_back({(2 + r * std::cos(b)) * std::cos(a), (2 + r * std::cos(b)) * std::sin(a), r * std::sin(b)});
  }
  for (unsigned i = 0; i < 12; ++i)
    quads.push_back(i < 11 ? std::vector<unsigned>{2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1} : std::vector<unsigned>{22, 1, 0, 23});
  quadmesh m(points, quads);
  REQUIRE(!validate(m).facts.orientable);
  const auto before = record_of(m);
  const auto fix = repair(m, {.orient = true});
  CHECK(fix.done.empty());
  CHECK(fix.count(repair_kind::one_sided) == 1);
  CHECK(fix.left.size() == 1);
  CHECK(record_of(m) == before);
}

TEST_CASE("repair: non-manifold edges and verts are split into fans") {
  // two tets that share an edge, and a third that shares a vert
  trimesh m = unite(tet_surface, moved(tet_surface, {1, 0, 0}, -1));       // share the edge from 0 to 1
  m = unite(m, moved(tet_surface, {0, 0, 1}));
  REQUIRE(!validate(m).facts.manifold);
  const std::size_t before = num_verts(m);
  const auto fix = repair(m, {.split_non_manifold = true});
  const auto report = validate(m);
  CHECK(report.is_clean());
  CHECK(report.facts.manifold);
  CHECK(report.facts.closed);
  CHECK(report.facts.components == 3);
  CHECK(num_verts(m) == before + 3);
  CHECK(fix.count(repair_kind::split_verts) == 3);
  // a fin on a sheet comes off
  trimesh sheet = grid<trimesh>(4);
  for (const auto e : edges(sheet)) {
    if (is_boundary(sheet, e)) continue;
    const auto ends = end_verts(sheet, e);
    add_poly(sheet, {ends.first, ends.second, add_vert(sheet, {0.5, 0.5, 1})});
    break;
  }
  REQUIRE(!validate(sheet).facts.manifold);
  repair(sheet, {.split_non_manifold = true});
  CHECK(validate(sheet).is_clean());
  CHECK(validate(sheet).facts.components == 2);
}

TEST_CASE_TEMPLATE("repair: holes are filled up to their size, with minimal area or fans", M, trimesh, polygonmesh) {
  const M whole = grid<M>(7);
  for (const auto how : {hole_filling::minimal_area, hole_filling::fan}) {
    M m = whole;
    // all polys around a vert in the middle
    vert_id inner{0};
    for (const auto v : verts(m))
      if (distance(point(m, v), {0.5, 0.5, 0}) < distance(point(m, inner), {0.5, 0.5, 0})) inner = v;
    std::vector<poly_id> around;
    for (const auto p : adj_v2p(m, inner)) around.push_back(p);
    for (const auto p : around) remove_poly(m, p);
    remove_vert(m, inner);
    const double area = total_measure(whole);
    REQUIRE(validate(m).facts.boundary_loops == 2);
    CHECK(repair(m, {.fill_holes = 3, .filling = how}).done.empty());
    const auto fix = repair(m, {.fill_holes = 12, .filling = how});
    CHECK(fix.count(repair_kind::filled_holes) == 1);
    const auto report = validate(m);
    CHECK(report.is_clean());
    CHECK(report.facts.boundary_loops == 1);
    CHECK(report.facts.euler_characteristic == 1);
    CHECK(total_measure(m) == doctest::Approx(area));
    CHECK(num_verts(m) == num_verts(whole) - (how == hole_filling::minimal_area));
    CHECK(check_laws(m).empty());
  }
}

TEST_CASE("repair: the filling of minimal area is that of all triangulations; nothing is doubled") {
  // a bent hexagon: of the 14 triangulations, the smallest one
  trimesh m = icosphere(2);
  std::vector<poly_id> around;
  for (const auto p : adj_v2p(m, vert_id{40})) around.push_back(p);
  for (const auto p : around) remove_poly(m, p);
  const double before = total_measure(m);
  repair(m, {.fill_holes = 6});
  CHECK(validate(m).is_clean());
  CHECK(validate(m).facts.closed);
  CHECK(total_measure(m) > before);
  // the only poly would be there twice
  trimesh alone({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const auto fix = repair(alone, {.fill_holes = 3});
  CHECK(fix.done.empty());
  CHECK(fix.count(repair_kind::left_hole) == 1);
  // diagonals that are edges already are not used: without its base, a pyramid over a square with one diagonal strut
  trimesh tent({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}, {0.5, 0.5, -1}},
               {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 2, 5}, {2, 0, 5}});
  repair(tent, {.remove_duplicates = false, .fill_holes = 4});
  CHECK(validate(tent).count(defect_kind::non_manifold_edge) == 0);
  // quads are filled by a quad
  quadmesh quads = grid<quadmesh>(3);
  remove_poly(quads, poly_id{4});
  CHECK(repair(quads, {.fill_holes = 4}).count(repair_kind::filled_holes) == 1);
  CHECK(validate(quads).is_clean());
  CHECK(num_polys(quads) == 9);
}

TEST_CASE("repair: triangles without area are removed or collapsed; no point moves") {
  // vert 4 lies on the edge from 0 to 1; verts 5 and 6 are at one point
  const trimesh bad({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -2, 0}, {1, 0, 0}, {3, 1, 0}, {3, 1, 0}},
                    {{0, 1, 2}, {1, 0, 4}, {0, 3, 4}, {4, 3, 1}, {1, 5, 2}, {5, 6, 2}, {1, 3, 6}, {1, 6, 5}});
  REQUIRE(validate(bad).count(defect_kind::zero_size) == 4);  // three triangles and an edge
  trimesh m = bad;
  CHECK(repair(m).done.empty());
  CHECK(repair(m, {.degenerate = degenerate_elements::remove}).count(repair_kind::removed_degenerate) == 3);
  CHECK(num_polys(m) == 5);
  m = bad;
  const auto fix = repair(m, {.degenerate = degenerate_elements::collapse});
  CHECK(fix.count(repair_kind::collapsed_degenerate) == 1);
  CHECK(validate(m).is_clean());
  CHECK(num_verts(m) == 6);
  CHECK(num_polys(m) == 6);
  CHECK(validate(m).facts.boundary_loops == 1);
  for (const auto v : verts(m)) CHECK(point(m, v) == point(bad, vert_id{fix.from.verts[v.raw()][0].index}));
  polygonmesh polygons({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 0, 0}}, {{0, 1, 2, 3}, {1, 0, 4}});
  repair(polygons, {.degenerate = degenerate_elements::collapse});
  CHECK(validate(polygons).is_clean());
  CHECK(num_polys(polygons) == 1);
}

TEST_CASE("repair: polys that intersect others are reported, or removed and their holes filled") {
  trimesh m = icosphere(2);
  set_point(m, vert_id{40}, -1.5 * point(m, vert_id{40}));
  const auto pairs = self_intersections(m);
  REQUIRE(!pairs.empty());
  const auto before = record_of(m);
  auto fix = repair(m, {.intersecting = intersecting_triangles::report});
  CHECK(fix.count(repair_kind::intersecting) > 1);
  CHECK(fix.done.empty());
  CHECK(record_of(m) == before);
  fix = repair(m, {.intersecting = intersecting_triangles::remove});
  CHECK(fix.count(repair_kind::removed_intersecting) > 1);
  CHECK(fix.count(repair_kind::left_hole) == 0);
  CHECK(self_intersections(m).empty());
  CHECK(validate(m).is_clean());
  CHECK(validate(m).facts.closed);
  CHECK(validate(m).facts.components == 1);
}
