#include <concino/render/colormap.hpp>

#include <doctest/doctest.h>

#include <limits>

using namespace concino;

namespace {

void check_color(const colormap& map, double t, double r, double g, double b) {
  const auto c = map.srgb_at(t);
  CHECK(c[0] == doctest::Approx(r).epsilon(1e-4));
  CHECK(c[1] == doctest::Approx(g).epsilon(1e-4));
  CHECK(c[2] == doctest::Approx(b).epsilon(1e-4));
}

}  // namespace

TEST_CASE("colormap: the maps have their published colours") {
  check_color(viridis, 0, 0.267004, 0.004874, 0.329415);
  check_color(viridis, 0.5, 0.128149, 0.565107, 0.550893);
  check_color(viridis, 1, 0.993248, 0.906157, 0.143936);
  check_color(cividis, 0, 0, 0.135112, 0.304751);
  check_color(cividis, 0.5, 0.486919, 0.483885, 0.470696);
  check_color(cividis, 1, 0.995737, 0.909344, 0.217772);
  // Between the stored colours: entry 72 of viridis' 256, entry 40 of cividis'.
  const auto v = viridis.srgb_at(72 / 255.0), c = cividis.srgb_at(40 / 255.0);
  CHECK(v[0] == doctest::Approx(0.214298).epsilon(0.02));
  CHECK(v[1] == doctest::Approx(0.355619).epsilon(0.02));
  CHECK(c[1] == doctest::Approx(0.242475).epsilon(0.02));
}

TEST_CASE("colormap: lightness increases in nearly equal steps") {
  for (const colormap& map : {viridis, cividis, blue_to_yellow}) {
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

TEST_CASE("colormap: values outside [0, 1] and NaN have a colour") {
  CHECK(viridis(-1) == viridis(0));
  CHECK(viridis(7) == viridis(1));
  CHECK(viridis(std::numeric_limits<double>::infinity()) == viridis(1));
  CHECK(viridis(std::numeric_limits<double>::quiet_NaN()) == viridis(0));
}
