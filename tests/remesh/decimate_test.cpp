#include <concino/remesh/decimate.hpp>

#include <concino/concepts/end_verts.hpp>
#include <concino/convert/convert.hpp>
#include <concino/edit/transaction.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/torus.hpp>
#include <concino/geometry/bounding_tree.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/io/load.hpp>
#include <concino/validate/check_laws.hpp>
#include <concino/validate/validate.hpp>

#include <support/corpus_meshes.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M>
long chi(const M& m) {
  return static_cast<long>(num_verts(m)) - static_cast<long>(num_edges(m)) + static_cast<long>(num_polys(m));
}

double total_area(const trimesh& m) {
  double sum = 0;
  for (const auto p : polys(m)) sum += area(m, p);
  return sum;
}

/// Checks the result of a decimation against the mesh before it.
template<class M>
void check_result(const M& before, const M& after, const decimation& d) {
  CHECK(check_laws(after).empty());
  CHECK(chi(after) == chi(before));
  CHECK(num_polys(after) < num_polys(before));
  const auto tree = bounding_tree(before), other = bounding_tree(after);
  double most = 0;
  for (const auto v : verts(before)) most = std::max(most, other.closest(point(before, v)).distance);
  for (const auto p : polys(after)) most = std::max(most, tree.closest(centroid(after, p)).distance);
  CHECK(most <= d.error * (1 + 1e-9));
}

}  // namespace

TEST_CASE_TEMPLATE("decimate: a sphere keeps its topology and shape", M, trimesh, polygonmesh) {
  const auto sphere = convert<M>(icosphere(3));
  for (const bool memoryless : {false, true}) {
    auto m = sphere;
    const auto d = decimate(m, {.target_polys = 200, .memoryless = memoryless});
    CHECK(num_polys(m) <= 200);
    CHECK(num_polys(m) >= 198);
    CHECK(d.stopped_by == decimation_end::target);
    CHECK(d.num_collapses == (num_polys(sphere) - num_polys(m)) / 2);
    check_result(sphere, m, d);
    CHECK(d.error < 0.05);
    for (const auto p : polys(m)) CHECK(dot(normal(m, p), centroid(m, p)) > 0.9);
  }
}

TEST_CASE("decimate: flat parts cost nothing, and corners and boundaries remain") {
  auto m = grid<trimesh>(12);
  const double before = total_area(m);
  const auto d = decimate(m, {.target_polys = 2});
  CHECK(num_polys(m) <= 20);
  CHECK(d.error < 1e-6);
  CHECK(total_area(m) == doctest::Approx(before).epsilon(1e-7));
  for (const double x : {0.0, 1.0})
    for (const double y : {0.0, 1.0}) {
      double least = 1;
      for (const auto v : verts(m)) least = std::min(least, distance(point(m, v), {x, y, point(m, v).z}));
      CHECK(least < 1e-6);
    }
}

TEST_CASE("decimate: finds the coarse surface of which a fine one was made") {
  // triangles of a sphere cut into 16 each, so that the edges of the sphere are shallow creases
  auto m = icosphere(2);
  const trimesh coarse = m;
  for (int round = 0; round < 2; ++round) {
    surface_arrays a{{}, {}, {}, 3};
    std::map<std::pair<vert_id, vert_id>, vert_id> middle;
    for (const auto v : verts(m)) a.points.push_back(point(m, v));
    for (const auto e : edges(m)) {
      const auto ends = end_verts(m, e);
      middle[{std::min(ends.first, ends.second), std::max(ends.first, ends.second)}] = vert_id(a.points.size());
      a.points.push_back((point(m, ends.first) + point(m, ends.second)) / 2);
    }
    for (const auto p : polys(m)) {
      std::vector<vert_id> v;
      for (const auto x : adj_p2v(m, p)) v.push_back(x);
      const auto between = [&](std::size_t i, std::size_t j) { return middle[{std::min(v[i], v[j]), std::max(v[i], v[j])}]; };
      const vert_id c = between(0, 1), d = between(1, 2), e = between(2, 0);
      for (const vert_id x : {v[0], c, e, c, v[1], d, e, d, v[2], c, d, e}) a.verts.push_back(x);
    }
    m = trimesh(a);
  }
  const auto d = decimate(m, {.target_polys = num_polys(coarse) + num_polys(coarse) / 10});
  CHECK(d.error < 1e-4);
  CHECK(d.stopped_by == decimation_end::target);
}

TEST_CASE("decimate: stops where nothing can be collapsed, and says why") {
  const trimesh tetrahedron({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
  auto m = tetrahedron;
  const auto d = decimate(m, {.target_polys = 1});
  CHECK(d.stopped_by == decimation_end::refused);
  CHECK(d.last_refusal.reason == refusal::link_condition);
  CHECK(d.num_collapses == 0);
  CHECK(d.error < 1e-12);
  CHECK(num_polys(m) == 4);

  trimesh none;
  CHECK(decimate(none, {.target_polys = 1}).stopped_by == decimation_end::target);
  auto quads = grid<polygonmesh>(3);
  const std::size_t before = num_polys(quads);
  CHECK(decimate(quads, {.max_error = 1}).stopped_by == decimation_end::refused);
  CHECK(num_polys(quads) <= before);
  CHECK(check_laws(quads).empty());
}

TEST_CASE("decimate: non-manifold surfaces") {
  // three fans of triangles at a common line of edges
  surface_arrays a{{}, {}, {}, 3};
  constexpr unsigned n = 8;
  for (unsigned sheet = 0; sheet < 3; ++sheet)
    for (unsigned i = 0; i <= n; ++i)
      for (unsigned j = sheet == 0 ? 0 : 1; j <= n; ++j) {
        const double angle = 2.0 * sheet, r = double(j) / n;
        a.points.push_back({r * std::cos(angle), r * std::sin(angle), double(i) / n});
      }
  const auto at = [&](unsigned sheet, unsigned i, unsigned j) {
    if (sheet == 0 || j == 0) return vert_id{i * (n + 1) + j};
    return vert_id{(n + 1) * (n + 1) + (sheet - 1) * (n + 1) * n + i * n + j - 1};
  };
  for (unsigned sheet = 0; sheet < 3; ++sheet)
    for (unsigned i = 0; i < n; ++i)
      for (unsigned j = 0; j < n; ++j) {
        for (const vert_id v : {at(sheet, i, j), at(sheet, i, j + 1), at(sheet, i + 1, j + 1)}) a.verts.push_back(v);
        for (const vert_id v : {at(sheet, i, j), at(sheet, i + 1, j + 1), at(sheet, i + 1, j)}) a.verts.push_back(v);
      }
  const trimesh before(a);
  auto m = before;
  const auto d = decimate(m, {.target_polys = 40});
  check_result(before, m, d);
  CHECK(num_polys(m) <= 40);
  CHECK(d.error < 1e-6);
}

TEST_CASE("decimate: max_error bounds the distance of the result from the input") {
  const auto before = make_torus<trimesh>({.cells = {40, 20}});
  auto m = before;
  const auto d = decimate(m, {.max_error = 0.01});
  CHECK(d.stopped_by == decimation_end::refused);
  CHECK(num_polys(m) < num_polys(before));
  const auto tree = bounding_tree(before);
  for (const auto p : polys(m)) CHECK(tree.closest(centroid(m, p)).distance <= 0.01);
  for (const auto v : verts(m)) CHECK(tree.closest(point(m, v)).distance <= 0.01);
  check_result(before, m, d);
}

TEST_CASE_TEMPLATE("decimate: max_error keeps open surfaces and their boundaries", M, trimesh, polygonmesh) {
  const auto keeps = [](const surface_arrays& a, double e, std::size_t most) {
    const M before(a);
    M m = before;
    const auto d = decimate(m, {.max_error = e});
    CHECK(d.error <= e);
    CHECK(hausdorff_distance(before, m).lower <= e);
    CHECK(total_measure(m) == doctest::Approx(total_measure(before)).epsilon(0.01));
    CHECK(num_polys(m) <= most);
    CHECK(check_laws(m).empty());
    CHECK(chi(m) == chi(before));
    return m;
  };
  const auto sheet = [](surface_arrays& a, unsigned nx, unsigned ny, auto&& at) {
    const auto first = static_cast<unsigned>(a.points.size());
    for (unsigned j = 0; j <= ny; ++j)
      for (unsigned i = 0; i <= nx; ++i) a.points.push_back(at(i, j));
    for (unsigned j = 0; j < ny; ++j)
      for (unsigned i = 0; i < nx; ++i) {
        const unsigned b = first + j * (nx + 1) + i, c = b + nx + 1;
        for (const unsigned v : {b, b + 1, c + 1, b, c + 1, c}) a.verts.push_back(vert_id{v});
      }
  };
  surface_arrays square{{}, {}, {}, 3}, strip = square, bent = square, sheets = square;
  sheet(square, 1, 1, [](unsigned i, unsigned j) { return vec3{double(i), double(j), 0}; });
  keeps(square, 0.001, 2);
  sheet(strip, 20, 2, [](unsigned i, unsigned j) { return vec3{i / 2.0, j / 2.0, 0}; });
  const M two = keeps(strip, 0.001, 4);
  for (const double x : {0.0, 10.0})
    for (const double y : {0.0, 1.0}) {
      double least = 1;
      for (const auto v : verts(two)) least = std::min(least, distance(point(two, v), {x, y, 0}));
      CHECK(least <= 0.001 * 1.5);
    }
  sheet(bent, 40, 10, [](unsigned i, unsigned j) { return vec3{std::cos(std::acos(-1.0) * i / 40), std::sin(std::acos(-1.0) * i / 40), 0.3 * j}; });
  keeps(bent, 0.01, 40);
  // a small sheet on a large one: what it loses would be near the other
  for (const double side : {4.0, 1.0})
    sheet(sheets, 4, 4, [side](unsigned i, unsigned j) { return vec3{side * i / 4 + 1 / side, side * j / 4 + 1 / side, 0.001 * side}; });
  keeps(sheets, 0.01, 8);
}

TEST_CASE("decimate: max_error holds both ways without weights") {
  const auto before = make_torus<trimesh>({.cells = {48, 24}});
  for (const double e : {0.0, 0.003, 0.03}) {
    auto m = before;
    decimate(m, {.max_error = e, .feature_angle_deg = 180, .boundary_weight = 0});
    CHECK(hausdorff_distance(before, m, {.tolerance = 0.001}).lower <= e + 1e-12);
    CHECK(check_laws(m).empty());
  }
}

TEST_CASE("decimate: features sharper than the angle are held in place") {
  // a roof over a grid: the ridge at x = 1/2
  auto roof = grid<trimesh>(16);
  for (const auto v : verts(roof)) {
    const vec3 x = point(roof, v);
    set_point(roof, v, vec3{x.x, x.y, 0.6 - 1.2 * std::abs(x.x - 0.5)});
  }
  auto m = roof;
  const auto d = decimate(m, {.target_polys = 30, .feature_angle_deg = 40});
  CHECK(d.error < 1e-4);
  check_result(roof, m, d);
}

TEST_CASE("decimate: invariants of the caller, and properties") {
  auto m = icosphere(3);
  auto height = vert_property<double>(m, "height");
  for (const auto v : verts(m)) height[v] = point(m, v).z;
  auto cap = [&](const proposed_edit& e) {
    for (const vec3& x : e.points_before)
      if (x.z > 0.5) return permission{refusal::invariant, "the cap stays"};
    return permission{};
  };
  std::vector<vec3> kept;
  for (const auto v : verts(m))
    if (point(m, v).z > 0.5) kept.push_back(point(m, v));
  decimate(m, {.target_polys = 500, .keep = {no_inversion, cap}});
  for (const vec3& x : kept) {
    bool found = false;
    for (const auto v : verts(m)) found = found || point(m, v) == x;
    CHECK(found);
  }
  for (const auto v : verts(m)) CHECK(std::abs(height[v] - point(m, v).z) < 0.2);
}

TEST_CASE("decimate: the same result at any power of two, and each time") {
  const auto sphere = icosphere(3);
  auto m = sphere;
  const auto d = decimate(m, {.target_polys = 300});
  for (const double factor : {1.0, 0x1p-700, 0x1p600}) {
    auto scaled = sphere;
    for (const auto v : verts(scaled)) set_point(scaled, v, factor * point(scaled, v));
    const auto other = decimate(scaled, {.target_polys = 300});
    CHECK(other.error == factor * d.error);
    CHECK(num_polys(scaled) == num_polys(m));
    for (const auto v : verts(m)) CHECK(point(scaled, v) == factor * point(m, v));
  }
}

TEST_CASE("decimate: can be cancelled; a transaction then restores the mesh") {
  const auto before = icosphere(4);
  auto stop = [](double fraction, const char*) { return fraction < 0.3; };
  auto m = before;
  CHECK_THROWS_AS(decimate(m, {.target_polys = 100, .progress = stop}), cancelled);
  CHECK(check_laws(m).empty());
  CHECK(num_polys(m) < num_polys(before));
  CHECK(num_polys(m) > 100);
  m = before;
  try {
    transaction t(m);
    decimate(m, {.target_polys = 100, .progress = stop});
    t.commit();
    CHECK(false);
  } catch (const cancelled&) {
  }
  CHECK(num_polys(m) == num_polys(before));
  for (const auto v : verts(m)) CHECK(point(m, v) == point(before, v));
}

TEST_CASE("decimate: errors leave the mesh as it was") {
  auto m = icosphere(1);
  const std::size_t n = num_polys(m);
  CHECK_THROWS_AS(decimate(m, {}), invalid_argument);
  CHECK_THROWS_AS(decimate(m, {.target_polys = 10, .max_error = -1}), invalid_argument);
  CHECK_THROWS_AS(decimate(m, {.target_polys = 10, .feature_angle_deg = std::nan("")}), invalid_argument);
  CHECK_THROWS_AS(decimate(m, {.target_polys = 10, .boundary_weight = -1}), invalid_argument);
  set_point(m, vert_id{3}, vec3{0, std::nan(""), 0});
  CHECK_THROWS_AS(decimate(m, {.target_polys = 10}), invalid_mesh);
  CHECK(num_polys(m) == n);
}

TEST_CASE("decimate: real surfaces, to a tenth") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  unsigned seen = 0;
  const auto decimate_to_tenth = [&]<class M>(const M& before, bool triangles) {
    if (num_polys(before) > 10000 && !long_run()) return;
    ++seen;
    auto m = before;
    const std::size_t target = num_polys(before) / 10 + 1;
    const auto d = decimate(m, {.target_polys = target});
    CHECK((d.stopped_by == decimation_end::refused || num_polys(m) <= target));
    CHECK(chi(m) == chi(before));
    if (d.num_collapses > 0 && triangles) check_result(before, m, d);
    if (d.stopped_by == decimation_end::refused) MESSAGE(num_polys(m) << " of " << num_polys(before) << " polys are left: " << d.last_refusal.why);
  };
  for (const corpus_row& row : rows) {
    CAPTURE(row.name);
    const std::string kind = row.column.at("kind");
    if (kind == "tri") decimate_to_tenth(load<trimesh>(row.file.string()), true);
    else if (kind == "quad" || kind == "polygon") decimate_to_tenth(load<polygonmesh>(row.file.string()), false);
  }
  CHECK(seen >= 12);
}
