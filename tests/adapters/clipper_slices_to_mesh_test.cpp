#include <concino/adapters/clipper.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/io/slices.hpp>
#include <concino/print/layer_regions.hpp>
#include <concino/print/planar_regions.hpp>
#include <concino/print/slices_to_mesh.hpp>
#include <concino/validate/validate.hpp>

#include <support/corpus.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double pi = 3.14159265358979324;

using contour = std::vector<slice_point>;

contour rectangle(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

/// The area of the polys of a kind in a layer; all must be counter-clockwise.
template<class To>
double area_of(const layer_mesh<To>& r, int layer, slice_kind kind) {
  const auto layers = find_poly_property<int>(r.mesh, "layer"), kinds = find_poly_property<int>(r.mesh, "kind");
  double sum = 0;
  for (const poly_id p : polys(r.mesh)) {
    const double area = area_vector(r.mesh, p).z;
    CHECK(area > 0);
    if (layers[p] == layer && kinds[p] == static_cast<int>(kind)) sum += area;
  }
  return sum;
}

template<class To>
double total(const layer_mesh<To>& r) {
  double sum = 0;
  for (const poly_id p : polys(r.mesh)) sum += area_vector(r.mesh, p).z;
  return sum;
}

/// No poly passes a vert twice, and no edge has more than two polys, which run in opposite directions.
template<class To>
void check_polys(const To& m) {
  for (const poly_id p : polys(m)) {
    std::set<std::uint32_t> seen;
    for (const vert_id v : adj_p2v(m, p)) CHECK(seen.insert(v.raw()).second);
  }
  for (const edge_id e : edges(m)) CHECK(num_elements(adj_e2p(m, e)) <= 2);
}

}  // namespace

TEST_CASE_TEMPLATE("slices_to_mesh: the slices of the corpus have the areas of the index", To, polygonmesh, trimesh) {
  {
    CONCINO_CORPUS_OR_SKIP(path, "slices/T_supported.cli");
    const slices s = load_slices(path.string());
    const auto r = slices_to_mesh<To>(s, clipper);
    CHECK(total(r) == doctest::Approx(108).epsilon(1e-11));
    CHECK(r.report.count(contour_change::dropped) == 384);
    CHECK(r.report.notes[0].text() == "layer 0: open line 0 was dropped");
    const auto layer = find_poly_property<int>(r.mesh, "layer");
    std::set<int> layers;
    for (const poly_id p : polys(r.mesh)) layers.insert(layer[p]);
    CHECK(layers.size() == 60);
    if constexpr (arity_v<To> == 0) CHECK(num_polys(r.mesh) == 60);
    for (const double radius : {0.02, 0.05}) {
      const auto thick = slices_to_mesh<To>(s, clipper, {.thicken = radius, .chord_error = 1e-4});
      CHECK(thick.report.notes.empty());
      check_polys(thick.mesh);
      const double cross = 2 * (2 * radius * 0.2 + pi * radius * radius) - 4 * radius * radius;  // two lines of length 0.2
      CHECK(area_of(thick, 0, slice_kind::part) == doctest::Approx(1).epsilon(1e-11));
      CHECK(area_of(thick, 0, slice_kind::support) == doctest::Approx(4 * cross).epsilon(2e-2));
    }
  }
  CONCINO_CORPUS_OR_SKIP(gear, "slices/nugear_coarse.cli");
  const auto r = slices_to_mesh<To>(load_slices(gear.string()), clipper);
  CHECK(total(r) == doctest::Approx(10087.4693177).epsilon(1e-10));
  CHECK(area_of(r, 0, slice_kind::part) == doctest::Approx(274.30989007).epsilon(1e-10));
  CHECK(r.report.notes.empty());
  check_polys(r.mesh);
  CONCINO_CORPUS_OR_SKIP(torus, "slices/torus_coarse.cli");
  CHECK(total(slices_to_mesh<To>(load_slices(torus.string()), clipper)) == doctest::Approx(1756170).epsilon(1e-11));
}

TEST_CASE_TEMPLATE("slices_to_mesh: part before support before hatches, and holes", To, polygonmesh, trimesh) {
  slices s;
  s.layers.resize(2);
  s.layers[0].z = 1;
  s.layers[1].z = 3;
  slice_layer& l = s.layers[1];
  l.outer.push_back(rectangle(0, 0, 4, 4));
  l.inner.push_back(contour{{1, 1}, {1, 3}, {3, 3}, {3, 1}});
  l.outer.push_back(rectangle(1.5, 1.5, 2.5, 2.5));
  l.open.push_back(contour{{-1, 2}, {5, 2}});
  l.hatches.push_back(contour{{-1, 3}, {-1, 3.5}, {10, 0}, {11, 0}, {2, 4}, {2, 5}});
  const double r = 0.25;
  const auto m = slices_to_mesh<To>(s, clipper, {.thicken = r, .thicken_hatches = r, .chord_error = 1e-6});
  CHECK(area_of(m, 0, slice_kind::part) == 0);
  CHECK(area_of(m, 1, slice_kind::part) == doctest::Approx(13).epsilon(1e-11));
  CHECK(area_of(m, 1, slice_kind::support) == doctest::Approx(2 * 0.5 + 2 * 0.25 + pi * r * r).epsilon(1e-4));  // 1 + 1 outside, 0.5 + 0.5 in the hole
  CHECK(area_of(m, 1, slice_kind::hatch) == doctest::Approx(0.25 + 0.5 + 0.5 + 2.5 * pi * r * r).epsilon(1e-4));
  check_polys(m.mesh);
  for (const vert_id v : verts(m.mesh)) CHECK(point(m.mesh, v).z == 3);
  CHECK(m.report.notes.empty());
  for (const auto& d : validate(m.mesh)) FAIL_CHECK(d.what);
}

TEST_CASE("slices_to_mesh: random layers have the area of their regions, also where contours touch and cross") {
  std::mt19937_64 random(7);
  const auto number = [&](unsigned n) { return static_cast<double>(random() % n); };
  for (int round = 0; round < 300; ++round) {
    CAPTURE(round);
    slices s;
    s.layers.resize(1);
    const double scale = round % 3 == 0 ? 1 : 0.1;
    for (int i = 0; i < 5; ++i) {
      contour c;
      for (int k = 3 + static_cast<int>(number(6)); k > 0; --k) c.push_back({number(9) * scale, number(9) * scale});
      (i == 4 ? s.layers[0].inner : s.layers[0].outer).push_back(c);
    }
    const double expected = layer_regions(s.layers[0], clipper).area(), tolerance = 1e-9 * 81 * scale * scale;
    const auto polygons = slices_to_mesh(s, clipper);
    const auto triangles = slices_to_mesh<trimesh>(s, clipper);
    CHECK(std::abs(total(polygons) - expected) <= tolerance);
    CHECK(std::abs(total(triangles) - expected) <= tolerance);
    check_polys(polygons.mesh);
    check_polys(triangles.mesh);
  }
}

TEST_CASE("slices_to_mesh: a layer of many points, which are 10^6 in the long run") {
  slices s;
  s.layers.resize(1);
  contour star;
  const int n = long_run() ? 500'000 : 4'000, rows = long_run() ? 350 : 30;
  for (int i = 0; i < n; ++i) {
    const double r = i % 2 == 0 ? 10 : 9.5, a = 2 * pi * i / n;
    star.push_back({r * std::cos(a), r * std::sin(a)});
  }
  s.layers[0].outer.push_back(star);
  for (int i = 0; i < rows; ++i)
    for (int k = 0; k < rows; ++k) s.layers[0].outer.push_back(rectangle(20 + i * 0.1 + 0.0001 * k, k * 0.1 + 0.0001 * i, 20.05 + i * 0.1, k * 0.1 + 0.05 + 0.0001 * i));
  const auto r = slices_to_mesh(s, clipper);
  CHECK(num_polys(r.mesh) == 1 + static_cast<std::size_t>(rows * rows));
}

TEST_CASE("slices_to_mesh: wrong input names layer and contour; lines without radius and contours without area are reported") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto message = [](const slices& s, const layer_options& o = {}) -> std::string {
    try {
      (void)slices_to_mesh(s, clipper, o);
    } catch (const invalid_argument& e) {
      return e.what();
    }
    return "";
  };
  slices s;
  s.layers.resize(3);
  CHECK(num_polys(slices_to_mesh(s, clipper).mesh) == 0);
  s.layers[1].outer.push_back(rectangle(0, 0, 1, 1));
  s.layers[1].outer.push_back(contour{{0, 0}, {1, 1}, {2, 2}});
  s.layers[1].outer.push_back(contour{{5, 5}});
  s.layers[1].outer.push_back(contour{});
  s.layers[2].open.push_back(contour{{0, 0}, {1, 1}});
  s.layers[2].hatches.push_back(contour{{0, 0}, {1, 1}});
  const auto r = slices_to_mesh(s, clipper);
  CHECK(num_polys(r.mesh) == 1);
  std::vector<std::string> texts;
  for (const contour_note& n : r.report.notes) texts.push_back(n.text());
  CHECK(texts == std::vector<std::string>{"layer 1: outer contour 1 was dropped", "layer 1: outer contour 2 was dropped", "layer 1: outer contour 3 was dropped",
                                          "layer 2: open line 0 was dropped", "layer 2: group of hatches 0 was dropped"});
  CHECK(message(s, {.thicken = -1}) == "slices_to_mesh: thicken is -1; it must be finite and 0 or more");
  CHECK(message(s, {.thicken_hatches = nan}).find("thicken_hatches") != std::string::npos);
  CHECK(message(s, {.chord_error = nan}).find("chord_error") != std::string::npos);
  s.layers[2].hatches.push_back(contour{{0, 0}, {1, 1}, {2, 2}});
  CHECK(message(s) == "slices_to_mesh: layer 2: group of hatches 1 has 3 points; hatches have two each");
  s.layers[2].open.push_back(contour{{0, nan}});
  CHECK(message(s) == "slices_to_mesh: layer 2: open line 1 has a point that is not finite");
  s.layers[0].z = nan;
  CHECK(message(s) == "slices_to_mesh: the height of layer 0 is not finite");
  slices one_layer;
  one_layer.layers.resize(1);
  CHECK_THROWS_AS((void)slices_to_mesh(one_layer, clipper, {.progress = [](double, const char*) { return false; }}), cancelled);
}
