// Compute the lowest tones of a room with hard walls: the frequencies of its air are the square roots of eigenvalues of the Laplacian times the speed of sound
// over 2 pi. LOBPCG with multigrid factorises nothing, so the same call serves a mesh of a million verts.
#include <concino/fields/eigenfunctions.hpp>
#include <concino/generate.hpp>
#include <concino/mesh.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace cn = concino;

int main() {
  const double speed = 343;  // of sound, in metres per second
  const cn::box room{{0, 0, 0}, {5, 4, 2.6}};
  const auto m = cn::voronoi_polyhedra(cn::random_points(1500, room), room);

  const std::size_t count = 8;
  const auto modes = cn::eigenfunctions(m, count, cn::lobpcg, {.tolerance = 1e-6});
  fmt::print("{} polyhedra, {}\n", cn::num_polys(m), modes.iterations < 30 ? "fewer than 30 iterations" : "many iterations");

  std::vector<double> known;  // of standing waves with i, j and k nodes
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 4; ++k) known.push_back(speed / 2 * std::hypot(i / 5.0, j / 4.0, k / 2.6));
  std::sort(known.begin(), known.end());
  for (std::size_t k = 1; k < count; ++k)  // the first one is a constant pressure
    fmt::print("{:3.0f} Hz, known {:3.0f} Hz\n", speed / (2 * std::numbers::pi) * std::sqrt(modes.values[k]), known[k]);

  // The lowest tone is loud at both ends of the room, and silent half-way.
  double most = 0, middle = 0;
  for (const auto v : cn::verts(m)) {
    const double pressure = std::abs(modes.functions[1][v]);
    most = std::max(most, pressure);
    if (std::abs(cn::point(m, v).x - 2.5) < 0.05) middle = std::max(middle, pressure);
  }
  fmt::print("pressure half-way: at most {:.0f} % of the largest\n", 10 * std::ceil(10 * middle / most));
}
