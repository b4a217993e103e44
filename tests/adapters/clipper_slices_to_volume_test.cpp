#include <concino/adapters/clipper.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/io/slices.hpp>
#include <concino/print/heights.hpp>
#include <concino/print/layer_regions.hpp>
#include <concino/print/region_offset.hpp>
#include <concino/print/combine_regions.hpp>
#include <concino/print/slice_mesh.hpp>
#include <concino/print/slices_to_volume.hpp>
#include <concino/validate/validate.hpp>

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

using contour = std::vector<slice_point>;

contour rectangle(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

/// The area of regions whose points are snapped to a unit.
double snapped_area(planar_regions r, double unit) {
  for (slice_point& p : r.points) p = {std::nearbyint(p[0] / unit) * unit, std::nearbyint(p[1] / unit) * unit};
  return layer_regions(to_layer(r, 0), clipper).area();
}

/// The sum of area times height of layers of material without supports.
double volume_of(const slices& s, double last_height, double unit) {
  double sum = 0;
  for (std::size_t i = 0; i < s.layers.size(); ++i)
    sum += snapped_area(layer_regions(s.layers[i], clipper), unit) * (i + 1 < s.layers.size() ? s.layers[i + 1].z - s.layers[i].z : last_height);
  return sum;
}

/// All tets have a positive volume, and fit together: apart from faces between heights, faces with one tet are where material ends.
/// with_flat: where lines of several layers nearly meet in a point, some tets are so small that validate calls them flat.
void check_volume(const layer_volume& v, double expected, bool with_flat = false) {
  CHECK(v.inverted.empty());
  double sum = 0;
  for (const poly_id p : polys(v.mesh)) {
    const double volume = concino::volume(v.mesh, p);
    CHECK(volume > 0);
    sum += volume;
  }
  CHECK(sum == doctest::Approx(expected).epsilon(1e-9));
  const auto report = validate(v.mesh);
  for (const auto& d : report)
    if (d.kind != defect_kind::non_manifold_vert && d.kind != defect_kind::non_manifold_edge && !(with_flat && d.kind == defect_kind::zero_size)) FAIL_CHECK(d.what);  // where layers touch along lines
}

/// The area of faces with one tet whose normals are vertical, and of all others.
std::pair<double, double> boundary_areas(const tetmesh& m) {
  double flat = 0, steep = 0;
  for (const face_id f : faces(m))
    if (is_boundary(m, f)) {
      const vec3 a = area_vector(m, f);
      (std::abs(a.z) > 0.5 * norm(a) ? flat : steep) += norm(a);
    }
  return {flat, steep};
}

}  // namespace

TEST_CASE("slices_to_volume: one layer, and two equal ones") {
  slices s;
  s.layers.resize(1);
  s.layers[0].z = 2;
  s.layers[0].outer.push_back(rectangle(0, 0, 1, 1));
  const auto one = slices_to_volume(s, clipper, {.last_height = 0.5});
  CHECK(num_polys(one.mesh) == 6);
  check_volume(one, 0.5);
  CHECK(bounding_box(one.mesh).min == vec3{0, 0, 2});
  CHECK(bounding_box(one.mesh).max == vec3{1, 1, 2.5});
  s.layers.push_back(s.layers[0]);
  s.layers[1].z = 3;
  const auto two = slices_to_volume(s, clipper);
  CHECK(num_polys(two.mesh) == 12);
  CHECK(num_verts(two.mesh) == 12);
  check_volume(two, 2);
  const auto layer = find_poly_property<int>(two.mesh, "layer");
  for (const poly_id p : polys(two.mesh)) CHECK(layer[p] == (vert_mean(two.mesh, p).z > 3));
  CHECK(boundary_areas(two.mesh) == std::pair{2.0, 8.0});
}

TEST_CASE("slices_to_volume: layers that overlap in part fit together") {
  slices s;
  s.layers.resize(3);
  for (std::size_t i = 0; i < 3; ++i) s.layers[i].z = static_cast<double>(i);
  s.layers[0].outer.push_back(rectangle(0, 0, 4, 4));
  s.layers[0].inner.push_back(contour{{1, 1}, {1, 3}, {3, 3}, {3, 1}});
  s.layers[1].outer.push_back(contour{{0.5, 0.25}, {5, 1}, {3.5, 5}, {-1, 3}});
  s.layers[2].outer.push_back(rectangle(1, 1, 3, 3));
  const auto v = slices_to_volume(s, clipper, {.last_height = 2});
  check_volume(v, volume_of(s, 2, v.unit));
  // what is flat on the boundary: the areas of all layers twice, less twice what neighbours share
  double flat = 0;
  std::vector<planar_regions> r;
  for (const auto& layer : s.layers) r.push_back(layer_regions(layer, clipper));
  for (std::size_t i = 0; i < 3; ++i) flat += 2 * r[i].area() - (i > 0 ? 2 * region_intersection(r[i - 1], r[i], clipper).area() : 0);
  CHECK(boundary_areas(v.mesh).first == doctest::Approx(flat).epsilon(1e-6));
}

TEST_CASE("slices_to_volume: random layers") {
  std::mt19937_64 random(12);
  for (int round = 0; round < (long_run() ? 300 : 40); ++round) {
    CAPTURE(round);
    slices s;
    const double scale = round % 2 == 0 ? 1 : 0.1;
    const bool on_grid = round % 4 < 2;
    const auto number = [&] { return on_grid ? static_cast<double>(random() % 9) : static_cast<double>(random() % 90001) / 10000; };
    for (int i = 0; i < 4; ++i) {
      slice_layer& layer = s.layers.emplace_back();
      layer.z = i * 0.25;
      for (int j = 0; j < 3; ++j) {
        contour c;
        for (int k = 3 + static_cast<int>(random() % 5); k > 0; --k) c.push_back({number() * scale, number() * scale});
        (j == 2 ? layer.inner : layer.outer).push_back(c);
      }
    }
    const auto v = slices_to_volume(s, clipper);
    check_volume(v, volume_of(s, 0.25, v.unit), on_grid);
  }
}

TEST_CASE("slices_to_volume: the layers of a sphere") {
  const auto ball = icosphere(1);
  const slices s = slice_mesh(ball, heights(ball, 0.2));
  const auto v = slices_to_volume(s, clipper);
  CHECK(v.report.notes.empty());
  check_volume(v, volume_of(s, s.layers[9].z - s.layers[8].z, v.unit));
}

TEST_CASE("slices_to_volume: a T on columns of supports") {
  CONCINO_CORPUS_OR_SKIP(path, "slices/T_supported.cli");
  slices s = load_slices(path.string());
  s.layers.erase(s.layers.begin() + 6, s.layers.begin() + 46);
  const auto v = slices_to_volume(s, clipper, {.last_height = 0.1, .thicken = 0.05, .chord_error = 0.01});
  CHECK(v.report.notes.empty());
  double part = 0, all = 0, expected = 0, supports = 0;
  const auto kind = find_poly_property<int>(v.mesh, "kind");
  for (const poly_id p : polys(v.mesh)) {
    (kind[p] == 0 ? part : all) += concino::volume(v.mesh, p);
    CHECK(concino::volume(v.mesh, p) > 0);
  }
  for (std::size_t i = 0; i < s.layers.size(); ++i) {
    const double height = i + 1 < s.layers.size() ? s.layers[i + 1].z - s.layers[i].z : 0.1;
    const planar_regions r = layer_regions(s.layers[i], clipper);
    expected += height * snapped_area(r, v.unit);
    supports += height * snapped_area(region_difference(thicken(s.layers[i].open, 0.05, clipper, {.chord_error = 0.01}), r, clipper), v.unit);
  }
  CHECK(part == doctest::Approx(expected).epsilon(1e-9));
  CHECK(all == doctest::Approx(supports).epsilon(1e-8));
  CHECK(v.inverted.empty());
}

TEST_CASE("slices_to_volume: wrong input") {
  slices s;
  CHECK(num_polys(slices_to_volume(s, clipper).mesh) == 0);
  s.layers.resize(1);
  s.layers[0].outer.push_back(rectangle(0, 0, 1, 1));
  const auto message = [&](const slices_to_volume_options& o = {}) -> std::string {
    try {
      (void)slices_to_volume(s, clipper, o);
    } catch (const invalid_argument& e) {
      return e.what();
    }
    return "";
  };
  CHECK(message() == "slices_to_volume: there is one layer; give its height as last_height");
  CHECK(message({.last_height = -1}) == "slices_to_volume: last_height is -1; it must be finite and 0 or more");
  CHECK(message({.last_height = 1, .thicken = -1}).find("thicken") != std::string::npos);
  s.layers.push_back(s.layers[0]);
  CHECK(message() == "slices_to_volume: layer 1 is not above layer 0; sort the layers by height");
  s.layers[1].z = 1;
  s.layers[1].outer.points[2][0] = std::numeric_limits<double>::quiet_NaN();
  CHECK(message() == "slices_to_volume: layer 1: outer contour 0 has a point that is not finite");
  s.layers[1].outer = {};  // a layer without area
  CHECK(num_polys(slices_to_volume(s, clipper).mesh) == 6);
  CHECK_THROWS_AS((void)slices_to_volume(s, clipper, {.progress = [](double, const char*) { return false; }}), cancelled);
}
