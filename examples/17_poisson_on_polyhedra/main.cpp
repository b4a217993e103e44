// Solve Poisson's equation on meshes of polyhedra: heat sources in a block whose surface is kept at 0. The exact solution is known. With eight times as many
// cells the error falls to about a fourth on cubes, and to about a third on cells of other shapes.
#include <concino/fields.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cn = concino;

constexpr double pi = 3.14159265358979323846;

double exact(const cn::vec3& x) { return std::sin(pi * x.x) * std::sin(pi * x.y) * std::sin(pi * x.z); }

template<class M>
void solve(const char* name, const M& m) {
  auto f = cn::make_vert_map<double>(m);  // minus the Laplacian of `exact`
  std::vector<std::pair<cn::vert_id, double>> cold;
  for (const cn::vert_id v : cn::verts(m)) {
    const cn::vec3 x = cn::to_vec3(cn::point(m, v));
    f[v] = 3 * pi * pi * exact(x);
    if (std::min({x.x, x.y, x.z, 1 - x.x, 1 - x.y, 1 - x.z}) < 1e-9) cold.push_back({v, 0.0});
  }
  const auto u = cn::poisson(m, f, {.values = cold});

  const auto mass = cn::vert_masses(m);
  double squares = 0;
  for (const cn::vert_id v : cn::verts(m)) squares += mass[v] * std::pow(u[v] - exact(cn::to_vec3(cn::point(m, v))), 2);
  fmt::print("{:<24} {:>5} cells, {:>5} verts: error {:.4f}\n", name, cn::num_polys(m), cn::num_verts(m), std::sqrt(squares));
}

int main() {
  cn::box unit;
  unit.add({0, 0, 0});
  unit.add({1, 1, 1});
  for (const unsigned n : {4u, 8u}) {
    const auto cubes = cn::make_grid<cn::hexmesh>({.cells = {n, n, n}});
    solve("cubes", cubes);
    solve("Voronoi cells", cn::voronoi_polyhedra(cn::random_points(n * n * n, unit), unit, {.relax = 3}));
    solve("clusters, none convex", cn::agglomerate(cubes, cn::random_labels(cubes, 3)));
  }
}
