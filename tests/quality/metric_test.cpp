// metric: the values of Verdict's own tests, ideal and degenerate polys, limits, names and errors.
#include <concino/quality/metric.hpp>

#include <concino/core/error.hpp>

#include <support/motions.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace cn = concino;

namespace {

using cn::metric;
using cn::poly_shape;
constexpr double inf = std::numeric_limits<double>::infinity();

struct example {
  const char* name;
  poly_shape shape;
  std::vector<cn::vec3> points;
  std::vector<std::pair<metric, double>> values;
};

// The test data of Verdict (sandialabs/verdict, unittests), 1e30 written as infinity. What differs by definition:
// - warpage is 1 - cosine^3, as in the manual, and infinite where there is no normal; Verdict returns cosine^3 and 0;
// - the angle at a concave corner of a quad is 360 degrees minus that between its edges, as in the manual; Verdict subtracts the largest one of all
//   corners, which for quad_bowtie is at another corner. distortion of that quad is left out, since Verdict takes the normal of the other half.
// - where smaller values are worse, degenerate polys have the value 0 and not 1e30: minimum_angle, collapse_ratio, normalized_inradius of tet_test2_singular,
//   and hex distortion of hex_test3_flat.
const std::vector<example> examples = {
    {"tri_simple", poly_shape::triangle, {{0, 0, 0}, {5, 0, 0}, {2.5, 4.330127, 0}},
     {{metric::area, 10.8253175}, {metric::aspect_ratio, 1}, {metric::condition, 1}, {metric::distortion, 1}, {metric::minimum_angle, 60},
      {metric::maximum_angle, 60}, {metric::shape, 1}, {metric::edge_ratio, 1}, {metric::aspect_frobenius, 1}, {metric::equiangle_skew, 0},
      {metric::normalized_inradius, 1}}},
    {"the corners of tri_six_nodes", poly_shape::triangle, {{0, 0, 0}, {1, 0, 0.2}, {0, 1, 0.4}},
     {{metric::area, 0.5477225575}, {metric::aspect_ratio, 1.3268079265}, {metric::condition, 1.1173381066}, {metric::minimum_angle, 45.406778838},
      {metric::maximum_angle, 85.823122909}, {metric::shape, 0.89498424344}, {metric::edge_ratio, 1.4005493428}, {metric::aspect_frobenius, 1.1173381066},
      {metric::equiangle_skew, 0.24322035270}}},
    {"quad_simple1", poly_shape::quad, {{0, 0, 0}, {1, 0, 0}, {1, 7, 0}, {0, 7, 0}}, {{metric::skew, 0}, {metric::aspect_ratio, 4}, {metric::max_edge_ratio, 7}}},
    {"quad_simple2", poly_shape::quad, {{2, 0, 0}, {1, 1, 2}, {0, 1, 0}, {0, 0, 0}},
     {{metric::aspect_ratio, 1.74792}, {metric::skew, 0.092450032704}, {metric::taper, 0.74535599250}, {metric::warpage, 1 - 0.008}, {metric::area, 2.6925824036},
      {metric::stretch, 0.57735026919}, {metric::minimum_angle, 56.789089239}, {metric::maximum_angle, 90}, {metric::condition, 2.3079277745},
      {metric::jacobian, 1.1141720291}, {metric::shear, 0.55708601453}, {metric::shape, 0.43328912241}, {metric::distortion, 0.56267957295},
      {metric::equiangle_skew, 0.36901011957}, {metric::radius_ratio, 1.7320508076}, {metric::med_aspect_frobenius, 1.2274682929},
      {metric::max_aspect_frobenius, 1.3416407865}, {metric::oddy, 1.6}}},
    {"quad_chevron", poly_shape::quad, {{1, 1, 1}, {3, 1, 2}, {5, 0.8, 1.3}, {2, 1.1, 3.7}},
     {{metric::aspect_ratio, 3.00675}, {metric::skew, 6.5193481489e-01}, {metric::taper, 9.8606743061e-01}, {metric::warpage, 1 + 9.9459686559e-01},
      {metric::area, 3.5562234182}, {metric::stretch, 7.4945733623e-01}, {metric::minimum_angle, 19.319495622}, {metric::maximum_angle, 226.10065328},
      {metric::condition, inf}, {metric::jacobian, -3.4157021569}, {metric::shear, 0}, {metric::shape, 0}, {metric::distortion, -9.0249845339e-01},
      {metric::equiangle_skew, 1.5122294809}, {metric::radius_ratio, 2.9914983186}, {metric::med_aspect_frobenius, 1.8922421445},
      {metric::max_aspect_frobenius, 3.5710779160}, {metric::oddy, 23.505194964}}},
    {"quad_collapsed", poly_shape::quad, {{3, 1, 1}, {6, 1, 2}, {12, 1, 4}, {9, 1, 3}},
     {{metric::aspect_ratio, inf}, {metric::skew, 1}, {metric::taper, 0}, {metric::warpage, inf}, {metric::area, 0}, {metric::stretch, 4.7140452079e-01}, {metric::minimum_angle, 0},
      {metric::maximum_angle, 180}, {metric::condition, inf}, {metric::jacobian, 0}, {metric::shear, 0}, {metric::shape, 0}, {metric::distortion, 0},
      {metric::equiangle_skew, 1}, {metric::radius_ratio, inf}, {metric::med_aspect_frobenius, inf}, {metric::max_aspect_frobenius, inf}, {metric::oddy, inf}}},
    {"quad_bowtie", poly_shape::quad, {{-1, -1, -1}, {6, 2, -1.1}, {3, -2.5, -1.15}, {4.5, 4.3, -0.9}},
     {{metric::aspect_ratio, 15.132908}, {metric::skew, 6.0840291338e-01}, {metric::taper, 4.9416251426}, {metric::warpage, 1 + 9.9972444493e-01},
      {metric::area, 3.4869452964}, {metric::stretch, 1.7893591011}, {metric::minimum_angle, 20.794246576}, {metric::maximum_angle, 360 - 21.299169815777063},
      {metric::condition, inf}, {metric::jacobian, -22.480385649}, {metric::shear, 0}, {metric::shape, 0},
      {metric::radius_ratio, 2.7490501584}, {metric::med_aspect_frobenius, 2.3523244623},
      {metric::max_aspect_frobenius, 2.8418376590}, {metric::oddy, 14.152082560}}},
    {"tet_test1", poly_shape::tet, {{-5, -5, -5}, {-5, 5, -5}, {-5, -5, 5}, {5, -5, -5}},
     {{metric::volume, 166.66666667}, {metric::condition, 1.2247448714}, {metric::jacobian, 1000}, {metric::shape, 0.83994736660}, {metric::distortion, 1},
      {metric::edge_ratio, std::numbers::sqrt2}, {metric::radius_ratio, 1.3660254038}, {metric::aspect_ratio, 1.3660254038},
      {metric::aspect_frobenius, 1.1905507890}, {metric::minimum_angle, 54.735610317}, {metric::collapse_ratio, 0.40824829046},
      {metric::equivolume_skew, 0.5}, {metric::equiangle_skew, 0.25}, {metric::normalized_inradius, 0.61401440738235424}}},
    {"tet_test2_singular", poly_shape::tet, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
     {{metric::volume, 0}, {metric::condition, inf}, {metric::jacobian, 0}, {metric::shape, 0}, {metric::distortion, 1}, {metric::edge_ratio, inf},
      {metric::radius_ratio, inf}, {metric::aspect_ratio, inf}, {metric::aspect_frobenius, inf}, {metric::equivolume_skew, inf}}},
    {"tet_incircle_right", poly_shape::tet, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{metric::inradius, 0.5 - 1 / std::sqrt(12.0)}}},
    {"tet_incircle_flat", poly_shape::tet, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0.5, 0}}, {{metric::inradius, 0}}},
    {"tet_incircle_inverted", poly_shape::tet, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, {{metric::inradius, -0.5 + 1 / std::sqrt(12.0)}}},
    {"tet_incircle_regression", poly_shape::tet, {{12, 44, 13.3}, {17, 0.003, 66}, {3, 33, 234}, {14, -123, 21}}, {{metric::inradius, 3.2723844167}}},
    {"wedge_simple", poly_shape::prism, {{0, 0, 0}, {-1, 1, 0}, {-1, 0, 0}, {0, 0, 1}, {-1, 1, 1}, {-1, 0, 1}},
     {{metric::volume, 0.5}, {metric::equiangle_skew, 0.25}, {metric::edge_ratio, std::numbers::sqrt2}}},
    {"wedge_singularity", poly_shape::prism, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
     {{metric::volume, 0}, {metric::equiangle_skew, 1}, {metric::edge_ratio, inf}}},
    {"hex_test1", poly_shape::hex, {{-.2, -.7, -.3}, {-.7, .4, -.6}, {-.5, .5, .3}, {-.3, -.5, .5}, {.5, -.8, -.2}, {.4, .4, -.6}, {.2, .5, .2}, {.5, -.3, .8}},
     {{metric::skew, 0.24588970374}, {metric::taper, 0.17845765256}, {metric::volume, 0.81566666667}, {metric::stretch, 0.62097029970},
      {metric::diagonal, 0.68962192988}, {metric::dimension, 0.52459420058}, {metric::condition, 1.2730598257}, {metric::max_aspect_frobenius, 1.2730598257},
      {metric::med_aspect_frobenius, 1.1435711972}, {metric::jacobian, 0.477}, {metric::shear, 0.77784951012}, {metric::shape, 0.78978528102},
      {metric::distortion, 0.58479771148}, {metric::nodal_jacobian_ratio, 0.42513368984}, {metric::oddy, 2.0988338297},
      {metric::edge_ratio, 1.7944358445}, {metric::equiangle_skew, 0.37159771083}}},
    {"hex_test2_perfect_cube", poly_shape::hex, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
     {{metric::skew, 0}, {metric::taper, 0}, {metric::volume, 1}, {metric::stretch, 1}, {metric::diagonal, 1}, {metric::dimension, 1 / std::sqrt(3.0)},
      {metric::condition, 1}, {metric::med_aspect_frobenius, 1}, {metric::jacobian, 1}, {metric::shear, 1}, {metric::shape, 1}, {metric::distortion, 1},
      {metric::nodal_jacobian_ratio, 1}, {metric::oddy, 0}, {metric::edge_ratio, 1}, {metric::equiangle_skew, 0}}},
    {"hex_test3_flat", poly_shape::hex, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {.1, .1, 0}, {.9, .1, 0}, {.9, .9, 0}, {.1, .9, 0}},
     {{metric::skew, inf}, {metric::taper, inf}, {metric::volume, 0}, {metric::stretch, 0.19245008973}, {metric::diagonal, 1}, {metric::dimension, 0},
      {metric::condition, inf}, {metric::med_aspect_frobenius, inf}, {metric::jacobian, 0}, {metric::shear, 0}, {metric::shape, 0},
      {metric::nodal_jacobian_ratio, -inf}, {metric::oddy, inf}, {metric::edge_ratio, 1 / std::sqrt(0.02)}, {metric::equiangle_skew, 0.5}}},
    {"hex_test4_inside_out", poly_shape::hex, {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
     {{metric::skew, 0}, {metric::taper, 0}, {metric::volume, -1}, {metric::stretch, 1}, {metric::diagonal, 1}, {metric::dimension, 1 / std::sqrt(3.0)},
      {metric::condition, inf}, {metric::med_aspect_frobenius, inf}, {metric::jacobian, -1}, {metric::shear, 0}, {metric::shape, 0}, {metric::distortion, 1},
      {metric::nodal_jacobian_ratio, -inf}, {metric::oddy, inf}, {metric::edge_ratio, 1}, {metric::equiangle_skew, 0}}},
};

}  // namespace

TEST_CASE("metric: the values of Verdict's tests") {
  for (const example& e : examples)
    for (const auto& expected : e.values) {
      const metric what = expected.first;
      const double value = expected.second;
      INFO(std::string(e.name) << ": " << std::string(cn::name_of(what)));
      const double found = cn::quality(e.shape, e.points, what);
      if (std::isinf(value)) CHECK(found == value);
      else CHECK(std::abs(found - value) < 1e-5 * std::abs(value) + 1e-5);
    }
}

namespace {

std::vector<cn::vec3> regular_polygon(unsigned n) {
  std::vector<cn::vec3> p;
  const double radius = 0.5 / std::sin(std::numbers::pi / n);
  for (unsigned i = 0; i < n; ++i) p.push_back({radius * std::cos(2 * std::numbers::pi * i / n), radius * std::sin(2 * std::numbers::pi * i / n), 0});
  return p;
}

struct regular {
  poly_shape shape;
  std::vector<cn::vec3> points;
};

/// The regular shapes with edges of length 1.
std::vector<regular> regular_shapes() {
  const double h = std::sqrt(3.0) / 2;
  return {{poly_shape::triangle, regular_polygon(3)},
          {poly_shape::quad, regular_polygon(4)},
          {poly_shape::polygon, regular_polygon(5)},
          {poly_shape::polygon, regular_polygon(9)},
          {poly_shape::tet, {{0, 0, 0}, {1, 0, 0}, {0.5, h, 0}, {0.5, h / 3, std::sqrt(2.0 / 3)}}},
          {poly_shape::hex, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}},
          {poly_shape::prism, {{0, 0, 0}, {1, 0, 0}, {0.5, h, 0}, {0, 0, 1}, {1, 0, 1}, {0.5, h, 1}}},
          {poly_shape::pyramid, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, std::sqrt(0.5)}}}};
}

template<class F>
void for_each_metric(poly_shape shape, const F& f) {
  for (std::size_t i = 0; i < cn::num_metrics; ++i)
    if (cn::is_defined(static_cast<metric>(i), shape)) f(static_cast<metric>(i));
}

std::vector<cn::vec3> jittered_points(const std::vector<cn::vec3>& points, double by, std::mt19937& random) {
  std::uniform_real_distribution<double> move(-by, by);
  std::vector<cn::vec3> moved;
  for (const cn::vec3& p : points) {
    const double x = move(random), y = move(random), z = move(random);
    moved.push_back(p + cn::vec3{x, y, z});
  }
  return moved;
}

}  // namespace

TEST_CASE("metric: regular shapes have the ideal values, and no other shape has a better one") {
  std::mt19937 random(5);
  for (const regular& r : regular_shapes())
    for_each_metric(r.shape, [&](metric what) {
      INFO(std::string(cn::name_of(r.shape)) << " " << std::string(cn::name_of(what)));
      const cn::metric_limits limits = cn::limits_of(what, r.shape);
      const double value = cn::quality(r.shape, r.points, what, 0.5);
      if (!std::isnan(limits.ideal)) {
        CHECK(value == doctest::Approx(limits.ideal).epsilon(1e-12));
        CHECK(cn::is_acceptable(what, r.shape, value));
      }
      for (const double by : {0.01, 0.1, 0.4, 2.0})
        for (unsigned k = 0; k < 10; ++k) {
          const double other = cn::quality(r.shape, jittered_points(r.points, by, random), what, 0.5);
          const bool is_in_full_range = limits.full.contains(other) || other == doctest::Approx(limits.full.low) || other == doctest::Approx(limits.full.high);
          CHECK(is_in_full_range);
          // These have no best value: sizes and their ratios, and the angles of quads that are not planar, which may all be acute.
          const bool is_bounded = limits.length_power == 0 && !std::isnan(limits.ideal) && what != metric::distortion && what != metric::stretch &&
                                  what != metric::collapse_ratio && what != metric::equivolume_skew && (what != metric::maximum_angle || r.shape != poly_shape::quad);
          if (is_bounded && !(other == doctest::Approx(value).epsilon(1e-12))) CHECK_FALSE(cn::is_worse(what, value, other));
        }
    });
}

TEST_CASE("metric: values of any position, rotation and magnitude") {
  std::mt19937 random(7);
  for (const regular& r : regular_shapes()) {
    const auto points = jittered_points(r.points, 0.1, random);
    for_each_metric(r.shape, [&](metric what) {
      INFO(std::string(cn::name_of(r.shape)) << " " << std::string(cn::name_of(what)));
      const double value = cn::quality(r.shape, points, what, 0.25);
      const unsigned power = cn::limits_of(what, r.shape).length_power;
      auto moved = points;
      for (cn::vec3& p : moved) p = cn::testing::rotated(p) + cn::vec3{1, 2, 3};
      CHECK(cn::quality(r.shape, moved, what, 0.25) == doctest::Approx(value).epsilon(1e-9));
      for (const int exponent : {-600, -90, -3, 5, 300, 1000}) {
        auto other = points;
        for (cn::vec3& p : other) p *= std::ldexp(1.0, exponent);
        const double mean = std::ldexp(0.25, exponent * (r.shape < poly_shape::tet ? 2 : 3));
        if (mean == 0 || std::isinf(mean)) continue;
        CHECK(cn::quality(r.shape, other, what, mean) == doctest::Approx(std::ldexp(value, exponent * static_cast<int>(power))).epsilon(1e-9));
      }
      for (const double factor : {1e-200, 1e150, 1e300}) {  // beyond all products
        auto other = points;
        for (cn::vec3& p : other) p *= factor;
        if (power == 0 && !std::isnan(cn::limits_of(what, r.shape).ideal)) CHECK(cn::quality(r.shape, other, what) == doctest::Approx(value).epsilon(1e-9));
      }
    });
  }
}

TEST_CASE("metric: degenerate, inverted and non-finite polys") {
  for (const regular& r : regular_shapes()) {
    auto mirrored = r.points;
    for (cn::vec3& p : mirrored) p.z = -p.z;
    for_each_metric(r.shape, [&](metric what) {
      INFO(std::string(cn::name_of(r.shape)) << " " << std::string(cn::name_of(what)));
      const cn::metric_limits limits = cn::limits_of(what, r.shape);
      const double point = cn::quality(r.shape, std::vector<cn::vec3>(r.points.size(), {3, 4, 5}), what, 1);
      if (what == metric::distortion && (r.shape == poly_shape::triangle || r.shape == poly_shape::tet)) CHECK(point == 1);
      else if (what == metric::nodal_jacobian_ratio) CHECK(point == -inf);
      else if (what == metric::equiangle_skew) CHECK(point >= 1);
      else CHECK(point == (cn::larger_is_worse(what) ? limits.full.high : 0));
      for (const double bad : {inf, std::nan("")}) {
        auto broken = r.points;
        broken.back().y = bad;
        CHECK(std::isnan(cn::quality(r.shape, broken, what, 1)));
      }
      const bool has_sign = what == metric::scaled_jacobian || what == metric::mean_ratio || what == metric::jacobian || what == metric::volume || what == metric::collapse_ratio || what == metric::inradius;
      if (r.shape >= poly_shape::tet && has_sign) CHECK(cn::quality(r.shape, mirrored, what) == doctest::Approx(-cn::quality(r.shape, r.points, what)));
    });
  }
}

TEST_CASE("metric: the mean ratio of tets is Verdict's to the power 2/3") {
  const auto corner = [](double z) { return std::vector<cn::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, z}}; };
  for (const auto& [z, value] : {std::pair{1.0, 0.769800}, {0.01, 0.01414107}, {-0.01, -0.01414107}}) {
    const double q = cn::quality(poly_shape::tet, corner(z), metric::mean_ratio);
    CHECK(std::copysign(std::pow(std::abs(q), 1.5), q) == doctest::Approx(value).epsilon(1e-5));
  }
}

TEST_CASE("metric: relations between metrics of a poly") {
  std::mt19937 random(9);
  for (const regular& r : regular_shapes())
    for (unsigned k = 0; k < 20; ++k) {
      const auto points = jittered_points(r.points, 0.3, random);
      const auto q = [&](metric what) { return cn::quality(r.shape, points, what, 0.4); };
      const double ratio = q(metric::mean_ratio);
      CHECK(q(metric::scaled_jacobian) * ratio >= 0);
      if (r.shape == poly_shape::triangle) {
        CHECK(q(metric::condition) == q(metric::aspect_frobenius));
        CHECK(q(metric::shape) == doctest::Approx(1 / q(metric::condition)));
        CHECK(q(metric::normalized_inradius) == doctest::Approx(1 / q(metric::radius_ratio)));
        CHECK(q(metric::shape_and_size) == doctest::Approx(q(metric::shape) * q(metric::relative_size_squared)));
      }
      if (r.shape == poly_shape::quad || r.shape == poly_shape::hex) {
        CHECK(q(metric::shear) == doctest::Approx(std::max(0.0, q(metric::scaled_jacobian))));
        CHECK(q(metric::shear_and_size) == doctest::Approx(q(metric::shear) * q(metric::relative_size_squared)));
        CHECK(q(metric::shape_and_size) == doctest::Approx(q(metric::shape) * q(metric::relative_size_squared)));
        CHECK(q(metric::shape) == doctest::Approx(std::max(0.0, ratio)));
      }
      if (r.shape == poly_shape::quad && ratio > 0) CHECK(q(metric::condition) == doctest::Approx(1 / q(metric::shape)));
      if (r.shape == poly_shape::tet) {
        CHECK(q(metric::volume) == doctest::Approx(q(metric::jacobian) / 6));
        CHECK(q(metric::aspect_gamma) == doctest::Approx(std::pow(std::abs(ratio), -1.5)));
        CHECK(q(metric::aspect_frobenius) == doctest::Approx(1 / std::abs(ratio)));
        if (ratio > 0) CHECK(q(metric::aspect_beta) == doctest::Approx(q(metric::radius_ratio)));
        else CHECK(q(metric::aspect_beta) == inf);
      }
    }
}

TEST_CASE("metric: special cases of polygons") {
  const std::vector<cn::vec3> concave = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}};
  CHECK(cn::quality(poly_shape::polygon, concave, metric::scaled_jacobian) < 0);
  // lines through the reflex corner cut off all but the triangle below them: they meet y = 0 at x = 4/3 and 8/3
  CHECK(cn::quality(poly_shape::polygon, concave, metric::star_shapedness) == doctest::Approx((4.0 / 3 / 2) / 10));
  CHECK(cn::quality(poly_shape::quad, std::vector<cn::vec3>{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, metric::star_shapedness) == 1);
  const std::vector<cn::vec3> spiral = {{0, 0, 0}, {5, 0, 0}, {5, 5, 0}, {1, 5, 0}, {1, 2, 0}, {3, 2, 0}, {3, 3, 0}, {2, 3, 0}, {2, 4, 0}, {4, 4, 0}, {4, 1, 0}, {0, 1, 0}};
  CHECK(cn::quality(poly_shape::polygon, spiral, metric::star_shapedness) == 0);
  // a saddle of height 1 over the unit square: all verts are sqrt(3)/2 from the mean
  CHECK(cn::quality(poly_shape::quad, std::vector<cn::vec3>{{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}}, metric::planarity) == doctest::Approx(1 - 1 / std::sqrt(3.0)));
  CHECK(cn::quality(poly_shape::polygon, regular_polygon(7), metric::planarity) == doctest::Approx(1));
}

TEST_CASE("metric: circle_ratio and area_perimeter_ratio of polygons") {
  const auto of = [](const std::vector<cn::vec3>& p, metric what) {
    return cn::quality(p.size() == 3 ? poly_shape::triangle : p.size() == 4 ? poly_shape::quad : poly_shape::polygon, p, what);
  };
  for (const unsigned n : {3u, 4u, 5u, 8u, 40u}) {
    const double half = std::numbers::pi / n;
    CHECK(of(regular_polygon(n), metric::circle_ratio) == doctest::Approx(std::cos(half)).epsilon(1e-12));
    CHECK(of(regular_polygon(n), metric::area_perimeter_ratio) == doctest::Approx(half / std::tan(half)).epsilon(1e-12));
  }
  const std::vector<cn::vec3> box = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}}, crossed = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 2, 0}};
  CHECK(of(box, metric::circle_ratio) == doctest::Approx(0.6));
  CHECK(of(box, metric::area_perimeter_ratio) == doctest::Approx(4 * std::numbers::pi * 12 / 196));
  CHECK(of(crossed, metric::circle_ratio) == 0);
  CHECK(of({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, metric::circle_ratio) == 0);
  CHECK(of({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, metric::area_perimeter_ratio) == 0);
  CHECK(cn::metric_named("kernel_ratio") == metric::star_shapedness);
  CHECK(!cn::is_defined(metric::circle_ratio, poly_shape::tet));
}

TEST_CASE("metric: names, limits and errors") {
  for (std::size_t i = 0; i < cn::num_metrics; ++i) {
    const auto what = static_cast<metric>(i);
    CHECK(cn::metric_named(cn::name_of(what)) == what);
    bool anywhere = false;
    for (std::size_t k = 0; k < cn::num_poly_shapes; ++k) anywhere = anywhere || cn::is_defined(what, static_cast<poly_shape>(k));
    CHECK(anywhere);
  }
  CHECK(cn::metric_named("aspect") == metric::aspect_ratio);
  CHECK_THROWS_WITH_AS(cn::metric_named("skewness"), doctest::Contains("no metric is called 'skewness'"), cn::invalid_argument);
  CHECK_THROWS_AS(cn::limits_of(metric::volume, poly_shape::quad), cn::unsupported);
  const std::vector<cn::vec3> four(4), three(3);
  CHECK_THROWS_AS(cn::quality(poly_shape::tet, four, metric::oddy), cn::unsupported);
  CHECK_THROWS_AS(cn::quality(poly_shape::polyhedron, four, metric::scaled_jacobian), cn::unsupported);
  CHECK_THROWS_AS(cn::quality(poly_shape::tet, three, metric::volume), cn::invalid_argument);
  CHECK_THROWS_AS(cn::quality(poly_shape::polygon, four, metric::area), cn::invalid_argument);
  CHECK(cn::is_worse(metric::aspect, 2, 1));
  CHECK(cn::is_worse(metric::shape, 1, 2));
  CHECK(cn::is_worse(metric::shape, std::nan(""), -inf));
  CHECK_FALSE(cn::is_worse(metric::shape, -inf, std::nan("")));
  CHECK_FALSE(cn::is_worse(metric::shape, std::nan(""), std::nan("")));
  CHECK(cn::is_acceptable(metric::edge_ratio, poly_shape::tet, 3));
  CHECK_FALSE(cn::is_acceptable(metric::edge_ratio, poly_shape::tet, 3.01));
  CHECK_FALSE(cn::is_acceptable(metric::shape, poly_shape::tet, std::nan("")));
  CHECK_THROWS_AS(cn::is_acceptable(metric::oddy, poly_shape::tet, 1), cn::unsupported);
  // all metrics of the manual
  const auto count = [](poly_shape shape) {
    int n = 0;
    for_each_metric(shape, [&](metric) { ++n; });
    return n;
  };
  CHECK(count(poly_shape::triangle) >= 13);
  CHECK(count(poly_shape::quad) >= 23);
  CHECK(count(poly_shape::tet) >= 16);
  CHECK(count(poly_shape::hex) >= 19);
}
