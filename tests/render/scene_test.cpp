#include <concino/render/scene.hpp>
#include <concino/render/scene_png.hpp>
#include <concino/render/slicing.hpp>

#include <concino/mesh/element_map.hpp>

#include <support/brute_force.hpp>
#include <support/kinds.hpp>
#include <support/png_reader.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace concino;
using testing::brute_force;

namespace {

const render_options plain{.width = 24, .height = 24, .camera = view_options{.towards = {0, 0, 1}, .angle = 0, .margin = 0}, .samples = 1, .occlusion_rays = 0, .ground = false};

image shot(const scene& s) { return render(s, plain, brute_force{}); }

/// Whether two colours differ only in how light they are.
bool same_hue(const rgb& a, const rgb& b) {
  const float x = a.r + a.g + a.b, y = b.r + b.g + b.b;
  return std::abs(a.r / x - b.r / y) < 0.04f && std::abs(a.g / x - b.g / y) < 0.04f;  // a jittered sample sees a value up to 1/24 away
}

}  // namespace

TEST_CASE_TEMPLATE("scene: values at verts, polys, edges or faces and labels become those of the drawable", M, CONCINO_ALL_KINDS) {
  const M m = testing::grid<M>(2);
  auto at_verts = make_vert_map<double>(m, 0.0);
  for (const auto v : verts(m)) at_verts[v] = static_cast<double>(index_of(m, v));
  auto at_polys = make_poly_map<int>(m, 0);
  for (const auto p : polys(m)) at_polys[p] = static_cast<int>(index_of(m, p));
  auto at_edges = make_edge_map<float>(m, 0.0f);
  for (const auto e : edges(m)) at_edges[e] = static_cast<float>(index_of(m, e));

  const drawable v = make_drawable(m, {.field = at_verts});
  CHECK(v.values_at == value_place::points);
  for (std::size_t i = 0; i < v.points.size(); ++i) CHECK(v.values[i] == v.verts[i]);
  const drawable p = make_drawable(m, {.field = at_polys});
  CHECK(p.values_at == value_place::polygons);
  for (std::size_t i = 0; i < p.polys.size(); ++i) CHECK(p.values[i] == p.polys[i]);
  const drawable e = make_drawable(m, {.field = at_edges});
  CHECK(e.values.empty());
  REQUIRE(e.edge_values.size() == e.corners.size());
  std::vector<edge_t<M>> edge_at(edge_index_bound(m));
  for (const auto x : edges(m)) edge_at[index_of(m, x)] = x;
  for (std::size_t i = 0; i < e.polys.size(); ++i)
    for (auto c = e.offsets[i]; c < e.offsets[i + 1]; ++c) {
      const auto next = c + 1 < e.offsets[i + 1] ? c + 1 : e.offsets[i];
      const auto [a, b] = end_verts(m, edge_at[static_cast<std::size_t>(e.edge_values[c])]);
      const std::size_t x = e.verts[e.corners[c]], y = e.verts[e.corners[next]];
      CHECK(((index_of(m, a) == x && index_of(m, b) == y) || (index_of(m, a) == y && index_of(m, b) == x)));
    }
  const drawable l = make_drawable(m, {.labels = at_polys});
  CHECK(l.look.labels);
  CHECK(l.values == p.values);
  if constexpr (VolumeMesh<M>) {
    auto at_faces = make_face_map<double>(m, 0.0);
    for (const auto f : faces(m)) at_faces[f] = static_cast<double>(index_of(m, f));
    const drawable f = make_drawable(m, {.field = at_faces});
    CHECK(f.values_at == value_place::polygons);
    for (std::size_t i = 0; i < f.mesh_polygons.size(); ++i) CHECK(f.values[i] == f.mesh_polygons[i]);
  }
}

TEST_CASE_TEMPLATE("scene: hidden polys are not drawn, and faces that a cut laid bare have another colour", M, CONCINO_ALL_KINDS) {
  const M m = testing::grid<M>(2);
  scene s;
  s.add(m, {.visible = below('x', 0.5), .color = {1, 1, 1}, .exposed_color = {1, 0, 0}});
  const drawable& d = s.drawables()[0];
  std::size_t num_exposed = 0;
  for (std::size_t i = 0; i < d.polys.size(); ++i) {
    num_exposed += !d.exposed.empty() && d.exposed[i];
  }
  CHECK(num_exposed == (dimension_v<M> == 3 ? exposed_facets(m, below('x', 0.5)).size() : 0));
  CHECK((num_exposed > 0) == (dimension_v<M> == 3));
  CHECK(make_drawable(m, {.visible = below('x', -1)}).points.empty());
  scene by_map;
  by_map.add(m, {.visible = visible_polys(m, below('x', 0.5)), .color = {1, 1, 1}, .exposed_color = {1, 0, 0}});
  CHECK(by_map.drawables()[0].polys.size() == d.polys.size());
  CHECK(by_map.drawables()[0].exposed == d.exposed);
}

TEST_CASE("scene: several things, each with its own colour, map and visibility") {
  const quadmesh m = testing::grid<quadmesh>(2);
  auto u = make_vert_map<double>(m, 0.0);
  for (const auto v : verts(m)) u[v] = point(m, v)[1];
  scene s;
  s.add(m, {.field = u, .map = colormap::viridis, .visible = below('x', 0.5), .shine = 0});
  s.add(m, {.visible = !below('x', 0.5), .color = {0, 0.5f, 0}, .shine = 0});
  const image picture = shot(s);
  CHECK(same_hue(picture(18, 5), {0, 1, 0}));
  CHECK(same_hue(picture(18, 18), {0, 1, 0}));
  CHECK(same_hue(picture(5, 21), colormap::viridis(0.1)));
  CHECK(same_hue(picture(5, 2), colormap::viridis(0.9)));
}

TEST_CASE("scene: the bounds contain all that was added, and follow the last drawable") {
  scene s;
  CHECK(s.bounds().is_empty());
  for (int i = 0; i < 3; ++i) {
    drawable d;
    d.points = {{1.0 * i, 0, 0}, {0, 0, -2.0 * i}};
    s.add(d);
    CHECK(s.bounds().max == vec3{1.0 * i, 0, 0});
    CHECK(s.bounds().min == vec3{0, 0, -2.0 * i});
  }
  s.last().points.push_back({5, 6, 7});
  CHECK(s.bounds().max == vec3{5, 6, 7});
  s.add(drawable());
  CHECK(s.bounds().max == vec3{5, 6, 7});
  const scene copy = s;
  CHECK(copy.bounds().min == vec3{0, 0, -4});
}

TEST_CASE("scene: a scale that is given is used; options that are out of range and fields of another mesh are refused") {
  const trimesh m = testing::grid<trimesh>(1), other = testing::grid<trimesh>(1);
  const auto u = make_vert_map<double>(m, 3.0), foreign = make_vert_map<double>(other, 0.0);
  CHECK(make_drawable(m, {.field = u, .scale = value_scale::linear(0, 5)}).look.scale.high() == 5);
  scene s;
  CHECK_THROWS_AS(s.add(m, {.field = foreign}), invalid_argument);
  CHECK_THROWS_AS(s.add(m, {.labels = u}), invalid_argument);
  CHECK_THROWS_AS(s.add(m, {.isobands = -1}), invalid_argument);
  CHECK_THROWS_AS(s.add(m, {.edge_width = 0}), invalid_argument);
  CHECK_THROWS_AS(s.add(m, {.opacity = 1.5}), invalid_argument);
  CHECK_THROWS_AS(s.add(m, {.shine = std::numeric_limits<double>::quiet_NaN()}), invalid_argument);
  CHECK(s.drawables().empty());
}

TEST_CASE("render: a transparent background has opacities, also of the shadow") {
  scene s;
  s.add(testing::grid<hexmesh>(1), {.color = {1, 0, 0}});
  render_options o{.width = 48, .height = 36, .samples = 2, .occlusion_rays = 8};
  const image opaque = render(s, o, brute_force{});
  o.transparent_background = true;
  const image picture = render(s, o, brute_force{});
  REQUIRE(picture.has_opacity());
  CHECK(!opaque.has_opacity());
  CHECK(picture.opacity(0, 0) < 0.02f);
  CHECK(picture.opacity(24, 18) == 1);
  std::size_t shadow = 0;
  for (std::size_t y = 0; y < 36; ++y)
    for (std::size_t x = 0; x < 48; ++x) {
      const float a = picture.opacity(x, y);
      CHECK((a >= 0 && a <= 1));
      shadow += a > 0.05f && a < 0.8f && picture(x, y).r < 0.01f;
      const rgb over = mix({1, 1, 1}, picture(x, y), a);  // over white it is the opaque picture
      CHECK(over.r == doctest::Approx(opaque(x, y).r).epsilon(1e-3));
      CHECK(over.g == doctest::Approx(opaque(x, y).g).epsilon(1e-3));
    }
  CHECK(shadow > 20);
}

TEST_CASE("save_png: writes what render gives") {
  const testing::temporary_folder folder;
  scene s;
  CHECK_THROWS_AS(save_png(s, folder / "a.png", plain, brute_force{}), invalid_argument);
  CHECK(folder.num_files() == 0);
  s.add(testing::grid<trimesh>(2));
  save_png(s, folder / "a.png", plain, brute_force{});
  const std::string file = testing::read_file(folder / "a.png");
  CHECK(testing::read_png(std::vector<std::uint8_t>(file.begin(), file.end())).bytes == srgb_bytes(shot(s)));
}
