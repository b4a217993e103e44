#include <concino/render/arrows.hpp>

#include <concino/concepts/views.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/mesh/submesh.hpp>
#include <concino/render/detail/shapes/poisson_disk_subset.hpp>

#include <doctest/doctest.h>
#include <support/drawables.hpp>
#include <support/kinds.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

using namespace concino;
using testing::check_closed;

namespace {

/// The tail and the tip of each arrow: its points that are first and last along the vector.
struct drawn_arrow {
  vec3 tail, tip;
  double length() const { return distance(tail, tip); }
};

/// The arrows of a drawable with this many corners of cross-sections, in order.
std::vector<drawn_arrow> arrows_in(const drawable& d, std::size_t corners) {
  std::vector<drawn_arrow> all;
  for (std::size_t first = 0; first < d.points.size(); first += 3 * corners + 1) {
    vec3 tail;
    for (std::size_t k = 0; k < corners; ++k) tail += d.points[first + k] / static_cast<double>(corners);
    all.push_back({tail, d.points[first + 3 * corners]});
  }
  return all;
}

double max_norm(const vec3& x) { return std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)}); }

}  // namespace

TEST_CASE_TEMPLATE("make_arrows: begin at the centroids, along the vectors, in proportion to them", M, CONCINO_ALL_KINDS) {
  const M m = testing::grid<M>(3);
  auto g = make_poly_map<vec3>(m, vec3());
  for (const auto p : polys(m)) g[p] = vec3{1, 2, -0.5} * (1 + centroid(m, p).x);
  const drawable d = make_arrows(m, g, {.corners = 8});
  check_closed(d);
  CHECK(testing::euler_characteristic(d) == 2 * static_cast<long>(num_polys(m)));
  const auto arrows = arrows_in(d, 8);
  REQUIRE(arrows.size() == num_polys(m));
  std::size_t k = 0;
  double mean = 0, mean_length = 0;
  for (const auto p : polys(m)) {
    const drawn_arrow& a = arrows[k++];
    CHECK(max_norm(a.tail - centroid(m, p)) < 1e-12);
    CHECK(max_norm((a.tip - a.tail) / a.length() - g[p] / norm(g[p])) < 1e-12);
    CHECK(a.length() / norm(g[p]) == doctest::Approx(arrows[0].length() / norm(g[*polys(m).begin()])));
    mean += norm(g[p]);
    mean_length += a.length();
  }
  if constexpr (std::is_same_v<M, quadmesh> || std::is_same_v<M, hexmesh>) CHECK(mean_length / static_cast<double>(k) == doctest::Approx(0.75 / 3));
}

TEST_CASE("make_arrows: at verts of a mesh or of a graph, equal, centred, coloured by norm") {
  const quadmesh m = testing::grid<quadmesh>(4);
  auto g = make_vert_map<vec3>(m, vec3());
  for (const auto v : verts(m)) g[v] = vec3{0, 0, 1 + point(m, v)[0]};
  const drawable d = make_arrows(m, g, {.scale = 0.6, .equal_lengths = true, .color_by_norm = true, .centered = true, .corners = 6});
  check_closed(d);
  const auto arrows = arrows_in(d, 6);
  REQUIRE(arrows.size() == num_verts(m));
  std::size_t k = 0;
  for (const auto v : verts(m)) {
    CHECK(arrows[k].length() == doctest::Approx(0.9 / 4));
    CHECK(max_norm((arrows[k].tail + arrows[k].tip) / 2 - to_vec3(point(m, v))) < 1e-12);
    CHECK(d.values[k * 19] == norm(g[v]));
    ++k;
  }
  CHECK(d.look.scale.low() == 1);
  CHECK(d.look.scale.high() == 2);
  CHECK(make_arrows(primal(m), g).points == make_arrows(m, g).points);
}

TEST_CASE("make_arrows: rods without heads, as long as the arrows") {
  const hexmesh m = testing::grid<hexmesh>(2);
  const auto g = make_poly_map<vec3>(m, vec3{1, 2, 2});
  const auto arrows = arrows_in(make_arrows(m, g, {.centered = true, .corners = 8}), 8);
  const drawable d = make_arrows(m, g, {.heads = false, .centered = true, .corners = 8});
  check_closed(d);
  CHECK(testing::euler_characteristic(d) == 2 * 8);
  REQUIRE(d.points.size() == 8 * 16);
  for (std::size_t k = 0; k < 8; ++k) {
    vec3 tail, tip;
    for (std::size_t i = 0; i < 8; ++i) tail += d.points[16 * k + i] / 8, tip += d.points[16 * k + 8 + i] / 8;
    CHECK(max_norm(tail - arrows[k].tail) < 1e-12);
    CHECK(max_norm(tip - arrows[k].tip) < 1e-12);
  }
}

TEST_CASE("make_arrows: vectors without a direction are left out and counted; long ones are limited") {
  const quadmesh m = testing::grid<quadmesh>(4);
  auto g = make_poly_map<vec3>(m, vec3{1, 0, 0});
  g[poly_id{3}] = {};
  g[poly_id{5}] = {0, std::numeric_limits<double>::quiet_NaN(), 0};
  g[poly_id{6}] = {std::numeric_limits<double>::infinity(), 0, 0};
  g[poly_id{7}] = {1e6, 0, 0};
  g[poly_id{8}] = {0, 1e-320, 0};
  arrow_report report;
  const drawable d = make_arrows(m, g, {.corners = 6, .report = &report});
  check_closed(d);
  CHECK(report.drawn == 13);
  CHECK(report.zero == 1);
  CHECK(report.not_finite == 2);
  CHECK(report.thinned == 0);
  CHECK(std::all_of(d.points.begin(), d.points.end(), [](const vec3& p) { return is_finite(p); }));
  double longest = 0;
  for (const auto& a : arrows_in(d, 6)) longest = std::max(longest, a.length());
  CHECK(longest < 4 * 0.75 * 0.3);

  auto zero = make_poly_map<vec3>(m, vec3());
  CHECK(make_arrows(m, zero).triangles.empty());
  const quadmesh nothing;
  CHECK(make_arrows(nothing, make_poly_map<vec3>(nothing, vec3())).triangles.empty());
}

TEST_CASE("make_arrows: of some polys alone") {
  const hexmesh m = testing::grid<hexmesh>(3);
  const auto g = make_poly_map<vec3>(m, vec3{1, 0, 0});
  const drawable d = make_arrows(submesh(m, [&](poly_id p) { return centroid(m, p).z < 0.4; }), g, {.corners = 6});
  CHECK(arrows_in(d, 6).size() == 9);
  CHECK(std::all_of(d.points.begin(), d.points.end(), [](const vec3& p) { return p.z < 0.4; }));
}

TEST_CASE("make_arrows: one arrow has a length that fits the mesh; arrows scale with it") {
  auto arrays = testing::grid_arrays<quadmesh>(1);
  for (vec3& p : arrays.points) p *= 8;
  const quadmesh m(arrays);
  const auto g = make_poly_map<vec3>(m, vec3{0, 0, 3});
  CHECK(arrows_in(make_arrows(m, g, {.corners = 6}), 6)[0].length() == doctest::Approx(1.5 * std::sqrt(2.0)));
  CHECK(arrows_in(make_arrows(m, g, {.scale = 1, .corners = 6}), 6)[0].length() == doctest::Approx(3 * std::sqrt(2.0)));
}

TEST_CASE("make_arrows: many are thinned evenly, and the same ones in every run") {
  const quadmesh m = testing::grid<quadmesh>(60);
  const auto g = make_poly_map<vec3>(m, vec3{0, 0, 1});
  for (const std::size_t count : {10u, 100u, 400u}) {  // without and with a choice of one in each cell
    arrow_report report;
    const drawable d = make_arrows(m, g, {.count = count, .corners = 3, .report = &report});
    CHECK(report.drawn <= count);
    CHECK(report.drawn > count * 3 / 5);  // distances on a grid are few
    CHECK(report.drawn + report.thinned == num_polys(m));
    const auto arrows = arrows_in(d, 3);
    REQUIRE(arrows.size() == report.drawn);
    double nearest = 1;
    for (std::size_t i = 0; i < arrows.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) nearest = std::min(nearest, distance(arrows[i].tail, arrows[k].tail));
    CHECK(nearest > 0.55 / std::sqrt(static_cast<double>(count)));
    std::size_t covered = 0;  // points of the square that have an arrow near them
    for (int x = 0; x < 10; ++x)
      for (int y = 0; y < 10; ++y)
        covered += std::any_of(arrows.begin(), arrows.end(), [&](const drawn_arrow& a) { return distance(a.tail, {(x + 0.5) / 10, (y + 0.5) / 10, 0}) < 1.2 / std::sqrt(static_cast<double>(count)); });
    CHECK(covered == 100);
    CHECK(make_arrows(m, g, {.count = count, .corners = 3}).points == d.points);
  }
  CHECK(arrows_in(make_arrows(m, g, {.count = 0, .corners = 3}), 3).size() == 3600);
  CHECK(arrows_in(make_arrows(m, g, {.count = 1, .corners = 3}), 3).size() == 1);
}

TEST_CASE("make_arrows: many vectors at few places are thinned too") {
  std::vector<vec3> points(50, vec3{1, 1, 1});
  points.insert(points.end(), 50, vec3{2, 1, 1});
  CHECK(detail::poisson_disk_subset(points, 10).size() == 2);
  points.resize(50);
  CHECK(detail::poisson_disk_subset(points, 10).size() == 1);
  CHECK(detail::poisson_disk_subset(points, 50).size() == 50);
  CHECK(detail::poisson_disk_subset({}, 5).empty());
  CHECK(detail::mean_distance(points) == 0);
}

TEST_CASE("make_arrows: invalid input throws") {
  const quadmesh m = testing::grid<quadmesh>(2), other = testing::grid<quadmesh>(2);
  const auto g = make_poly_map<vec3>(m, vec3{1, 0, 0});
  CHECK_THROWS_AS(make_arrows(other, g), invalid_argument);
  CHECK_THROWS_AS(make_arrows(m, g, {.scale = 0}), invalid_argument);
  CHECK_THROWS_AS(make_arrows(m, g, {.radius = -1}), invalid_argument);
  CHECK_THROWS_AS(make_arrows(m, g, {.opacity = 1.5}), invalid_argument);
  CHECK_THROWS_AS(make_arrows(m, g, {.corners = 1}), invalid_argument);
  auto arrays = testing::grid_arrays<quadmesh>(2);
  arrays.points[0].x = std::numeric_limits<double>::quiet_NaN();
  const quadmesh broken(arrays);
  CHECK_THROWS_AS(make_arrows(broken, make_poly_map<vec3>(broken, vec3{1, 0, 0})), invalid_mesh);
}
