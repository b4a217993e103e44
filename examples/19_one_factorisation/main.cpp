// Factorise once, query many times: geodesic distances on a sphere, from verts and from a point inside a triangle. Preparation costs two factorisations, a
// query two back-substitutions. The same lines work in a solid. On triangles, the exact shortest path can be computed too.
#include <concino/fields.hpp>
#include <concino/generate.hpp>
#include <concino/mesh.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cn = concino;

double arc(const cn::vec3& a, const cn::vec3& b) { return std::atan2(cn::norm(cn::cross(a, b)), cn::dot(a, b)); }

int main() {
  const auto m = cn::icosphere(3);  // of radius 1
  const auto heat = cn::prepare_heat_geodesics(m);

  // Distances between all pairs of verts: the mean on a sphere is a quarter of a great circle.
  double sum = 0, pairs = 0, wrong = 0;
  std::size_t queries = 0;
  for (const auto v : cn::verts(m)) {
    const auto d = heat.distance_from(v);
    ++queries;
    for (const auto w : cn::verts(m)) {
      sum += d[w];
      pairs += 1;
      wrong = std::max(wrong, std::abs(d[w] - arc(cn::point(m, v), cn::point(m, w))));
    }
  }
  fmt::print("{} queries, {} distances, mean {:.2f} (pi / 2), largest error below {:.1f} edges: {}\n", queries, pairs, sum / pairs, 0.3,
             wrong < 0.3 * 0.14 ? "yes" : "no");

  // Distances from several sources, from a source with an initial distance, and from a point inside a triangle.
  const cn::vert_id north{0}, other{7};
  const auto nearest = heat.distance_from({north, other});
  const auto later = heat.distance_from({{north, 0.0}, {other, 0.5}});
  fmt::print("two sources: {:.2f} {:.2f}, one of them with initial distance 0.5: {:.1f} {:.1f}\n", nearest[north], nearest[other], later[north], later[other]);
  const cn::poly_id p{100};
  const auto inside = heat.distance_from(p, cn::centroid(m, p));
  double far = 0;
  for (const auto v : cn::verts(m)) far = std::max(far, inside[v]);
  fmt::print("from the centroid of a triangle, the farthest vert is {:.1f} away\n", far);

  // Distances in a solid ball of hexahedra, for one query.
  const auto ball = cn::make_sphere<cn::hexmesh>({.cells = 6});
  cn::vert_id centre{0};
  for (const auto v : cn::verts(ball))
    if (cn::norm(cn::point(ball, v)) < cn::norm(cn::point(ball, centre))) centre = v;
  const auto d = cn::heat_geodesics(ball, centre);
  double radius = 0;
  for (const auto v : cn::verts(ball)) radius = std::max(radius, d[v]);
  fmt::print("a ball of {} hexahedra has the radius {:.1f}\n", cn::num_polys(ball), radius);

  // The exact shortest path on triangles: straight inside each triangle, from edge to edge. Its length is exact.
  const auto path = cn::prepare_exact_geodesics(m).path_between(north, other);
  const double straight = cn::norm(cn::point(m, other) - cn::point(m, north)), round = arc(cn::point(m, north), cn::point(m, other));
  fmt::print("a path of {} points, longer than the chord and shorter than the arc: {}\n", path.points.size(),
             straight < path.length && path.length < round ? "yes" : "no");
}
