#include <concino/render/appearance.hpp>
#include <concino/render/label_colors.hpp>

#include <concino/mesh/polygonmesh.hpp>

#include <doctest/doctest.h>
#include <support/kinds.hpp>
#include <support/unlit_picture.hpp>

#include <limits>

using namespace concino;
using testing::are_close;
using testing::unlit_picture;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// The unit square, or two next to each other in the square [0, 2] x [0, 2].
drawable square() { return make_drawable(polygonmesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}})); }
drawable two_halves() {
  return make_drawable(polygonmesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}}, {{0, 1, 4, 3}, {1, 2, 5, 4}}));
}

/// The pixel that shows a point of the front face of a drawable.
rgb pixel_at(const image& picture, double x, double y) {
  const double size = static_cast<double>(picture.width());
  return picture(static_cast<std::size_t>(x * size), static_cast<std::size_t>((1 - y) * size));
}

/// Calls see(polygon, x, y) for the centre of each polygon at the front of the unit square or cube.
template<class F>
void for_each_front_polygon(const drawable& d, F&& see) {
  double front = -1;
  for (const vec3& p : d.points) front = std::max(front, p.z);
  for (std::uint32_t p = 0; p < d.polygons().size(); ++p) {
    vec3 center;
    for (std::uint32_t c = d.offsets[p]; c < d.offsets[p + 1]; ++c) center += d.points[d.corners[c]] / (d.offsets[p + 1] - d.offsets[p]);
    if (center.z > front - 1e-9) see(p, center.x, center.y);
  }
}

}  // namespace

TEST_CASE_TEMPLATE("appearance: a value of a polygon colours all of it, on every kind of mesh", M, CONCINO_KINDS) {
  drawable d = make_drawable(testing::grid<M>(2));
  d.values_at = value_place::polygons;
  for (std::size_t p = 0; p < d.polygons().size(); ++p) d.values.push_back(static_cast<double>(d.polys[p] % 7));
  d.look.scale = value_scale::linear(0, 6);
  d.look.isobands = 3;  // have no effect: there is nothing between the values
  const image mapped = unlit_picture(d, 20, 1);
  d.look.labels = true;
  const image labels = unlit_picture(d, 20, 1);
  std::size_t seen = 0;
  for_each_front_polygon(d, [&](std::uint32_t p, double x, double y) {
    CHECK(are_close(pixel_at(mapped, x, y), d.look.map(d.values[p] / 6)));
    CHECK(are_close(pixel_at(labels, x, y), label_color(d.polys[p] % 7)));
    ++seen;
  });
  CHECK(seen >= 4);
}

TEST_CASE("appearance: labels that are no whole numbers and values that are no numbers have a colour of their own") {
  drawable d = two_halves();
  d.values_at = value_place::polygons;
  d.look.labels = true;
  d.look.no_value = {1, 0, 0};
  d.values = {2.5, 23};
  image picture = unlit_picture(d);
  CHECK(are_close(pixel_at(picture, 0.2, 0.5), {1, 0, 0}));
  CHECK(are_close(pixel_at(picture, 0.8, 0.5), label_color(3)));
  d.look.labels = false;
  d.look.isobands = 2;
  d.values = {no_number, 1};
  picture = unlit_picture(d);
  CHECK(are_close(pixel_at(picture, 0.2, 0.5), {1, 0, 0}));
  CHECK(are_close(pixel_at(picture, 0.8, 0.5), d.look.map(1)));
}

TEST_CASE("appearance: labels at points end halfway between points") {
  drawable d = two_halves();
  for (const vec3& p : d.points) d.values.push_back(p.x);
  d.look.labels = true;
  const image picture = unlit_picture(d);
  CHECK(are_close(pixel_at(picture, 0.2, 0.4), label_color(0)));
  CHECK(are_close(pixel_at(picture, 0.3, 0.4), label_color(1)));
  CHECK(are_close(pixel_at(picture, 0.7, 0.4), label_color(1)));
  CHECK(are_close(pixel_at(picture, 0.8, 0.4), label_color(2)));
}

TEST_CASE("appearance: values at corners are interpolated in each polygon and may differ at a common edge") {
  drawable d = two_halves();
  d.values_at = value_place::corners;
  for (std::size_t c = 0; c < 8; ++c) d.values.push_back(c < 4 ? 0.25 : d.points[d.corners[c]].x - 1);  // constant on the left, from 0 to 1 on the right
  const image picture = unlit_picture(d);
  CHECK(are_close(pixel_at(picture, 0.1, 0.3), d.look.map(0.25)));
  CHECK(are_close(pixel_at(picture, 0.45, 0.8), d.look.map(0.25)));
  CHECK(are_close(pixel_at(picture, 0.52, 0.5), d.look.map(0.05), 0.03f));
  CHECK(are_close(pixel_at(picture, 0.75, 0.5), d.look.map(0.5), 0.06f));
}

TEST_CASE("appearance: no triangulation shows in polygons with values at points") {
  const polygonmesh hexagon({{0, 0, 0}, {0.6, 0, 0}, {1, 0.3, 0}, {1, 1, 0}, {0.4, 1, 0}, {0, 0.7, 0}}, {{0, 1, 2, 3, 4, 5}});
  for (drawable d : {square(), make_drawable(hexagon)}) {
    for (std::size_t i = 0; i < d.points.size(); ++i) d.values.push_back(static_cast<double>(i % 2));
    d.look.map = colormap::viridis;
    const image picture = unlit_picture(d, 48);
    std::size_t seen = 0;
    for (const auto& t : d.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t i = t[k], j = t[(k + 1) % 3], n = d.offsets[1];
        if (j == (i + 1) % n || i == (j + 1) % n) continue;  // an edge of the polygon
        const vec3 a = d.points[i], along = d.points[j] - a, side = vec3{-along.y, along.x, 0} / norm(along) * 0.03;
        // The colour on a diagonal is between those on its two sides; if triangles were shaded by themselves there would be a kink.
        for (const double s : {0.3, 0.5, 0.7}) {
          const vec3 p = a + along * s, left = p + side, right = p - side;
          CHECK(are_close(pixel_at(picture, p.x, p.y), mix(pixel_at(picture, left.x, left.y), pixel_at(picture, right.x, right.y), 0.5f), 0.03f));
          ++seen;
        }
      }
    CHECK(seen >= 6);
  }
  // Values at the four points of a square are symmetric to both diagonals: so is the picture.
  drawable d = square();
  d.values = {0, 1, 0, 1};
  d.look.isobands = 5;
  const image picture = unlit_picture(d, 40, 4);
  for (std::size_t y = 1; y < 39; ++y)
    for (std::size_t x = 1; x < 39; ++x) CHECK_MESSAGE(are_close(picture(x, y), picture(y, x), 0.2f), x << " " << y);
}

TEST_CASE("appearance: iso-lines have a constant width in pixels, whatever the slope of the values is") {
  drawable d = two_halves();
  d.look.color = {1, 1, 1};
  for (const vec3& p : d.points) d.values.push_back(p.x < 1 ? 0 : p.x < 2 ? 0.25 : 1);
  static constexpr std::array<std::array<float, 3>, 2> white = {{{1, 1, 1}, {1, 1, 1}}};
  d.look.map = colormap(white);
  d.look.isolines = 8;  // at 1/16, 3/16 on the left, six on the right
  d.look.isoline_color = {0, 0, 0};
  for (const double width : {1.0, 3.0}) {
    d.look.isoline_width = width;
    const image picture = unlit_picture(d, 96);
    double left = 0, right = 0;
    for (std::size_t x = 0; x < 96; ++x) (x < 48 ? left : right) += 1 - picture(x, 50).r;
    CHECK(left == doctest::Approx(2 * width).epsilon(0.05));
    CHECK(right == doctest::Approx(6 * width).epsilon(0.05));
    CHECK(picture(12, 50).r + picture(11, 50).r < 1.1);  // the line at 1/16, a quarter of the left half
    CHECK(picture(24, 50).r > 0.99);
  }
}

TEST_CASE("appearance: colours of points, polygons and corners are drawn instead of values") {
  drawable d = two_halves();
  d.values.assign(6, 0.5);
  d.colors = {{1, 0, 0}, {0, 0, 1}};
  image picture = unlit_picture(d);
  CHECK(are_close(pixel_at(picture, 0.25, 0.5), {1, 0, 0}));
  CHECK(are_close(pixel_at(picture, 0.75, 0.5), {0, 0, 1}));
  d.colors_at = value_place::points;
  d.colors.clear();
  for (const vec3& p : d.points) d.colors.push_back({static_cast<float>(p.x / 2), static_cast<float>(p.y / 2), 0});
  picture = unlit_picture(d);
  CHECK(are_close(pixel_at(picture, 0.3, 0.8), {0.3f, 0.8f, 0}, 0.02f));
  d.colors_at = value_place::corners;
  d.colors.assign(8, {0, 1, 0});
  for (std::size_t c = 4; c < 8; ++c) d.colors[c] = {0, 0, 1};
  picture = unlit_picture(d);
  CHECK(are_close(pixel_at(picture, 0.45, 0.5), {0, 1, 0}));
  CHECK(are_close(pixel_at(picture, 0.55, 0.5), {0, 0, 1}));
}

TEST_CASE("appearance: edges have the colours of their values") {
  drawable d = square();
  d.edge_values = {0, 1, no_number, 0.5};  // at the bottom, right, top, left
  d.look.edge_width = 8;
  d.look.edge_opacity = 1;
  const image picture = unlit_picture(d);
  CHECK(are_close(pixel_at(picture, 0.5, 0.03), d.look.map(0)));
  CHECK(are_close(pixel_at(picture, 0.97, 0.5), d.look.map(1)));
  CHECK(are_close(pixel_at(picture, 0.5, 0.97), d.look.no_value));
  CHECK(are_close(pixel_at(picture, 0.03, 0.5), d.look.map(0.5)));
  CHECK(are_close(pixel_at(picture, 0.5, 0.5), d.look.color));
}

TEST_CASE("appearance: polygons that a cut laid bare have another colour") {
  drawable d = two_halves();
  d.exposed = {0, 1};
  const image picture = unlit_picture(d);
  CHECK(are_close(pixel_at(picture, 0.25, 0.5), d.look.color));
  CHECK(are_close(pixel_at(picture, 0.75, 0.5), d.look.exposed_color));
}
