#include <concino/render/texture.hpp>

#include <doctest/doctest.h>
#include <support/unlit_picture.hpp>

#include <limits>

using namespace concino;
using testing::are_close;
using testing::unlit_picture;

namespace {

constexpr rgb red{1, 0, 0}, green{0, 1, 0}, blue{0, 0, 1}, white{1, 1, 1}, black{0, 0, 0};

/// Red and green above blue and white.
image four_colors() {
  image picture(2, 2);
  picture(0, 0) = red, picture(1, 0) = green, picture(0, 1) = blue, picture(1, 1) = white;
  return picture;
}

/// A square of the plane z = 0 with texture coordinates (0, 0) to (1, 1).
drawable square(double size = 1) {
  drawable d;
  d.points = {{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}};
  d.offsets = {0, 4};
  d.corners = {0, 1, 2, 3};
  d.normals.assign(4, {0, 0, 1});
  d.polys = {0};
  d.triangles = {{0, 1, 2}, {0, 2, 3}};
  d.polygon_of = {0, 0};
  d.texture_coordinates = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  return d;
}

/// The mean over a square of width w about (u, v), from 400 x 400 points.
rgb mean_of(const texture& t, double u, double v, double w) {
  rgb sum;
  for (int j = 0; j < 400; ++j)
    for (int i = 0; i < 400; ++i) sum += t(u + w * ((i + 0.5) / 400 - 0.5), v + w * ((j + 0.5) / 400 - 0.5)).color;
  return sum * (1 / 160000.0f);
}

texture_steps square_steps(double w) { return {.u_right = w, .v_up = w}; }

}  // namespace

TEST_CASE("texture: a checkerboard has squares of two colours; a sample sees its mean") {
  const texture t = texture::checkerboard(4, red, blue);
  CHECK(are_close(t(0.1, 0.1).color, red));
  CHECK(are_close(t(0.3, 0.1).color, blue));
  CHECK(are_close(t(0.3, 0.3).color, red));
  CHECK(are_close(t(-0.1, 0.1).color, blue));
  CHECK(are_close(t(7.1, -3.1).color, blue));
  CHECK(t(0.1, 0.1).cover == 1);
  for (const double w : {0.02, 0.3, 0.7})
    for (const auto& [u, v] : {std::array{0.24, 0.1}, std::array{0.5, 0.5}, std::array{0.9, 0.26}})
      CHECK(are_close(t(u, v, square_steps(w)).color, mean_of(t, u, v, w)));
  CHECK(are_close(t(0.1, 0.1, square_steps(1e9)).color, {0.5f, 0, 0.5f}));
  CHECK(are_close(t(0.1, 0.1, square_steps(std::numeric_limits<double>::infinity())).color, {0.5f, 0, 0.5f}));
}

TEST_CASE("texture: lines have a width in pixels, and nothing between them") {
  const texture t = texture::isolines(10, red, 2);
  const texture_steps pixel = square_steps(0.001);
  CHECK(t(0.3, 0.55, pixel).cover == doctest::Approx(1));
  CHECK(t(0.3009, 0.55, pixel).cover > 0.5);  // nearly one pixel from the line
  CHECK(t(0.302, 0.55, pixel).cover == 0);
  CHECK(t(0.35, 0.2, pixel).cover == doctest::Approx(1));
  CHECK(are_close(t(0.35, 0.2, pixel).color, red));
  double covered = 0;
  for (int i = 0; i < 1000; ++i) covered += t((i + 0.5) / 1000, 0.55, pixel).cover;
  CHECK(covered == doctest::Approx(20));  // ten lines of two pixels
}

TEST_CASE("texture: a picture is interpolated between the centres of its pixels, with v upward") {
  const texture t = texture::from(four_colors());
  CHECK(are_close(t(0.25, 0.75).color, red));
  CHECK(are_close(t(0.75, 0.75).color, green));
  CHECK(are_close(t(0.25, 0.25).color, blue));
  CHECK(are_close(t(0.75, 0.25).color, white));
  CHECK(are_close(t(0.5, 0.75).color, {0.5f, 0.5f, 0}));
  CHECK(are_close(t(3.25, -0.25).color, red));  // repeated
  CHECK(are_close(t(0, 0.75).color, {0.5f, 0.5f, 0}));
  const texture c = texture::from(four_colors(), texture::outside::clamp);
  CHECK(are_close(c(0, 0.9).color, red));
  CHECK(are_close(c(-7, 1e300).color, red));
  CHECK(are_close(c(7, -1e300).color, white));
  CHECK(are_close(t(0.1, 0.1, square_steps(9)).color, {0.5f, 0.5f, 0.5f}));
  CHECK(are_close(t(0.1, 0.1, {.u_right = std::numeric_limits<double>::infinity()}).color, {0.5f, 0.5f, 0.5f}));
  CHECK(!texture());
  CHECK(texture()(0.5, 0.5).cover == 0);
  CHECK(t(std::numeric_limits<double>::quiet_NaN(), 0).cover == 0);
}

TEST_CASE("texture: a small or slanted picture has the mean colour of each sample") {
  image stripes(64, 48);
  for (std::size_t y = 0; y < 48; ++y)
    for (std::size_t x = 0; x < 64; ++x) stripes(x, y) = x % 2 ? white : black;
  const texture t = texture::from(stripes);
  CHECK(t(0.5078125, 0.3).color.r == doctest::Approx(0));  // the centre of pixel 32
  for (const double u : {0.1, 0.37, 0.81}) {
    CHECK(t(u, 0.3, square_steps(0.1)).color.r == doctest::Approx(0.5).epsilon(0.02));
    CHECK(t(u, 0.3, {.u_right = 0.1, .v_up = 0.01}).color.r == doctest::Approx(0.5).epsilon(0.1));
  }
  CHECK(t(0.5078125, 0.3, {.u_right = 0.001, .v_up = 0.1}).color.r < 0.1);  // a sample that is longer along the stripes does not blur them
}

TEST_CASE("texture: opacities of a picture let what is below show") {
  image picture = four_colors();
  picture.add_opacity();
  picture.opacity(0, 0) = 0.25f;
  const texture t = texture::from(picture);
  CHECK(t(0.25, 0.75).cover == 0.25f);
  CHECK(t(0.25, 0.75).color == rgb{0.25f, 0, 0});
  drawable d = square();
  d.look.color = white;
  d.look.texture = t;
  const image seen = unlit_picture(d);
  CHECK(are_close(seen(10, 10), {1, 0.75f, 0.75f}, 0.1f));
  CHECK(are_close(seen(30, 10), green, 0.1f));
}

TEST_CASE("texture: appears on a drawable where its texture coordinates say") {
  drawable d = square(3);
  d.look.texture = texture::from(four_colors());
  image seen = unlit_picture(d);
  CHECK(are_close(seen(10, 10), red, 0.1f));
  CHECK(are_close(seen(30, 10), green, 0.1f));
  CHECK(are_close(seen(10, 30), blue, 0.1f));
  CHECK(are_close(seen(30, 30), white, 0.1f));
  d.look.texture = texture::checkerboard(2, red, blue);
  seen = unlit_picture(d);
  CHECK(seen(10, 10) == seen(12, 12));
  CHECK(are_close(seen(10, 10), blue));
  CHECK(are_close(seen(10, 30), red));
  d.look.texture = texture::isolines(2, black, 4);
  d.look.color = white;
  seen = unlit_picture(d);
  CHECK(are_close(seen(20, 10), black, 0.02f));
  CHECK(are_close(seen(10, 20), black, 0.02f));
  CHECK(are_close(seen(10, 10), white, 0.02f));
  d.texture_coordinates[2][0] = std::numeric_limits<float>::quiet_NaN();
  CHECK(are_close(unlit_picture(d)(30, 10), d.look.no_value));
  d.texture_coordinates.clear();
  CHECK(are_close(unlit_picture(d)(20, 10), white));
}

TEST_CASE("texture: a checkerboard that reaches to the horizon becomes grey, without patterns of its own") {
  drawable d = square(200);
  d.look.texture = texture::checkerboard(200, white, black);
  d.look.shine = 0;
  render_options o{.width = 64, .height = 48, .samples = 1, .occlusion_rays = 0, .ground = false};
  o.camera = perspective_camera({100, -6, 6}, {100, 25, 0}, {0, 0, 1}, 40);
  const image seen = render(scene().add(d), o);
  const auto contrast = [&](std::size_t y) {
    float low = 9, high = 0;
    for (std::size_t x = 16; x < 48; ++x) low = std::min(low, seen(x, y).r), high = std::max(high, seen(x, y).r);
    return high - low;
  };
  CHECK(contrast(40) > 0.6);
  std::size_t far = 0;
  while (far < 48 && seen(32, far) == white) ++far;  // the horizon
  REQUIRE(far < 24);
  for (std::size_t y = far + 1; y < far + 4; ++y) CHECK_MESSAGE(contrast(y) < 0.15, y);
}

TEST_CASE("texture: an empty picture and counts that are not positive throw") {
  CHECK_THROWS_AS(texture::from(image()), invalid_argument);
  CHECK_THROWS_AS(texture::checkerboard(0), invalid_argument);
  CHECK_THROWS_AS(texture::isolines(std::numeric_limits<double>::infinity()), invalid_argument);
  CHECK_THROWS_AS(texture::isolines(3, red, -1), invalid_argument);
}
