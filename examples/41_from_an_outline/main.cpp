// From an outline to a finite-element solution: a plate with two holes becomes triangles, and Poisson's equation gives its temperatures. The segments of the
// outline are edges of the mesh, so boundary values are given by segment.
#include <concino/adapters/cgal_triangulate.hpp>
#include <concino/fields.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/quality.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace cn = concino;

std::vector<cn::vec3> circle(const cn::vec3& centre, double radius, int n) {
  std::vector<cn::vec3> points;
  for (int i = 0; i < n; ++i) points.push_back(centre + radius * cn::vec3{std::cos(6.283185307179586 * i / n), std::sin(6.283185307179586 * i / n), 0});
  return points;
}

void describe(const char* name, const cn::planar_triangulation& t) {
  double least = 180;
  for (const auto p : cn::polys(t.mesh)) least = std::min(least, cn::quality(t.mesh, p, cn::metric::minimum_angle));
  fmt::print("{:<22} {:>5} triangles of area {:.4f}, smallest angle {:4.1f} degrees\n", name, cn::num_polys(t.mesh), cn::total_measure(t.mesh), least);
}

/// The temperatures: 100 at the first hole, 0 at the outline; no heat flows through the boundary of the second hole.
auto temperatures(const cn::planar_graph& g, const cn::planar_triangulation& t) {
  std::vector<std::pair<cn::vert_id, double>> fixed;
  for (std::size_t s = 0; s < g.line(0).size() + g.line(1).size(); ++s)
    for (const auto e : t.edges_of(s))
      for (const auto v : cn::adj_e2v(t.mesh, e)) fixed.push_back({v, s < g.line(0).size() ? 0.0 : 100.0});
  return cn::poisson(t.mesh, cn::make_vert_map<double>(t.mesh), {.values = fixed});
}

int main() {
  cn::planar_graph g({{0, 0, 0}, {4, 0, 0}, {4, 1.3, 0}, {3.3, 2, 0}, {0, 2, 0}});
  g.add_outline(circle({1, 1, 0}, 0.5, 40));
  g.add_outline(circle({2.8, 0.9, 0}, 0.4, 32));
  describe("without new points", cn::triangulate(g));
  describe("Delaunay", cn::triangulate(g, cn::cgal));
  cn::planar_triangulation t;
  for (const double area : {0.1, 0.01, 0.001}) {
    t = cn::triangulate(g, cn::cgal, {.min_angle_deg = 28, .max_area = area});
    describe("refined", t);
    const auto leftmost = t.vert_of[g.line(2)[16]];  // the vert of a point of the second hole
    fmt::print("  {:.2f} degrees at the left end of the second hole\n", temperatures(g, t)[leftmost]);
  }

  // The temperatures, by the triangle at each character.
  const auto u = temperatures(g, t);
  const auto tree = cn::bounding_tree(t.mesh);
  for (double y = 1.95; y > 0; y -= 0.1) {
    std::string row;
    for (double x = 0.025; x < 4; x += 0.05) {
      const auto p = tree.locate({x, y, 0});
      double mean = 0;
      if (p)
        for (const auto v : cn::adj_p2v(t.mesh, *p)) mean += u[v] / 3;
      row += p ? ".:-=+*#%@@"[static_cast<int>(mean / 10)] : ' ';
    }
    fmt::print("{}\n", row.substr(0, row.find_last_not_of(' ') + 1));
  }
}
