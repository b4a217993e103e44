#include <concino/render/render.hpp>
#include <concino/render/shapes.hpp>

#include <concino/mesh/element_map.hpp>

#include <doctest/doctest.h>
#include <support/brute_force.hpp>
#include <support/kinds.hpp>
#include <support/threads.hpp>

#include <string>

using namespace concino;
using testing::brute_force;

namespace {

const render_options small{.width = 48, .height = 36, .samples = 2, .occlusion_rays = 8};

scene one(drawable d) {
  scene s;
  s.add(std::move(d));
  return s;
}

/// The picture of a scene that a camera sees, by brute force.
image shot_of(const scene& s, const camera& from, render_options o = small) {
  o.camera = from;
  return render(s, o, brute_force{});
}
camera framed(const scene& s, double aspect, const view_options& options = {}) { return frame(s.drawables(), aspect, options); }

bool is_white(const rgb& c) { return c.r > 0.98f && c.g > 0.98f && c.b > 0.98f; }

}  // namespace

TEST_CASE_TEMPLATE("render: a grid of any kind covers the middle of its picture, and the corners are white", M, CONCINO_KINDS) {
  const scene s = one(make_drawable(testing::grid<M>(2)));
  const image picture = shot_of(s, framed(s, 4.0 / 3), small);
  CHECK(!is_white(picture(24, 18)));
  CHECK(is_white(picture(0, 0)));
  CHECK(is_white(picture(47, 0)));
}

TEST_CASE("render: translating and scaling the scene does not change the picture") {
  const scene s = one(make_drawable(testing::grid<hexmesh>(2)));
  const image picture = shot_of(s, framed(s, 4.0 / 3), small);
  for (const double scale : {0x1p-300, 0x1p+200}) {
    scene other = s;
    for (vec3& p : other.last().points) p *= scale;
    CHECK(shot_of(other, framed(other, 4.0 / 3), small) == picture);
  }
}

TEST_CASE("render: values, bands and edges are visible; a value that is not finite is grey") {
  const quadmesh m = testing::grid<quadmesh>(1);
  auto u = make_vert_map<double>(m, 0.0);
  for (const auto v : verts(m)) u[v] = point(m, v)[0];
  const view_options front{.towards = {0, 0, 1}, .angle = 0, .margin = 0};
  render_options plain = small;
  plain.ground = false;
  plain.width = plain.height = 40;
  const auto shot = [&](const drawable& d) { return shot_of(one(d), framed(one(d), 1, front), plain); };
  drawable d = make_drawable(m, {.field = u});
  d.look.shine = 0;
  const image smooth = shot(d);
  CHECK(smooth(3, 20).b > 3 * smooth(3, 20).r);   // blue at the low end
  CHECK(smooth(36, 20).r > 3 * smooth(36, 20).b);  // yellow at the high end
  d.look.isobands = 4;
  d.look.band_width = 0.3;
  d.look.band_limit = 1;
  const image bands = shot(d);
  CHECK(bands(5, 20).r > 3 * smooth(5, 20).r);     // a white band at 1/8
  CHECK(bands(10, 20) == smooth(10, 20));          // no band at 2/8
  d.look.band_limit = 0.01;                        // less than half a pixel
  const image thin = shot(d);
  CHECK(thin(5, 20).r < 0.7f * bands(5, 20).r);
  CHECK(thin(5, 20).r > 1.1f * smooth(5, 20).r);
  d.look.isobands = 0;
  d.look.edge_width = 6;
  d.look.edge_opacity = 1;
  const image lines = shot(d);
  CHECK(lines(20, 1).g < 0.3f * smooth(20, 1).g);
  CHECK(lines(20, 20) == smooth(20, 20));          // on the diagonal that divides the square into triangles, which is no edge of the mesh
  d.look.edge_width = 0;
  d.values.assign(4, std::numeric_limits<double>::quiet_NaN());
  const rgb grey = shot(d)(20, 20);
  CHECK(grey.r == grey.g);
  CHECK(grey.g == grey.b);
}

TEST_CASE("render: bands are anti-aliased exactly") {
  for (const double band : {0.1, 0.5})
    for (const double w : {1e-6, 0.2, 1.0, 7.3}) {
      double sum = 0;
      const int n = 4000;
      for (int i = 0; i < n; ++i) {
        const double c = detail::band_coverage((i + 0.5) / n * 3, w, band);
        CHECK_MESSAGE((c >= 0 && c <= 1), c);
        sum += c;
      }
      CHECK(sum / n == doctest::Approx(band).epsilon(0.02));
    }
  CHECK(detail::band_coverage(0.5, 0.01, 0.2) == doctest::Approx(1));
  CHECK(detail::band_coverage(1, 0.01, 0.2) == doctest::Approx(0));
  CHECK(detail::band_coverage(2.6, 0.1, 0.2) == doctest::Approx(0.5));
}

TEST_CASE("render: objects cast shadows on the ground, and corners are darker") {
  const scene cube = one(make_drawable(testing::grid<hexmesh>(1)));
  render_options o = small;
  const camera c = framed(cube, 4.0 / 3, {.margin = 0.4});
  const image with = shot_of(cube, c, o);
  o.ground = false;
  const image without = shot_of(cube, c, o);
  std::size_t darker = 0;
  for (std::size_t y = 0; y < 36; ++y)
    for (std::size_t x = 0; x < 48; ++x) darker += is_white(without(x, y)) && with(x, y).r < 0.9f;
  CHECK(darker > 20);
}

TEST_CASE("render: progress goes from 0 to 1 and can cancel") {
  const scene s = one(make_drawable(testing::grid<trimesh>(1)));
  render_options o = small;
  double last = -1, first = -1;
  bool rises = true;
  const auto listen = [&](double fraction, const char* label) {
    if (first < 0) first = fraction;
    rises = rises && fraction >= last && std::string(label) == "rendering";
    last = fraction;
    return true;
  };
  o.progress = listen;
  shot_of(s, framed(s, 1), o);
  CHECK(first == 0);
  CHECK(last == 1);
  CHECK(rises);
  const auto stop = [](double fraction, const char*) { return fraction < 0.3; };
  o.progress = stop;
  CHECK_THROWS_AS(shot_of(s, framed(s, 1), o), cancelled);
}

TEST_CASE("render: something without polygons is white; an empty scene and invalid options throw") {
  CHECK(render(one(drawable{}), small, brute_force{}) == image(48, 36, {1, 1, 1}));
  CHECK_THROWS_AS(render(scene{}, small, brute_force{}), invalid_argument);
  const scene s = one(make_drawable(testing::grid<trimesh>(1)));
  const camera c = framed(s, 1);
  const auto refused = [&](auto change) {
    render_options o = small;
    change(o);
    CHECK_THROWS_AS(shot_of(s, c, o), invalid_argument);
  };
  refused([](render_options& o) { o.width = 0; });
  refused([](render_options& o) { o.height = 70000; });
  refused([](render_options& o) { o.samples = 0; });
  refused([](render_options& o) { o.occlusion_rays = -1; });
  refused([](render_options& o) { o.occlusion_distance = 0; });
  refused([](render_options& o) { o.light_size = 90; });
  refused([](render_options& o) { o.up = {0, 0, 0}; });
  refused([](render_options& o) { o.light = {0, 0, 0}; });
}

TEST_CASE("render: the picture does not depend on the number of threads") {
  const scene s = one(make_drawable(testing::grid<tetmesh>(1)));
  const camera c = framed(s, 4.0 / 3);
  const auto with = [&](int threads) {
    const testing::with_num_threads now(threads);
    return shot_of(s, c, small);
  };
  CHECK(with(1) == with(2));
  CHECK(with(1) == with(7));
}

TEST_CASE("render: what lies behind a transparent thing shows through, in the right order, and gets no shadow") {
  const auto sheet = [](double z, const rgb& color, double opacity) {
    drawable d = make_drawable(testing::grid<quadmesh>(1));
    for (vec3& p : d.points) p.z = z;
    d.look.color = color;
    d.look.shine = 0;
    d.look.opacity = opacity;
    return d;
  };
  const drawable red = sheet(0, {1, 0, 0}, 1), green = sheet(0.2, {0, 1, 0}, 0.5), blue = sheet(0.4, {0, 0, 1}, 0.25);
  const camera front = framed(one(red), 1, {.towards = {0, 0, 1}, .angle = 0, .margin = 0});
  render_options o{.width = 8, .height = 8, .samples = 1, .occlusion_rays = 0, .ground = false};
  const auto middle = [&](std::initializer_list<drawable> things) {
    scene s;
    for (const drawable& d : things) s.add(d);
    return shot_of(s, front, o)(4, 4);
  };
  const rgb alone = middle({red});
  CHECK(alone.r > 0.5f);
  for (const rgb& c : {middle({red, green, blue}), middle({blue, red, green})}) {
    CHECK(c.r == doctest::Approx(alone.r * 0.5 * 0.75));
    CHECK(c.g == doctest::Approx(alone.r * 0.5 * 0.75));
    CHECK(c.b == doctest::Approx(alone.r * 0.25));
  }
  const rgb before_white = middle({green});
  CHECK(before_white.r == doctest::Approx(0.5));
  CHECK(middle({sheet(0, {1, 0, 0}, 0)}) == rgb{1, 1, 1});
}
