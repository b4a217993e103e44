#include <concino/print/slice_mesh.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/convert/convert.hpp>
#include <concino/edit/elements.hpp>
#include <concino/edit/flip_winding.hpp>
#include <concino/generate/boundary_surface.hpp>
#include <concino/generate/box.hpp>
#include <concino/generate/grid.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/torus.hpp>
#include <concino/generate/unite.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/io/load_any.hpp>
#include <concino/io/slices.hpp>
#include <concino/level_sets/clip.hpp>
#include <concino/print/heights.hpp>
#include <concino/print/planar_regions.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <variant>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// The area that contours enclose.
double area_of(const slice_layer& layer) {
  double sum = 0;
  for (std::size_t i = 0; i < layer.outer.size(); ++i) sum += contour_area(layer.outer[i]);
  for (std::size_t i = 0; i < layer.inner.size(); ++i) sum += contour_area(layer.inner[i]);
  return sum;
}

/// Each contour has its direction, and its polys have verts on both sides of the plane, or in it.
template<class M>
void check_layers(const M& m, const mesh_slices<M>& s) {
  for (std::size_t l = 0; l < s.layers.size(); ++l)
    for (const auto kind : {slice_lines_kind::outer, slice_lines_kind::inner}) {
      const slice_lines& lines = kind == slice_lines_kind::outer ? s.layers[l].outer : s.layers[l].inner;
      for (std::size_t i = 0; i < lines.size(); ++i) {
        CHECK((contour_area(lines[i]) > 0) == (kind == slice_lines_kind::outer));
        for (std::size_t k = 0; k < lines[i].size(); ++k) CHECK(lines[i][k] != lines[i][(k + 1) % lines[i].size()]);
        const auto passed = s.polys_of(l, kind, i);
        CHECK(!passed.empty());
        for (const poly_t<M>& p : passed) {
          bool above = false, below = false;
          for (const vert_t<M> v : adj_p2v(m, p)) {
            above = above || to_vec3(point(m, v)).z > s.layers[l].z;
            below = below || to_vec3(point(m, v)).z <= s.layers[l].z;
          }
          CHECK(above);
          CHECK(below);
        }
      }
    }
}

/// Whether a plane contains a face of a volume.
template<class M>
bool has_face_at(const M& m, double z) {
  for (const face_t<M> f : faces(m)) {
    bool in_plane = true;
    for (const vert_t<M> v : adj_f2v(m, f)) in_plane = in_plane && to_vec3(point(m, v)).z == z;
    if (in_plane) return true;
  }
  return false;
}

/// The area of the faces that clip cuts at a height.
template<class M>
double cut_area(const M& m, double z) {
  const auto upper = clip(m, plane{{0, 0, 1}, z});
  double sum = 0;
  for (const auto f : upper.cut_faces) sum += area(upper.mesh, f);
  return sum;
}

std::string message(const auto& call) {
  try {
    call();
  } catch (const error& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE_TEMPLATE("slice_mesh: a box at its own faces, and at those within", M, CONCINO_ALL_VOLUME_KINDS) {
  const M m = make_grid<M>({.cells = {2, 3, 4}, .min = {-1, 0, 0}, .max = {1, 3, 2}});
  const auto s = slice_mesh(m, {-1, 0, 0.3, 0.5, 1, 1.9, 2, 3});
  REQUIRE(s.layers.size() == 8);
  const double expected[] = {0, 6, 6, 6, 6, 6, 0, 0};
  for (std::size_t i = 0; i < 8; ++i) {
    CAPTURE(i);
    CHECK(area_of(s.layers[i]) == expected[i]);
    CHECK(s.layers[i].outer.size() == (expected[i] > 0 ? 1 : 0));
    CHECK(s.layers[i].inner.empty());
  }
  CHECK(s.layers[4].z == 1);
  check_layers(m, s);
}

TEST_CASE_TEMPLATE("slice_mesh: the surface of a box at its own faces", M, CONCINO_ALL_SURFACE_KINDS) {
  const auto volume = make_grid<hexmesh>({.cells = {2, 3, 4}, .min = {-1, 0, 0}, .max = {1, 3, 2}});
  const auto quads = boundary_surface(volume);
  const M m = [&] {
    if constexpr (arity_v<M> == 3) return make_box<trimesh>({.cells = {2, 3, 4}, .min = {-1, 0, 0}, .max = {1, 3, 2}});
    else return convert<M>(quads);
  }();
  const auto s = slice_mesh(m, {-1, 0, 0.3, 0.5, 1, 1.9, 2, 3});
  const double expected[] = {0, 6, 6, 6, 6, 6, 0, 0};
  for (std::size_t i = 0; i < 8; ++i) {
    CAPTURE(i);
    if (s.layers[i].z == 0.3 || s.layers[i].z == 1.9) CHECK(area_of(s.layers[i]) == doctest::Approx(6).epsilon(1e-14));  // diagonals are cut within
    else CHECK(area_of(s.layers[i]) == expected[i]);
    CHECK(s.layers[i].outer.size() == (expected[i] > 0 ? 1 : 0));
  }
  check_layers(m, s);
}

TEST_CASE("slice_mesh: steps, where a face in the plane ends one part and begins another") {
  auto steps = make_grid<hexmesh>({.cells = {2, 1, 2}, .max = {2, 1, 2}});
  for (const poly_id p : polys(steps))
    if (vert_mean(steps, p).x > 1 && vert_mean(steps, p).z > 1) {
      remove_poly(steps, p);
      break;
    }
  for (const auto& s : {slice_mesh(steps, {0, 1, 2}).layers, slice_mesh(boundary_surface(steps), {0, 1, 2}).layers}) {
    CHECK(area_of(s[0]) == 2);
    CHECK(area_of(s[1]) == 1);  // only the upper step is above
    CHECK(area_of(s[2]) == 0);
  }
}

TEST_CASE("slice_mesh: holes, cavities and parts") {
  const auto ring = make_torus<trimesh>({.cells = {40, 20}});
  const auto s = slice_mesh(ring, {0});
  CHECK(s.layers[0].outer.size() == 1);
  CHECK(s.layers[0].inner.size() == 1);
  check_layers(ring, s);
  auto ball = icosphere(2), cavity = icosphere(2);
  for (const vert_id v : verts(cavity)) set_point(cavity, v, 0.5 * point(cavity, v));
  const auto two = slice_mesh(unite(ball, cavity), {0.1});  // it winds around the inner ball twice
  CHECK(two.layers[0].outer.size() == 2);
  flip_winding(cavity);
  const auto hollow = slice_mesh(unite(ball, cavity), {0.1});
  CHECK(hollow.layers[0].outer.size() == 1);
  CHECK(hollow.layers[0].inner.size() == 1);
}

TEST_CASE("slice_mesh: layers, extruded, converge to the volume") {
  const auto ball = icosphere(5);
  double exact = 0, last = 0;
  for (const poly_id p : polys(ball)) exact += dot(vert_mean(ball, p), area_vector(ball, p)) / 3;
  for (const int n : {10, 20, 40, 80}) {
    double sum = 0;
    const double thickness = 2.0 / n;
    for (const slice_layer& layer : slice_mesh(ball, heights(ball, thickness)).layers) sum += area_of(layer) * thickness;
    const double error = std::abs(sum - exact) / exact;
    CHECK(error < 2.0 / n);
    if (last > 0) CHECK(error < 0.55 * last);  // order 1
    last = error;
  }
}

TEST_CASE("slice_mesh: contours of each label of a volume") {
  const auto m = make_grid<tetmesh>({.cells = {4, 4, 4}});
  auto label = make_poly_map<int>(m);
  for (const poly_id p : polys(m)) label[p] = vert_mean(m, p).x < 0.5 ? 3 : 8;
  const auto s = slice_mesh(m, {0, 0.25, 0.3, 1}, label);
  REQUIRE(s.slices::labels.size() == 2);
  CHECK(s.label_of(3) == "label 3");
  for (const std::size_t l : {0u, 1u, 2u}) {
    REQUIRE(s.layers[l].outer.size() == 2);
    CHECK(s.layers[l].outer.ids == std::vector<std::int32_t>{3, 8});
    CHECK(contour_area(s.layers[l].outer[0]) == doctest::Approx(0.5).epsilon(1e-14));
    CHECK(contour_area(s.layers[l].outer[1]) == doctest::Approx(0.5).epsilon(1e-14));
    for (const poly_id p : s.polys_of(l, slice_lines_kind::outer, 1)) CHECK(label[p] == 8);
  }
  CHECK(s.layers[3].outer.empty());
}

TEST_CASE("slice_mesh: planes through verts of volumes of the corpus cut the faces that clip cuts") {
  std::mt19937_64 random(53);
  int planes = 0, with_face = 0;
  std::vector<std::filesystem::path> files;
  for (const char* folder : {"tet", "hex", "polyhedral"}) {
    if (corpus(folder).empty()) continue;
    for (const auto& entry : std::filesystem::directory_iterator(corpus(folder)))
      if (const auto x = entry.path().extension(); (x == ".mesh" || x == ".hedra" || x == ".vtk") && entry.file_size() < (long_run() ? 10'000'000u : 200'000u)) files.push_back(entry.path());
  }
  if (files.empty()) return skip("no volumes");
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    CAPTURE(file.string());
    const auto any = load_any(file.string());
    std::visit([&]<class M>(const M& m) {
      if constexpr (dimension_v<M> == 3) {
        const box b = bounding_box(m);
        const double size = b.diagonal();
        std::vector<double> zs;
        for (const vert_t<M> v : verts(m)) zs.push_back(point(m, v).z);
        const int rounds = static_cast<int>(1000 / files.size() + 1);
        for (int i = 0; i < rounds; ++i, ++planes) {
          const double z = zs[random() % zs.size()];
          CAPTURE(z);
          const auto s = slice_mesh(m, {z});
          CHECK(s.layers[0].open.empty());
          const double found = area_of(s.layers[0]);
          if (!has_face_at(m, z)) {
            CHECK(std::abs(found - cut_area(m, z)) <= 1e-12 * size * size);
            continue;
          }
          ++with_face;
          CHECK(std::abs(found - cut_area(m, z + 1e-9 * size)) <= 1e-7 * size * size);
        }
      }
    }, any);
  }
  MESSAGE(planes << " planes, " << with_face << " with a face in them");
}

TEST_CASE("slice_mesh: planes through verts of closed surfaces of the corpus give closed layers") {
  std::mt19937_64 random(54);
  int planes = 0;
  for (const char* file : {"tri/torus.obj", "tri/two_spheres.obj", "tri/socket_genus7.off", "quad/bamboo_pen_genus8.obj", "polygon/dodecahedron.obj", "tri/two_balls.obj", "tri/ball.obj"}) {
    const auto path = corpus(file);
    if (path.empty()) continue;
    CAPTURE(file);
    std::visit([&]<class M>(const M& m) {
      if constexpr (dimension_v<M> == 2) {
        std::vector<double> zs, chosen;
        for (const vert_t<M> v : verts(m)) zs.push_back(point(m, v).z);
        for (int i = 0; i < 60; ++i) chosen.push_back(zs[random() % zs.size()]);
        const auto s = slice_mesh(m, chosen, {.accept_intersections = true});
        const double area_of_box = (bounding_box(m).max.x - bounding_box(m).min.x) * (bounding_box(m).max.y - bounding_box(m).min.y);
        for (const slice_layer& layer : s.layers) {
          ++planes;
          CHECK(layer.open.empty());
          CHECK(area_of(layer) >= 0);
          CHECK(area_of(layer) <= 2 * area_of_box);
        }
        check_layers(m, s);
      }
    }, load_any(path.string()));
  }
  if (planes == 0) return skip("no closed surfaces");
}

TEST_CASE("slice_mesh: archetypes have the layers of the meshes") {
  const auto ring = make_torus<quadmesh>({.cells = {12, 8}});
  const auto grid = make_grid<polyhedralmesh>({.cells = {2, 3, 4}, .max = {1, 1, 1}});
  const auto check = [](const auto& m, const std::vector<double>& zs) {
    const auto weak = only_embedded_mesh(m);
    const auto expected = slice_mesh(m, zs);
    const auto found = slice_mesh(weak, zs);
    CHECK(found.layers == expected.layers);
    CHECK(heights(weak, 0.1) == heights(m, 0.1));
    for (std::size_t i = 0; i < zs.size(); ++i) {
      REQUIRE(!expected.layers[i].outer.empty());
      const auto here = expected.polys_of(i, slice_lines_kind::outer, 0);
      const auto there = found.polys_of(i, slice_lines_kind::outer, 0);
      REQUIRE(here.size() == there.size());
      for (std::size_t k = 0; k < here.size(); ++k) CHECK(index_of(weak, there[k]) == index_of(m, here[k]));
    }
  };
  check(ring, {-0.3, 0, 0.1});
  check(grid, {0, 0.3, 0.5});
}

TEST_CASE("slice_mesh: slices are saved and loaded again") {
  const auto ring = make_torus<trimesh>();
  const auto s = slice_mesh(ring, heights(ring, 0.05));
  const slices again = load_slices_text(save_slices_text(s));
  CHECK(again.layers == s.layers);
}

TEST_CASE("slice_mesh: open and intersecting surfaces are refused, or sliced with a report") {
  auto open = make_box<quadmesh>({.cells = {2, 2, 2}});
  for (const poly_id p : polys(open))
    if (vert_mean(open, p).x == 1) {
      remove_poly(open, p);
      break;
    }
  CHECK(message([&] { (void)slice_mesh(open, {0.5}); }).find("slice_mesh: the surface is open at edge ") == 0);
  const auto s = slice_mesh(open, {0.25}, {.accept_open = true});
  REQUIRE(s.layers[0].open.size() + s.layers[0].outer.size() == 1);
  if (s.layers[0].open.size() == 1) {
    REQUIRE(s.report.notes.size() == 1);
    CHECK(s.report.notes[0].text() == "layer 0: open line 0 is open");
    CHECK(!s.polys_of(0, slice_lines_kind::open, 0).empty());
  }
  auto shifted = icosphere(2);
  for (const vert_id v : verts(shifted)) set_point(shifted, v, point(shifted, v) + vec3{0.5, 0.1, 0.2});
  const auto both = unite(icosphere(2), shifted);
  CHECK(message([&] { (void)slice_mesh(both, {0.5}); }).find(" intersect, and ") != std::string::npos);
  CHECK(slice_mesh(both, {0.1}, {.accept_intersections = true}).layers[0].outer.size() == 2);
  auto inside_out = icosphere(1);
  flip_winding(inside_out);
  CHECK(message([&] { (void)slice_mesh(inside_out, {0}); }) == "slice_mesh: the surface is inside out; flip_winding turns all polys");
  auto mixed = icosphere(1);
  flip_winding(mixed, poly_id{3});
  CHECK(message([&] { (void)slice_mesh(mixed, {0}); }).find("are not oriented alike") != std::string::npos);
}

TEST_CASE("slice_mesh: heights and verts that are not finite, and cancelling") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  auto ball = icosphere(1);
  CHECK(message([&] { (void)slice_mesh(ball, {0, nan}); }) == "slice_mesh: height 1 is not finite");
  CHECK_THROWS_AS((void)slice_mesh(ball, {0}, {.progress = [](double, const char*) { return false; }}), cancelled);
  set_point(ball, vert_id{2}, vec3{0, 0, nan});
  CHECK_THROWS_AS((void)slice_mesh(ball, {0}), invalid_mesh);
  CHECK_THROWS_AS((void)slice_mesh(ball, {0}, {.accept_open = true, .accept_intersections = true}), invalid_argument);
  CHECK(slice_mesh(trimesh(), {0, 1}).layers.size() == 2);
  CHECK(slice_mesh(tetmesh(), {0}).layers[0].outer.empty());
}
