#include <concino/render/turntable.hpp>

#include <doctest/doctest.h>
#include <support/brute_force.hpp>
#include <support/kinds.hpp>
#include <support/png_reader.hpp>
#include <support/temporary.hpp>

#include <cstdlib>
#include <string>
#include <vector>

using namespace concino;
using testing::brute_force;

namespace {

const render_options small{.width = 40, .height = 30, .samples = 1, .occlusion_rays = 0, .ground = false};

auto picture_at(const std::string& path) {
  const std::string file = testing::read_file(path);
  return testing::read_png(std::vector<std::uint8_t>(file.begin(), file.end()));
}

}  // namespace

TEST_CASE("save_turntable: frames show a scene from all around, and none cuts it") {
  const testing::temporary_folder folder;
  scene s;
  s.add(testing::grid<hexmesh>(1), {.color = {1, 0, 0}});
  const auto paths = save_turntable(s, folder / "film.png", 8, small, brute_force{});
  REQUIRE(paths.size() == 8);
  CHECK(paths.front() == folder / "film_000.png");
  CHECK(paths.back() == folder / "film_007.png");
  std::vector<std::vector<std::uint8_t>> frames;
  for (const auto& path : paths) {
    const auto png = picture_at(path);
    REQUIRE(png.width == 40);
    REQUIRE(png.height == 30);
    frames.push_back(png.bytes);
    CHECK(png.bytes[3 * (15 * 40 + 20) + 1] < 100);  // red in the middle
    for (std::size_t x = 0; x < 40; ++x) CHECK(png.bytes[3 * x + 1] > 250);  // and white in the first row
  }
  CHECK(frames[0] != frames[1]);
  // A cube looks the same after a quarter of a turn, but for rounding.
  std::size_t differ = 0;
  for (std::size_t i = 0; i < frames[0].size(); ++i) differ += std::abs(int{frames[0][i]} - int{frames[2][i]}) > 8;
  CHECK(differ < frames[0].size() / 50);
}

TEST_CASE("save_turntable: a camera that is given stays as far away; names of frames; errors") {
  const camera c = orthographic_camera({0.5, 0.5, 5}, {0.5, 0.5, 0.5}, {0, 1, 0}, 2);
  const camera half = detail::turned(c, {0.5, 0.5, 0.5}, {0, 1, 0}, 3.14159265358979323846);
  CHECK(norm(half.eye - vec3{0.5, 0.5, -4}) == doctest::Approx(0));
  CHECK(norm(half.back - vec3{0, 0, -1}) == doctest::Approx(0));
  CHECK(detail::turned(c, {0.5, 0.5, 0.5}, {0, 1, 0}, 0.1).eye.x > 0.5);
  CHECK(detail::frame_path("a.b/film", 7, 10) == "a.b/film_007");
  CHECK(detail::frame_path("film.v2.png", 12, 20000) == "film.v2_00012.png");
  CHECK(detail::frame_path(".png", 0, 1) == ".png_000");
  scene s;
  CHECK_THROWS_AS(save_turntable(s, "a.png", 2, small, brute_force{}), invalid_argument);
  s.add(testing::grid<trimesh>(1));
  CHECK_THROWS_AS(save_turntable(s, "a.png", 0, small, brute_force{}), invalid_argument);
  CHECK_THROWS_AS(save_turntable(s, "/no/such/folder/a.png", 2, small, brute_force{}), io_error);
}
