#include <concino/render/polygon_weights.hpp>

#include <doctest/doctest.h>

#include <random>

using namespace concino;

namespace {

const vec3 up{0, 0, 1};
const std::vector<vec3> letter_l = {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}};

double at(const std::vector<vec3>& polygon, const std::vector<double>& values, const vec3& x) {
  std::vector<double> w;
  polygon_weights(polygon, up, x, w);
  double sum = 0;
  for (std::size_t i = 0; i < w.size(); ++i) sum += w[i] * values[i];
  return sum;
}

}  // namespace

TEST_CASE("polygon_weights: are exact for linear functions, in and on the edges of a concave polygon") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> f;
  for (const vec3& p : letter_l) f.push_back(2 * p.x - 3 * p.y + 1);
  for (int i = 0; i < 500; ++i) {
    const vec3 x = i % 2 ? vec3{3 * unit(random), unit(random), 0} : vec3{unit(random), 4 * unit(random), 0};
    CHECK(at(letter_l, f, x) == doctest::Approx(2 * x.x - 3 * x.y + 1).epsilon(1e-9));
  }
  for (std::size_t i = 0; i < letter_l.size(); ++i)
    for (const double t : {0.0, 0.25, 0.9}) {
      const std::size_t j = (i + 1) % letter_l.size();
      std::vector<double> only_i(letter_l.size(), 0.0);
      only_i[i] = 1;
      CHECK(at(letter_l, only_i, letter_l[i] + (letter_l[j] - letter_l[i]) * t) == doctest::Approx(1 - t));
    }
}

TEST_CASE("polygon_weights: are equal at the centre of a square; points off the plane are projected") {
  const std::vector<vec3> square = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  std::vector<double> w;
  polygon_weights(square, up, {1, 1, 0.3}, w);
  for (const double x : w) CHECK(x == doctest::Approx(0.25));
}

TEST_CASE("polygon_weights: are finite with sum 1 on polygons without area") {
  for (const auto& polygon : {std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, std::vector<vec3>(5, vec3{1, 1, 1})})
    for (const vec3& x : {vec3{0.5, 1, 0}, vec3{1, 1, 1}, vec3{9, 0, 0}}) {
      std::vector<double> w;
      polygon_weights(polygon, up, x, w);
      double sum = 0;
      for (const double y : w) sum += y;
      CHECK(sum == doctest::Approx(1));
    }
}
