#include <concino/adapters/clipper.hpp>
#include <concino/core/error.hpp>
#include <concino/io/slices.hpp>
#include <concino/print/combine_regions.hpp>
#include <concino/print/layer_regions.hpp>
#include <concino/print/region_offset.hpp>

#include <support/corpus.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double pi = 3.14159265358979324;

using contour = std::vector<slice_point>;

contour rectangle(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

planar_regions regions_of(const std::vector<contour>& outer, const std::vector<contour>& inner = {}) {
  slice_layer layer;
  for (const contour& c : outer) layer.outer.push_back(c);
  for (const contour& c : inner) layer.inner.push_back(c);
  return layer_regions(layer, clipper);
}

/// Random rectangles and polygons with corners on a small grid, so that many edges touch, overlap and are equal.
planar_regions random_regions(std::mt19937_64& random, double scale) {
  const auto number = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  slice_layer layer;
  const int n = 1 + number(6);
  for (int i = 0; i < n; ++i) {
    contour c;
    if (number(2) == 0) {
      const int x = number(8), y = number(8);
      c = rectangle(x * scale, y * scale, (x + 1 + number(5)) * scale, (y + 1 + number(5)) * scale);
    } else {
      for (int k = 3 + number(5); k > 0; --k) c.push_back({number(12) * scale, number(12) * scale});  // may cross itself
    }
    (number(4) == 0 ? layer.inner : layer.outer).push_back(c);
  }
  return layer_regions(layer, clipper);
}

}  // namespace

TEST_CASE("planar_regions: holes, islands in holes, and contours in any direction") {
  slice_report report;
  slice_layer layer;
  contour hole = rectangle(1, 1, 9, 9);  // counter-clockwise, so it is turned
  layer.outer.push_back(rectangle(0, 0, 10, 10));
  layer.inner.push_back(hole);
  layer.outer.push_back(contour{{2, 2}, {2, 8}, {8, 8}, {8, 2}});
  layer.inner.push_back(contour{{3, 3}, {3, 4}, {4, 4}, {4, 3}});
  const planar_regions r = layer_regions(layer, clipper, {.report = &report});
  REQUIRE(r.size() == 2);
  CHECK(r.area() == 100 - 64 + 36 - 1);
  CHECK(r.num_holes(0) + r.num_holes(1) == 2);
  CHECK(contour_area(r.contour(r.outer_contour(0))) > 0);
  CHECK(contour_area(r.contour(r.outer_contour(0) + 1)) < 0);
  CHECK(r.unit <= 10 * 0x1p-40);
  REQUIRE(report.notes.size() == 2);
  CHECK(report.notes[0].text() == "layer 0: outer contour 1 was turned");
  CHECK(report.notes[1].text() == "layer 0: inner contour 0 was turned");
  const slice_layer again = to_layer(r, 2.5, 7);
  CHECK(again.z == 2.5);
  CHECK(again.outer.size() == 2);
  CHECK(again.inner.size() == 2);
  CHECK(again.inner.ids[0] == 7);
  CHECK(layer_regions(again, clipper).area() == r.area());
}

TEST_CASE("layer_regions: the sum of outer and inner contours counts") {
  CHECK(regions_of({rectangle(0, 0, 4, 4), rectangle(0, 0, 4, 4)}, {rectangle(1, 1, 2, 2)}).area() == 16);  // two outer ones, one inner: still filled
  CHECK(regions_of({rectangle(0, 0, 4, 4)}, {rectangle(1, 1, 2, 2), rectangle(1, 1, 2, 2)}).area() == 15);
  CHECK(regions_of({}, {rectangle(1, 1, 2, 2)}).empty());
  CHECK(regions_of({rectangle(0, 0, 1, 1), rectangle(1, 0, 2, 1)}).area() == 2);
}

TEST_CASE("layer_regions: contours that cross themselves are filled where they wind around") {
  slice_report report;
  slice_layer layer;
  layer.outer.push_back(contour{{0, 0}, {2, 2}, {2, 0}, {0, 2}});                               // two triangles of area 1, in different directions
  layer.outer.push_back(contour{{10, 0}, {14, 0}, {14, 4}, {10, 4}, {10, 0}, {14, 0}, {14, 4}, {10, 4}});  // twice around
  layer.inner.push_back(rectangle(11, 1, 12, 2));
  layer.outer.push_back(contour{{20, 0}, {21, 0}, {22, 0}});  // no area
  layer.outer.push_back(contour{{30, 0}, {31, 0}, {31, 1}, {30, 0}});  // repeats its first point
  const planar_regions r = layer_regions(layer, clipper, {.report = &report});
  CHECK(r.area() == doctest::Approx(2 + 16 - 1 + 0.5).epsilon(1e-11));
  CHECK(report.count(contour_change::crossing) == 2);
  CHECK(report.count(contour_change::dropped) == 1);
  CHECK(report.count(contour_change::closed) == 1);
}

TEST_CASE("region_union, region_difference, region_intersection: inclusion and exclusion for random pairs with touching and equal edges") {
  std::mt19937_64 random(53);
  for (int round = 0; round < 1000; ++round) {
    CAPTURE(round);
    const double scale = round % 2 == 0 ? 1 : 0.1;
    const planar_regions a = random_regions(random, scale), b = random_regions(random, scale);
    const double tolerance = 1e-9 * 144 * scale * scale;
    const double both = region_intersection(a, b, clipper).area(), either = region_union(a, b, clipper).area();
    const double only_a = region_difference(a, b, clipper).area(), only_b = region_difference(b, a, clipper).area();
    CHECK(std::abs(a.area() + b.area() - both - either) <= tolerance);
    CHECK(std::abs(only_a + both - a.area()) <= tolerance);
    CHECK(std::abs(only_b + both - b.area()) <= tolerance);
    CHECK(std::abs(region_union(a, a, clipper).area() - a.area()) <= tolerance);
    CHECK(region_difference(a, a, clipper).area() <= tolerance);
    CHECK(std::abs(region_union(b, a, clipper).area() - either) <= tolerance);
  }
}

TEST_CASE("thicken: the area around a segment, and around a point") {
  for (const double length : {0.0, 0.5, 3.0, 100.0})
    for (const double radius : {0.01, 0.2, 7.0})
      for (const double error : {0.05, 0.01, 0.0001}) {
        CAPTURE(length);
        CAPTURE(radius);
        CAPTURE(error);
        slice_lines lines;
        lines.push_back(length == 0 ? contour{{1, 2}} : contour{{1, 2}, {1 + 0.6 * length, 2 + 0.8 * length}});
        const double exact = 2 * radius * length + pi * radius * radius;
        const double found = thicken(lines, radius, clipper, {.chord_error = error * radius}).area();
        CHECK(found <= exact * (1 + 1e-9));
        CHECK(found >= exact - pi * radius * error * radius - 1e-9 * exact);
      }
  slice_lines cross;  // two lines that cross become one region
  cross.push_back(contour{{-1, 0}, {1, 0}});
  cross.push_back(contour{{0, -1}, {0, 1}});
  const planar_regions r = thicken(cross, 0.1, clipper, {.chord_error = 1e-6});
  CHECK(r.size() == 1);
  CHECK(r.area() == doctest::Approx(2 * (0.4 + pi * 0.01) - 0.04).epsilon(1e-4));
  CHECK(thicken({}, 1, clipper).empty());
}

TEST_CASE("region_offset: round and mitred corners, outward and inward") {
  const planar_regions square = regions_of({rectangle(0, 0, 4, 4)}, {rectangle(1, 1, 3, 3)});
  CHECK(region_offset(square, 0.5, clipper, {.chord_error = 1e-6}).area() == doctest::Approx(16 + 8 + pi / 4 - 1).epsilon(1e-5));
  CHECK(region_offset(square, 0.25, clipper, {.corners = offset_corners::mitred}).area() == doctest::Approx(4.5 * 4.5 - 1.5 * 1.5).epsilon(1e-11));
  CHECK(region_offset(square, -0.25, clipper, {.corners = offset_corners::mitred}).area() == doctest::Approx(3.5 * 3.5 - 2.5 * 2.5).epsilon(1e-11));
  CHECK(region_offset(square, -0.25, clipper, {.chord_error = 1e-6}).area() == doctest::Approx(3.5 * 3.5 - 4 - 2 - pi / 16).epsilon(1e-5));
  CHECK(region_offset(square, -0.6, clipper).empty());
  CHECK(region_offset(square, 0, clipper).area() == 12);
  CHECK(region_offset({}, 1, clipper).empty());
  const planar_regions spike = regions_of({contour{{0, 0}, {10, 0}, {0, 1}}});
  CHECK(region_offset(spike, 1, clipper, {.corners = offset_corners::mitred, .mitre_limit = 1}).area() < region_offset(spike, 1, clipper, {.corners = offset_corners::mitred, .mitre_limit = 100}).area());
}

TEST_CASE("planar regions scale with the unit of length") {
  for (const double scale : {0x1p-60, 1.0, 0x1p60})
    for (const double shift : {0.0, 1000.0}) {
      const auto moved = [&](double x0, double y0, double x1, double y1) { return rectangle((x0 + shift) * scale, (y0 - shift) * scale, (x1 + shift) * scale, (y1 - shift) * scale); };
      const planar_regions a = regions_of({moved(0, 0, 2, 2)}), b = regions_of({moved(1, 1, 3, 3)});
      CHECK(region_union(a, b, clipper).area() == 7 * scale * scale);
      CHECK(region_intersection(a, b, clipper).area() == scale * scale);
    }
}

TEST_CASE("regions: wrong input is an error that names the contour") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const auto message = [](const auto& call) -> std::string {
    try {
      call();
    } catch (const invalid_argument& e) {
      return e.what();
    }
    return "";
  };
  slice_layer layer;
  layer.outer.push_back(rectangle(0, 0, 1, 1));
  layer.outer.push_back(contour{{0, 0}, {1, nan}, {1, 1}});
  CHECK(message([&] { (void)layer_regions(layer, clipper); }) == "layer_regions: outer contour 1 has a point that is not finite");
  slice_lines lines;
  lines.push_back(contour{{0, infinite}, {1, 1}});
  CHECK(message([&] { (void)thicken(lines, 1, clipper); }) == "thicken: open line 0 has a point that is not finite");
  CHECK(message([&] { (void)thicken({}, 0, clipper); }) == "thicken: radius is 0; it must be finite and above 0");
  for (const double radius : {-1.0, nan, infinite}) CHECK_THROWS_AS((void)thicken({}, radius, clipper), invalid_argument);
  CHECK_THROWS_AS((void)thicken({}, 1, clipper, {.chord_error = -1}), invalid_argument);
  const planar_regions square = regions_of({rectangle(0, 0, 1, 1)});
  planar_regions bad = square;
  bad.points[2][1] = nan;
  CHECK(message([&] { (void)region_union(square, bad, clipper); }) == "region_union: point 2 of the second regions is not finite");
  CHECK_THROWS_AS((void)region_offset(bad, 1, clipper), invalid_argument);
  CHECK_THROWS_AS((void)region_offset(square, nan, clipper), invalid_argument);
  CHECK_THROWS_AS((void)region_offset(square, 1, clipper, {.chord_error = nan}), invalid_argument);
  CHECK_THROWS_AS((void)region_offset(square, 1, clipper, {.mitre_limit = 0.5}), invalid_argument);
  CHECK_THROWS_AS((void)regions_of({rectangle(0, 0, 1e200, 1e200)}), unsupported);
  slice_lines dot_only;
  dot_only.push_back(contour{{1, 1}});
  CHECK_THROWS_AS((void)thicken(dot_only, 1e200, clipper), unsupported);
}

TEST_CASE("clipper: refuses coordinates that it cannot hold") {
  lattice_paths paths;
  paths.push_back(std::vector<snapped_point>{{0, 0}, {std::int64_t{1} << 62, 0}, {0, std::int64_t{1} << 62}});
  CHECK_THROWS_AS((void)clipper.combine(region_operation::unite, paths, {}), unsupported);
  CHECK(std::string(clipper.name()) == "Clipper");
}

TEST_CASE("layer_regions: the slices of the corpus have the areas of the index") {
  const auto total = [](const std::string& file) {
    double sum = 0;
    for (const slice_layer& layer : load_slices(file).layers) sum += layer_regions(layer, clipper).area();
    return sum;
  };
  {
    CONCINO_CORPUS_OR_SKIP(t, "slices/T_supported.cli");
    CHECK(load_slices(t.string()).layers.size() == 60);
    CHECK(total(t.string()) == doctest::Approx(108).epsilon(1e-11));
  }
  CONCINO_CORPUS_OR_SKIP(gear, "slices/nugear_coarse.cli");
  CHECK(total(gear.string()) == doctest::Approx(10087.4693177).epsilon(1e-10));
  CONCINO_CORPUS_OR_SKIP(torus, "slices/torus_coarse.cli");
  CHECK(total(torus.string()) == doctest::Approx(1756170).epsilon(1e-11));
}
