#include <concino/repair/repair.hpp>

#include <concino/edit/elements.hpp>
#include <concino/mesh/property.hpp>
#include <concino/repair/detail/point_clusters.hpp>
#include <concino/validate.hpp>

#include <support/kinds.hpp>
#include <support/same_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

using namespace concino;
using namespace concino::testing;

namespace {

/// The clusters, by trying all pairs again and again.
std::vector<std::uint32_t> clusters_by_pairs(const std::vector<vec3>& points, double tolerance) {
  std::vector<std::uint32_t> first(points.size());
  for (std::uint32_t i = 0; i < first.size(); ++i) first[i] = i;
  for (bool any = true; any;) {
    any = false;
    for (std::uint32_t i = 0; i < first.size(); ++i)
      for (std::uint32_t j = 0; j < i; ++j)
        if (first[i] != first[j] && distance(points[i], points[j]) <= tolerance)
          first[i] = first[j] = std::min(first[i], first[j]), any = true;
  }
  return first;
}

std::vector<vec3> sorted_means(const concino::detail::point_clusters& c) {
  std::vector<vec3> means;
  for (std::uint32_t i = 0; i < c.first.size(); ++i)
    if (c.first[i] == i) means.push_back(c.mean[i]);
  std::sort(means.begin(), means.end(), [](const vec3& a, const vec3& b) { return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z; });
  return means;
}

}  // namespace

TEST_CASE("repair: clusters of points are those of all pairs, at any scale and in any order") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(0, 1);
  for (const double tolerance : {0.0, 1e-14, 0.01, 0.05, 0.3, 5.0})
    for (const double scale : {1.0, 1e-150, 1e150}) {
      std::vector<vec3> points;
      for (int i = 0; i < 400; ++i) points.push_back(scale * vec3{at(random), at(random), 0.1 * at(random)});
      for (std::size_t i = 0; i < 40; ++i) points.push_back(points[2 * i]);
      points.push_back({std::nan(""), 0, 0}), points.push_back({std::nan(""), 0, 0});
      const auto found = concino::detail::find_clusters(points, tolerance * scale);
      CHECK(found.first == clusters_by_pairs(points, tolerance * scale));
      std::vector<vec3> permuted = points;
      permuted.resize(440);
      const auto means = sorted_means(concino::detail::find_clusters(permuted, tolerance * scale));
      std::shuffle(permuted.begin(), permuted.end(), random);
      CHECK(sorted_means(concino::detail::find_clusters(permuted, tolerance * scale)) == means);
    }
}

TEST_CASE("repair: verts at the tolerance are merged, just above it they are not, and chains are") {
  const auto merged = [](double tolerance) {
    trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0.5}, {1, 0, 1}, {1, 1, 0}}, {{0, 1, 2}, {4, 5, 2}, {3, 5, 2}});
    repair(m, {.merge_within = tolerance, .remove_duplicates = false});
    return m;
  };
  CHECK(num_verts(merged(0.49)) == 6);
  const trimesh m = merged(0.5);
  CHECK(num_verts(m) == 4);
  CHECK(num_polys(m) == 3);
  CHECK(point(m, vert_id{1}) == vec3{1, 0, 0.5});
}

TEST_CASE("repair: polygons lose equal corners, and those that no triangle or quad can be are errors") {
  const std::vector<vec3> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0.9999, 0}, {3, 0, 0}, {3, 1, 0}, {0.9999, 1, 0}, {1, 1e-5, 0}};
  const std::vector<std::vector<unsigned>> quads{{0, 1, 2, 3}, {1, 5, 6, 2}, {2, 4, 7, 3}, {1, 8, 5, 6}};
  polygonmesh m(points, quads);
  const auto fix = repair(m, {.merge_within = 1e-3});
  CHECK(num_verts(m) == 6);
  CHECK(num_polys(m) == 3);  // one has become a segment, one a triangle
  CHECK(fix.count(repair_kind::removed_degenerate) == 1);
  CHECK(fix.count(repair_kind::collapsed_corners) == 1);
  CHECK(check_laws(m).empty());
  quadmesh q(points, quads);
  const auto before = record_of(q);
  CHECK_THROWS_AS(repair(q, {.merge_within = 1e-3}), unsupported);
  CHECK(record_of(q) == before);
  // a polygon that passes a vert twice becomes two
  polygonmesh eight({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1e-4, 0, 0}, {-1, -1, 0}, {-1, 0, 0}}, {{0, 1, 2, 3, 4, 5}});
  repair(eight, {.merge_within = 1e-3});
  CHECK(num_polys(eight) == 2);
}

TEST_CASE_TEMPLATE("repair: properties of all elements stay with them", M, CONCINO_ALL_KINDS) {
  M m = grid<M>(2);
  const M whole = m;
  const auto of_vert = vert_property<double>(m, "x");
  const auto of_edge = edge_property<int>(m, "edge");
  const auto of_poly = poly_property<std::string>(m, "name");
  for (const auto v : verts(m)) of_vert[v] = to_vec3(point(m, v)).x;
  const auto sum_of = [&](const M& mesh, const auto& list) {
    vec3 sum;
    for (const auto v : list) sum += to_vec3(point(mesh, v));
    return static_cast<int>(std::lround(1000 * (sum.x + 17 * sum.y + 131 * sum.z)));
  };
  for (const auto e : edges(m)) of_edge[e] = sum_of(m, adj_e2v(m, e));
  for (const auto p : polys(m)) of_poly[p] = std::to_string(sum_of(m, adj_p2v(m, p)));
  // an unused vert, which is removed, and one beside a used one, which is merged
  const auto apart = add_vert(m, {7, 7, 7}), close = add_vert(m, to_vec3(point(m, vert_id{1})) + vec3{1e-9, 0, 0});
  of_vert[apart] = 100, of_vert[close] = of_vert[vert_id{1}];
  const auto fix = repair(m, {.merge_within = 1e-8});
  CHECK(fix.count(repair_kind::removed_verts) == 1);
  CHECK(fix.count(repair_kind::merged_verts) == 2);
  CHECK(num_verts(m) == num_verts(whole));
  CHECK(fix.from.verts[1].size() == 2);
  const auto x = find_vert_property<double>(m, "x");
  const auto edge = find_edge_property<int>(m, "edge");
  const auto name = find_poly_property<std::string>(m, "name");
  for (const auto v : verts(m)) CHECK(x[v] == doctest::Approx(to_vec3(point(m, v)).x));
  for (const auto e : edges(m)) CHECK(edge[e] == sum_of(m, adj_e2v(m, e)));
  for (const auto p : polys(m)) CHECK(name[p] == std::to_string(sum_of(m, adj_p2v(m, p))));
}
