#include <concino/render/render.hpp>

#include <concino/mesh/element_map.hpp>

#include <doctest/doctest.h>
#include <support/kinds.hpp>

#include <limits>

using namespace concino;

namespace {

const render_options small{.width = 320, .height = 240, .samples = 1, .occlusion_rays = 0, .ground = false};

bool is_white(const rgb& c) { return c.r > 0.98f && c.g > 0.98f && c.b > 0.98f; }
/// Whether anything is drawn in columns [from, to) of some rows.
bool drawn(const image& picture, std::size_t left, std::size_t right, std::size_t top, std::size_t bottom) {
  for (std::size_t y = top; y < bottom; ++y)
    for (std::size_t x = left; x < right; ++x)
      if (!is_white(picture(x, y))) return true;
  return false;
}

scene with_field() {
  const trimesh m = testing::grid<trimesh>(3);
  auto u = make_vert_map<double>(m, 0.0);
  for (const auto v : verts(m)) u[v] = point(m, v)[0];
  scene s;
  s.add(m, {.field = u});
  return s;
}

}  // namespace

TEST_CASE("render: title, legend and axes lie beside the scene, which makes room for them") {
  const scene s = with_field();
  render_options o = small;
  o.camera = camera::from_front;
  const image bare = render(s, o);
  CHECK(drawn(bare, 150, 170, 10, 24));  // the square is nearly as high as the picture
  o.title = "Title";
  o.legend = {.title = "T", .unit = "K"};
  o.axes = axes_options{};
  const image picture = render(s, o);
  const pixel_box legend = legend_box(o.width, o.height, s.drawables()[0].look, o.legend);
  image only_texts(o.width, o.height, {1, 1, 1});
  draw_legend(only_texts, s.drawables()[0].look, o.legend);
  draw_title(only_texts, o.title);
  std::size_t differ = 0;
  for (std::size_t y = 0; y < o.height; ++y)
    for (std::size_t x = 0; x < o.width; ++x)
      if (!is_white(only_texts(x, y))) differ += !(picture(x, y) == only_texts(x, y));
  CHECK(differ == 0);  // nothing of the scene lies below them
  CHECK(legend.right <= 320);
  CHECK(!is_white(picture(160, 120)));
  CHECK(drawn(picture, 0, 120, 180, 240));  // the directions of the axes, and numbers
}

TEST_CASE("render: a camera that is given is not moved for a legend") {
  const scene s = with_field();
  render_options o = small;
  const camera c = frame(s.drawables(), 4.0 / 3);
  o.camera = c;
  o.legend.show = true;
  const image picture = render(s, o);
  o.legend.show = false;
  const image bare = render(s, o);
  CHECK(picture(160, 120) == bare(160, 120));
  CHECK(picture(80, 120) == bare(80, 120));
}

TEST_CASE("render: labels are written beside their points, unless something hides them") {
  scene s;
  s.add(testing::grid<hexmesh>(1), {.color = {1, 1, 1}});
  render_options o = small;
  o.width = 160, o.height = 120;
  o.camera = view_options{.towards = {0, 0, 1}, .angle = 0, .margin = 0.5};
  const auto num_changed = [&](const vec3& x) {
    scene labelled = s;
    labelled.add_label(x, "A");
    const image without = render(s, o), with = render(labelled, o);
    std::size_t n = 0;
    for (std::size_t y = 0; y < o.height; ++y)
      for (std::size_t i = 0; i < o.width; ++i) n += !(with(i, y) == without(i, y));
    return n;
  };
  CHECK(num_changed({0.5, 0.5, 1}) > 20);   // on the front
  CHECK(num_changed({0.5, 1, 1}) > 20);   // at the outline
  CHECK(num_changed({0.5, 0.5, 0}) == 0);   // on the back
  CHECK(num_changed({0.5, 0.5, 2}) > 20);   // before it
  CHECK(num_changed({1.2, 0.5, -1}) > 20);  // behind it, but beside it in the picture
  CHECK_THROWS_AS(s.add_label({0, std::numeric_limits<double>::quiet_NaN(), 0}, "A"), invalid_argument);
}

TEST_CASE("render: a legend without values, and sizes and options of texts that are out of range, are refused") {
  scene s;
  s.add(testing::grid<trimesh>(1));
  render_options o = small;
  o.legend.title = "T";
  CHECK_THROWS_AS(render(s, o), invalid_argument);
  o = small;
  o.axes = axes_options{.ticks = 0};
  CHECK_THROWS_AS(render(s, o), invalid_argument);
  o = small;
  o.width = 0;
  CHECK_THROWS_AS(render(s, o), invalid_argument);
}
