// Whole pictures, compared with stored ones, and what must be where in them.
#include <concino/render/render.hpp>
#include <concino/render/sheet.hpp>
#include <concino/render/slicing.hpp>

#include <concino/mesh/element_map.hpp>
#include <concino/render/detail/overlays/pixel_of.hpp>

#include <support/kinds.hpp>
#include <support/stored_picture.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <vector>

using namespace concino;
using testing::check_picture;

namespace {

std::filesystem::path stored(const char* name) { return std::filesystem::path(__FILE__).parent_path() / "pictures" / name; }

render_options size(std::size_t width, std::size_t height) { return {.width = width, .height = height, .samples = 2, .occlusion_rays = 8}; }

/// The pixel at a point of the scene.
rgb pixel_at(const image& picture, const camera& c, const vec3& p) {
  const auto at = detail::pixel_of(c, picture.width(), picture.height(), p);
  REQUIRE(at);
  return picture(static_cast<std::size_t>(at->x), static_cast<std::size_t>(at->y));
}

template<class M>
image cut_of_kind() {
  const M m = testing::grid<M>(4);
  auto u = make_vert_map<double>(m, 0.0);
  for (const auto v : verts(m)) u[v] = point(m, v)[0] * point(m, v)[1];
  scene s;
  s.add(m, {.field = u, .isobands = 5, .edges = true, .visible = below('x', 0.6)});
  s.add(m, {.edges = true, .visible = !below('x', 0.6) && below('y', 0.5)});
  return render(s, size(80, 60));
}

vec3 helix(double t) { return {0.5 + 0.3 * std::cos(12 * t), t, 0.5 + 0.3 * std::sin(12 * t)}; }

}  // namespace

TEST_CASE("pictures: a cut through meshes of all kinds") {
  const std::vector<image> kinds = {cut_of_kind<trimesh>(), cut_of_kind<quadmesh>(), cut_of_kind<polygonmesh>(),
                                    cut_of_kind<tetmesh>(), cut_of_kind<hexmesh>(),  cut_of_kind<polyhedralmesh>()};
  check_picture(make_sheet(kinds, {.columns = 3, .gap = 4}), stored("kinds.png"));
}

TEST_CASE("pictures: lines in a transparent block, with arrows, points and a label") {
  const hexmesh m = testing::grid<hexmesh>(3);
  std::vector<vec3> line;
  for (int i = 0; i <= 60; ++i) line.push_back(helix(i / 60.0));
  auto g = make_poly_map<vec3>(m, vec3{0, 0, 0});
  for (const auto p : polys(m)) g[p] = {0, 1, 0};
  scene s;
  s.add(m, {.edges = true, .color = {0.3f, 0.5f, 0.9f}, .opacity = 0.2});
  s.add_lines(line, {.radius = 0.03, .color = {1, 0, 0}});
  s.add_arrows(m, g, {.scale = 0.4, .color = {0, 0.4f, 0}});
  const vec3 corners[] = {{0, 1, 1}, {1, 1, 1}};
  s.add_points(corners, {.radius = 0.025, .color = {0, 0, 1}});
  s.add_label({1, 1, 1}, "B");
  render_options o = size(160, 120);
  const camera c = frame(s.drawables(), 4.0 / 3);
  o.camera = c;
  const image picture = render(s, o);
  std::size_t red = 0;
  for (int i = 0; i < 60; ++i) {
    const rgb x = pixel_at(picture, c, helix((i + 0.5) / 60));
    red += x.r > 1.5f * x.b && x.r > 2 * x.g;
  }
  CHECK(red > 40);  // where no arrow is before it
  const rgb ball = pixel_at(picture, c, {0, 1, 1});
  CHECK(ball.b > 2 * ball.r);
  check_picture(picture, stored("lines.png"));
}

TEST_CASE("pictures: a texture, a field with its legend, a title and axes") {
  const quadmesh m = testing::grid<quadmesh>(6);
  auto u = make_vert_map<double>(m, 0.0);
  for (const auto v : verts(m)) u[v] = 100 * point(m, v).x;
  quadmesh beside = m;
  auto at = make_vert_map<std::array<float, 2>>(beside, {0, 0});
  for (const auto v : verts(beside)) {
    const vec3 p = point(m, v);
    at[v] = {static_cast<float>(p.x), static_cast<float>(p.y)};
    set_point(beside, v, p + vec3{1.1, 0, 0.3});
  }
  scene s;
  s.add(m, {.field = u, .isolines = 10});
  s.add(beside, {.texture = texture::checkerboard(4, {1, 0, 0}, {0, 0, 1}), .texture_coordinates = at});
  render_options o = size(300, 190);
  o.camera = camera::from_front;
  o.occlusion_rays = 0;
  o.ground = false;
  o.title = "Field and texture";
  o.legend = {.title = "T", .unit = "°C"};
  o.axes = axes_options{.directions = false};
  check_picture(render(s, o), stored("texture.png"));
}
