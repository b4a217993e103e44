// The metrics of Attene et al. of regular polygons, combs, stars and spirals, by closed forms, and of random polygons, by brute force.
#include <concino/quality/metric.hpp>

#include <concino/geometry/enclosing_ball.hpp>
#include <concino/geometry/inscribed_circle.hpp>
#include <concino/geometry/kernel.hpp>

#include <support/corpus.hpp>
#include <support/motions.hpp>
#include <support/polygons.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double pi = std::numbers::pi;

double of(const std::vector<vec3>& p, metric what) {
  return quality(p.size() == 3 ? poly_shape::triangle : p.size() == 4 ? poly_shape::quad : poly_shape::polygon, p, what);
}

/// Checks the three ratios, from the radii, the part that the kernel is, the area and the perimeter; of any position and size too.
void check_ratios(const std::vector<vec3>& x, double inside, double around, double kernel_part, double area, double perimeter) {
  auto moved = x;
  for (vec3& y : moved) y = 0x1p-20 * rotated(y + vec3{0, 0, 3});
  for (const auto& p : {x, moved}) {
    CHECK(of(p, metric::circle_ratio) == doctest::Approx(inside / around).epsilon(2e-9));
    CHECK(of(p, metric::kernel_ratio) == doctest::Approx(kernel_part).epsilon(1e-9));
    CHECK(of(p, metric::area_perimeter_ratio) == doctest::Approx(4 * pi * area / (perimeter * perimeter)).epsilon(1e-9));
  }
}

double area_of(const std::vector<vec3>& x) {
  double doubled = 0;
  for (std::size_t i = 0; i < x.size(); ++i) doubled += cross(x[i], x[(i + 1) % x.size()]).z;
  return doubled / 2;
}

}  // namespace

TEST_CASE("circle_ratio, kernel_ratio and area_perimeter_ratio: of regular polygons, combs, stars and spirals") {
  for (const std::size_t n : std::vector<std::size_t>{3, 4, 5, 8, 40}) {
    const double half = pi / static_cast<double>(n), k = static_cast<double>(n);
    check_ratios(regular_polygon(n), std::cos(half), 1, 1, k * std::sin(half) * std::cos(half), 2 * k * std::sin(half));
  }
  for (const std::size_t n : std::vector<std::size_t>{2, 3, 7}) {
    // In the corridor of width 1, a circle touches the inner corner of a turn and both outer edges, or two inner corners and the edge opposite to them.
    const double in_corner = std::sqrt(2.0) / (1 + std::sqrt(2.0)), h = 3, k = static_cast<double>(n), width = 2 * k - 1;
    check_ratios(comb_polygon(n, h), n == 2 ? in_corner : 0.625, std::hypot(width, h + 1) / 2, 0, width + k * h, 2 * width + 2 + 2 * k * h);
  }
  for (const std::size_t n : std::vector<std::size_t>{5, 8, 30}) {
    const double r = 0.3, half = pi / static_cast<double>(n), k = static_cast<double>(n);
    const double edge = std::sqrt(1 + r * r - 2 * r * std::cos(half)), area = k * r * std::sin(half);
    // The kernel has an edge on the line of each edge of the star, at the distance d of the centre. Lines of neighbouring edges of the kernel meet at two
    // angles in turn.
    const double d = area / k / edge, normal = std::fmod(std::atan2(1 - r * std::cos(half), r * std::sin(half)), 2 * half), b = std::min(normal, 2 * half - normal);
    check_ratios(star_polygon(n, r), r, 1, k * d * d * (std::tan(b) + std::tan(half - b)) / area, area, 2 * k * edge);
  }
  // Corridors of width 1 and length l: an L, and three sides of a rectangle.
  const double in_turn = std::sqrt(2.0) / (1 + std::sqrt(2.0));
  check_ratios(spiral_polygon(1), 0.5, std::sqrt(1.25), 1, 2, 6);
  check_ratios(spiral_polygon(2), in_turn, 1.25 * std::sqrt(2.0), 0.25, 4, 10);
  check_ratios(spiral_polygon(3), in_turn, std::hypot(4.5, 3.0) / 2, 0, 8, 18);
}

TEST_CASE("area_perimeter_ratio, circle_ratio and kernel_ratio: of random polygons, from their parts") {
  std::mt19937 random(54);
  for (int round = 0; round < (long_run() ? 10000 : 200); ++round) {
    const auto x = random_polygon(random, 3 + static_cast<std::size_t>(round % 10));
    double perimeter = 0;
    for (std::size_t i = 0; i < x.size(); ++i) perimeter += norm(x[(i + 1) % x.size()] - x[i]);
    check_ratios(x, inscribed_circle(x).radius, enclosing_circle(x).radius, kernel(x).area / area_of(x), area_of(x), perimeter);
  }
}
