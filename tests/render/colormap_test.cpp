#include <concino/render/colormap.hpp>

#include <doctest/doctest.h>

#include <limits>

using namespace concino;

namespace {

void check_color(const colormap& map, double t, double r, double g, double b, double tolerance = 1e-4) {
  const auto c = map.srgb_at(t);
  CHECK(c[0] == doctest::Approx(r).epsilon(tolerance));
  CHECK(c[1] == doctest::Approx(g).epsilon(tolerance));
  CHECK(c[2] == doctest::Approx(b).epsilon(tolerance));
}

}  // namespace

TEST_CASE("colormap: the maps have their published colours") {
  check_color(colormap::viridis, 0, 0.267004, 0.004874, 0.329415);
  check_color(colormap::viridis, 0.5, 0.128149, 0.565107, 0.550893);
  check_color(colormap::viridis, 1, 0.993248, 0.906157, 0.143936);
  check_color(colormap::cividis, 0, 0, 0.135112, 0.304751);
  check_color(colormap::cividis, 0.5, 0.486919, 0.483885, 0.470696);
  check_color(colormap::cividis, 1, 0.995737, 0.909344, 0.217772);
  check_color(colormap::turbo, 0, 0.18995, 0.07176, 0.23217, 1e-3);
  check_color(colormap::turbo, 0.5, 0.640, 0.991, 0.236, 3e-3);  // between entries 127 and 128 of 256
  check_color(colormap::turbo, 1, 0.47960, 0.01583, 0.01055, 1e-3);
  check_color(colormap::cool_warm, 0, 59 / 255.0, 76 / 255.0, 192 / 255.0, 2e-3);
  check_color(colormap::cool_warm, 0.25, 141 / 255.0, 176 / 255.0, 254 / 255.0, 3e-3);
  check_color(colormap::cool_warm, 0.5, 221 / 255.0, 221 / 255.0, 221 / 255.0, 2e-3);
  check_color(colormap::cool_warm, 1, 180 / 255.0, 4 / 255.0, 38 / 255.0, 2e-3);
  check_color(colormap::hsv, 0, 1, 0, 0);
  check_color(colormap::hsv, 1 / 12.0, 1, 0.5, 0);
  check_color(colormap::hsv, 0.5, 0, 1, 1);
  check_color(colormap::hsv, 1, 1, 0, 0);
  check_color(colormap::blue_to_yellow, 0, 0.197, 0.174, 0.601);
  check_color(colormap::blue_to_yellow, 0.5, 0.028, 0.635, 0.686);
  check_color(colormap::blue_to_yellow, 1, 0.990, 0.890, 0.270);
  // Between the stored colours: entry 72 of viridis' 256, entry 40 of cividis', entry 76 of turbo's.
  const auto v = colormap::viridis.srgb_at(72 / 255.0), c = colormap::cividis.srgb_at(40 / 255.0), t = colormap::turbo.srgb_at(76 / 255.0);
  CHECK(v[0] == doctest::Approx(0.214298).epsilon(0.02));
  CHECK(v[1] == doctest::Approx(0.355619).epsilon(0.02));
  CHECK(c[1] == doctest::Approx(0.242475).epsilon(0.02));
  CHECK(t[1] == doctest::Approx(0.85175).epsilon(0.02));
}

TEST_CASE("colormap: the lightness of uniform maps increases in nearly equal steps") {
  for (const colormap& map : {colormap::viridis, colormap::cividis, colormap::blue_to_yellow}) {
    const int n = 64;
    const double whole = lightness(map(1)) - lightness(map(0));
    CHECK(whole > 50);
    for (int i = 0; i < n; ++i) {
      const double step = lightness(map((i + 1.0) / n)) - lightness(map(static_cast<double>(i) / n));
      CHECK(step > 0.4 * whole / n);
      CHECK(step < 1.9 * whole / n);
    }
  }
}

TEST_CASE("colormap: the lightness of a diverging map increases to its middle and is nearly symmetric") {
  const auto light = [](double t) { return lightness(colormap::cool_warm(t)); };
  for (int i = 1; i <= 32; ++i) {
    const double t = i / 64.0;
    CHECK(light(t) > light((i - 1) / 64.0));
    CHECK(light(1 - t) > light(1 - (i - 1) / 64.0));
    CHECK(std::abs(light(t) - light(1 - t)) < 6);
  }
}

TEST_CASE("colormap: values outside [0, 1] and NaN have a colour; a table of two colours is interpolated") {
  const colormap& map = colormap::viridis;
  CHECK(map(-1) == map(0));
  CHECK(map(7) == map(1));
  CHECK(map(std::numeric_limits<double>::infinity()) == map(1));
  CHECK(map(std::numeric_limits<double>::quiet_NaN()) == map(0));
  static constexpr std::array<std::array<float, 3>, 2> greys = {{{0, 0, 0}, {1, 1, 1}}};
  constexpr colormap grey(greys);
  static_assert(grey.srgb_at(0.25)[1] == 0.25f && grey.srgb_at(2)[2] == 1);
  static_assert(colormap::hsv.srgb_at(0.5)[0] == 0);
}
