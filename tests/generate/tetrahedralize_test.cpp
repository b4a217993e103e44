#include <concino/generate/tetrahedralize.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/geometry/circumcentre.hpp>
#include <concino/geometry/dihedral_angles.hpp>
#include <concino/geometry/edge_length.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/profiled.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

using namespace concino;
using concino::testing::names_of;

namespace {

/// Fills surfaces that are star-shaped seen from a point: one tet for each triangle. `change` may spoil the result.
struct cone_back_end {
  vec3 apex = {0, 0, 0};
  std::function<void(tetrahedralize_output&)> change = nullptr;

  static const char* name() { return "the cone"; }
  tetrahedralize_output tetrahedralize(const tetrahedralize_input& in, const tetrahedralize_options&) const {
    tetrahedralize_output out{in.points, {}, {}, {}};
    const auto centre = static_cast<std::uint32_t>(out.points.size());
    out.points.push_back(apex);
    for (std::uint32_t i = 0; i < in.surface_triangles; ++i) {
      const auto& t = in.triangles[i];
      out.tets.push_back({t[0], t[1], t[2], centre});
      out.facets.push_back(t);
      out.triangle_of_facet.push_back(i);
    }
    if (change) change(out);
    return out;
  }
};

template<class M>
std::string refusal_of(const M& m, const tetrahedralize_options& o = {}) {
  try {
    tetrahedralize(m, cone_back_end{}, o);
  } catch (const invalid_mesh& e) {
    return std::string("invalid_mesh ") + e.what();
  } catch (const invalid_argument& e) {
    return std::string("invalid_argument ") + e.what();
  }
  return "";
}
bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

polygonmesh surface(std::vector<vec3> points, const std::vector<std::vector<unsigned>>& polygons) {
  surface_arrays a{std::move(points), {0}, {}};
  for (const auto& p : polygons) {
    for (const unsigned v : p) a.verts.push_back(vert_id{v});
    a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
  }
  return polygonmesh(std::move(a));
}
const std::vector<vec3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const std::vector<std::vector<unsigned>> sides = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
const cone_back_end in_corner{{0.2, 0.2, 0.2}};

}  // namespace

TEST_CASE_TEMPLATE("tetrahedralize: verts, boundary and volume of the surface", M, trimesh, quadmesh, polygonmesh) {
  const M m = make_sphere<M>({.cells = 3});
  const auto t = tetrahedralize(m, cone_back_end{});
  CHECK(check_laws(t.mesh).empty());
  CHECK(num_verts(t.mesh) == num_verts(m) + 1);
  for (const auto v : verts(m)) CHECK(point(t.mesh, t.vert_of(v)) == point(m, v));
  double area = 0, area_of_m = 0;
  std::size_t boundary_faces = 0, with_poly = 0;
  for (const auto f : faces(t.mesh)) {
    boundary_faces += is_boundary(t.mesh, f);
    with_poly += t.poly_of(f).has_value();
    if (!t.poly_of(f)) continue;
    area += measure(t.mesh, f);
    for (const auto v : adj_f2v(t.mesh, f)) {  // all corners of the face are corners of its poly
      bool found = false;
      for (const auto w : adj_p2v(m, *t.poly_of(f))) found = found || t.vert_of(w) == v;
      CHECK(found);
    }
  }
  CHECK(with_poly == boundary_faces);
  for (const auto p : polys(m)) area_of_m += measure(m, p);
  CHECK(area == doctest::Approx(area_of_m).epsilon(0.02));  // quads of the sphere are not planar
  std::vector<std::uint32_t> not_planar;
  for (const auto p : polys(m)) {
    std::vector<vec3> q;
    for (const auto v : adj_p2v(m, p)) q.push_back(point(m, v));
    const vec3 normal = cross(q[1] - q[0], q[2] - q[0]);
    if (std::any_of(q.begin(), q.end(), [&](const vec3& x) { return std::abs(dot(x - q[0], normal)) > 1e-6 * norm(normal); })) not_planar.push_back(p.raw());
  }
  CHECK(t.report.not_planar == not_planar);
  CHECK(t.labels.empty());
}

TEST_CASE("tetrahedralize: polys may be oriented in any way") {
  auto polygons = sides;
  for (const std::size_t i : {1u, 3u}) std::reverse(polygons[i].begin(), polygons[i].end());
  CHECK(total_measure(tetrahedralize(surface(corners, polygons), in_corner).mesh) == doctest::Approx(1.0 / 6));
  for (auto& p : polygons) std::reverse(p.begin(), p.end());
  CHECK(total_measure(tetrahedralize(surface(corners, polygons), in_corner).mesh) == doctest::Approx(1.0 / 6));
}

TEST_CASE("tetrahedralize: needs no more than its concepts promise") {
  const polygonmesh m = make_sphere<polygonmesh>({.cells = 2});
  const auto a = only_embedded_mesh(m);
  const auto t = tetrahedralize(a, cone_back_end{});
  const auto same = tetrahedralize(m, cone_back_end{});
  CHECK(num_polys(t.mesh) == num_polys(same.mesh));
  for (const auto v : verts(a)) CHECK(point(t.mesh, t.vert_of(v)) == to_vec3(point(a, v)));
}

TEST_CASE("tetrahedralize: verts without polys have no vert, and extra points that are not used have none") {
  auto points = corners;
  points.insert(points.begin() + 1, vec3{7, 7, 7});
  auto polygons = sides;
  for (auto& p : polygons)
    for (unsigned& v : p) v += v > 0;
  const polygonmesh m = surface(points, polygons);
  const std::vector<vec3> extra = {{9, 9, 9}};
  const auto t = tetrahedralize(m, in_corner, {.extra_points = extra});
  CHECK(t.vert_of(vert_id{1}).is_none());
  CHECK(point(t.mesh, t.vert_of(vert_id{4})) == vec3{0, 0, 1});
  CHECK(t.extra_verts.size() == 1);
  CHECK(t.extra_verts[0].is_none());
}

TEST_CASE("tetrahedralize: surfaces that cannot be filled are refused, with the elements that are to blame") {
  CHECK(has(refusal_of(trimesh()), "has no polys"));
  auto open = sides;
  open.pop_back();
  CHECK(has(refusal_of(surface(corners, open)), "has no other poly; the surface must be closed"));
  auto book = sides;
  book.push_back({0, 1, 3});
  CHECK(has(refusal_of(surface(corners, book)), "between verts 0 and 1 of poly 0 has more than two polys"));
  auto points = corners;
  points[2] = {2, 0, 0};
  points[3] = {3, 1, 0};
  CHECK(has(refusal_of(surface(points, sides)), "poly 0 has no area"));
  points[2] = {0, 1, 0};
  CHECK(has(refusal_of(surface(points, sides)), "flat"));
  points = corners;
  points[3] = points[1];
  CHECK(has(refusal_of(surface(points, sides)), "vert 1 and vert 3 are at the same point"));
  for (const double x : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    points[3] = {0, x, 0};
    CHECK(has(refusal_of(surface(points, sides)), "invalid_mesh tetrahedralize: vert 3 is not finite"));
  }
}

TEST_CASE("tetrahedralize: a surface with one side is refused") {  // the projective plane of six verts
  const std::vector<std::vector<unsigned>> polygons = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}, {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
  std::vector<vec3> points;
  for (int i = 0; i < 6; ++i) points.push_back({std::cos(1.0 * i), std::sin(1.7 * i), 0.1 * i * i});
  CHECK(has(refusal_of(surface(points, polygons)), "only one side"));
}

TEST_CASE("tetrahedralize: surfaces that intersect themselves are refused") {
  auto points = corners;
  auto polygons = sides;
  for (const vec3& p : corners) points.push_back(p + vec3{0.1, 0.1, 0.1});
  for (const auto& p : sides) polygons.push_back({p[0] + 4, p[1] + 4, p[2] + 4});
  const std::string refusal = refusal_of(surface(points, polygons));
  INFO(refusal);
  CHECK(has(refusal, "invalid_mesh tetrahedralize: poly 2 and poly 4 intersect"));
  CHECK(has(refusal, "more pairs"));
  const std::vector<vec3> extra = {{0.2, 0.2, -1}};
  const std::vector<std::array<std::uint32_t, 3>> across = {{2, 3, 4}};
  CHECK(has(refusal_of(surface(corners, sides), {.extra_points = extra, .facets = across}), "facet 0 intersect"));
}

TEST_CASE("tetrahedralize: options out of their range are refused") {
  const polygonmesh m = surface(corners, sides);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(has(refusal_of(m, {.radius_edge = 0.5}), "invalid_argument tetrahedralize: radius_edge is 0.5"));
  CHECK(has(refusal_of(m, {.radius_edge = nan}), "radius_edge"));
  CHECK(has(refusal_of(m, {.min_dihedral_deg = 80}), "min_dihedral_deg is 80"));
  CHECK(has(refusal_of(m, {.max_volume = -1}), "max_volume is -1"));
  CHECK(has(refusal_of(m, {.max_seconds = 0}), "max_seconds is 0"));
  const std::vector<std::array<std::uint32_t, 2>> outside = {{0, 4}}, loop = {{2, 2}};
  CHECK(has(refusal_of(m, {.segments = outside}), "segment 0 has point 4, but there are 4"));
  CHECK(has(refusal_of(m, {.segments = loop}), "segment 0 joins a point with itself"));
  const std::vector<std::array<std::uint32_t, 3>> facet = {{0, 1, 1}};
  CHECK(has(refusal_of(m, {.facets = facet}), "facet 0 has no area"));
  const std::vector<vec3> far = {{5, 5, 5}}, near = {{0.3, 0.2, 0.2}};
  CHECK_THROWS_WITH_AS(tetrahedralize(m, in_corner, {.holes = far}), doctest::Contains("hole 0 is not inside"), invalid_argument);
  CHECK_THROWS_WITH_AS(tetrahedralize(m, in_corner, {.holes = near}), doctest::Contains("holes leave no tet"), invalid_argument);
  const std::vector<tet_region> regions = {{near[0], 7}};
  CHECK(tetrahedralize(m, in_corner, {.regions = regions}).labels == std::vector<std::uint32_t>(4, 7));
}

TEST_CASE("tetrahedralize: whatever a back end returns is verified") {
  const polygonmesh m = surface(corners, sides);
  const auto refusal = [&](std::function<void(tetrahedralize_output&)> change, bool keep = true) {
    try {
      tetrahedralize(m, cone_back_end{{0.2, 0.2, 0.2}, std::move(change)}, {.keep_boundary = keep});
    } catch (const unsupported& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  CHECK(refusal([](auto& o) { std::swap(o.tets[1][0], o.tets[1][1]); }) == "");  // the orientation of tets is free
  CHECK(has(refusal([](auto& o) { o.tets.clear(); }), "the cone returned no tets"));
  CHECK(has(refusal([](auto& o) { o.points[0].x = 1e-30; }), "other points than it was given"));
  CHECK(has(refusal([](auto& o) { o.tets[2][1] = 99; }), "a point that does not exist"));
  CHECK(has(refusal([](auto& o) { o.tets[2][1] = o.tets[2][2]; }), "without volume"));
  CHECK(has(refusal([](auto& o) { o.points.back() = {0.2, 0.2, 0}; }), "without volume"));
  CHECK(has(refusal([](auto& o) { o.tets.push_back(o.tets[0]), o.tets.push_back(o.tets[0]); }), "more than two tets"));
  CHECK(has(refusal([](auto& o) { o.tets.pop_back(); }), "a boundary that is not the surface"));
  CHECK(has(refusal([](auto& o) { o.facets.pop_back(), o.triangle_of_facet.pop_back(); }), "a boundary that is not the surface"));
  CHECK(has(refusal([](auto& o) { o.triangle_of_facet[0] = 1; }), "a boundary that is not the surface"));
  CHECK(has(refusal([](auto& o) { o.triangle_of_facet[0] = 50; }), "a triangle that does not exist"));
  CHECK(has(refusal([](auto& o) { o.points.back() = {2, 2, 2}; }), "the cone returned"));
  const auto divide = [](auto& o) {  // the first triangle and its tet become three
    const auto t = o.facets[0];
    const auto apex = o.tets[0][3], middle = static_cast<std::uint32_t>(o.points.size());
    o.points.push_back((o.points[t[0]] + o.points[t[1]] + o.points[t[2]]) / 3);
    o.facets[0] = {t[0], t[1], middle};
    o.tets[0] = {t[0], t[1], middle, apex};
    for (std::size_t k = 1; k < 3; ++k) {
      o.facets.push_back({t[k], t[(k + 1) % 3], middle});
      o.triangle_of_facet.push_back(0);
      o.tets.push_back({t[k], t[(k + 1) % 3], middle, apex});
    }
  };
  CHECK(has(refusal(divide), "a boundary that is not the surface"));
  CHECK(refusal(divide, false) == "");
}

TEST_CASE("tetrahedralize: tets that miss a wanted shape are listed") {
  const polygonmesh m = surface(corners, sides);
  for (const double z : {0.01, 0.1, 0.2, 0.3}) {
    const auto t = tetrahedralize(m, cone_back_end{{0.2, 0.2, z}}, {.radius_edge = 1.5, .min_dihedral_deg = 20});
    std::vector<poly_id> sharp, large;
    for (const auto p : polys(t.mesh)) {
      double angle = 7, shortest = 7;
      for (const auto e : adj_p2e(t.mesh, p)) angle = std::min(angle, dihedral_angle(t.mesh, p, e)), shortest = std::min(shortest, edge_length(t.mesh, e));
      if (angle < 20 * std::numbers::pi / 180) sharp.push_back(p);
      if (norm(circumcentre(t.mesh, p) - point(t.mesh, *adj_p2v(t.mesh, p).begin())) > 1.5 * shortest) large.push_back(p);
    }
    CHECK(t.report.beyond_min_dihedral == sharp);
    CHECK(t.report.beyond_radius_edge == large);
    CHECK(t.report.not_met.empty() == (sharp.empty() && large.empty()));
    if (!sharp.empty()) CHECK(has(t.report.not_met, "an angle below min_dihedral_deg"));
    if (!large.empty()) CHECK(has(t.report.not_met, "beyond radius_edge"));
    CHECK((z > 0.1 || !sharp.empty()));
  }
}

TEST_CASE("tetrahedralize: progress is reported, and can stop it") {
  const polygonmesh m = surface(corners, sides);
  double last = -1;
  tetrahedralize(m, in_corner, {.progress = [&](double fraction, const char*) {
    CHECK(fraction >= last);
    last = fraction;
    return true;
  }});
  CHECK(last == 1);
  CHECK_THROWS_AS(tetrahedralize(m, in_corner, {.progress = [](double, const char*) { return false; }}), cancelled);
  profiler p;
  tetrahedralize(m, in_corner, {.profiler = &p});
  CHECK(names_of(p) == std::vector<std::string>{"tetrahedralize", "-tetrahedralizing"});
}
