// Use two Eigen matrices as a mesh, as libigl stores it: V has a row of coordinates per vert, F a row of verts per triangle. The view stores adjacencies
// only. What is written into V changes the mesh, and Eigen reads the results without a copy.
#include <concino/adapters/eigen.hpp>
#include <concino/fields.hpp>
#include <concino/geometry.hpp>
#include <concino/graph.hpp>

#include <fmt/core.h>

#include <cmath>
#include <utility>
#include <vector>

namespace cn = concino;

int main() {
  // A square plate of 20 x 20 squares, two triangles each.
  const int n = 20;
  Eigen::MatrixXd V((n + 1) * (n + 1), 3);
  Eigen::MatrixXi F(2 * n * n, 3);
  const auto at = [&](int i, int j) { return j * (n + 1) + i; };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) V.row(at(i, j)) << double(i) / n, double(j) / n, 0;
  for (int j = 0, f = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      F.row(f++) << at(i, j), at(i + 1, j), at(i + 1, j + 1);
      F.row(f++) << at(i, j), at(i + 1, j + 1), at(i, j + 1);
    }

  auto plate = cn::view_tri(V, F);
  static_assert(cn::TriMesh<decltype(plate)> && cn::MutablePoints<decltype(plate)>);
  const cn::vert_id left{at(0, n / 2)}, right{at(n, n / 2)};
  fmt::print("{} verts, {} edges, {} triangles\n", cn::num_verts(plate), cn::num_edges(plate), cn::num_polys(plate));
  fmt::print("flat: area {:.4f}, from left to right {:.4f}\n", cn::total_measure(plate), cn::dijkstra(plate, left)[right]);

  // Eigen raises a hill: the view reads the same numbers. And set_point writes into V.
  V.col(2) = ((V.leftCols(2).rowwise() - Eigen::RowVector2d(0.5, 0.5)).rowwise().squaredNorm() * -20).array().exp() / 2;
  fmt::print("with a hill: area {:.4f}, from left to right {:.4f}\n", cn::total_measure(plate), cn::dijkstra(plate, left)[right]);
  cn::set_point(plate, left, cn::vec3{-1, 0.5, 0});
  fmt::print("V.row({}) is now {} {} {}\n", left.raw(), V(left.raw(), 0), V(left.raw(), 1), V(left.raw(), 2));

  // Heat flows from the left edge to the right one. The result has one value per row of V, and Eigen reads it in place.
  std::vector<std::pair<cn::vert_id, double>> held;
  for (int j = 0; j <= n; ++j) held.insert(held.end(), {{cn::vert_id{at(0, j)}, 1.0}, {cn::vert_id{at(n, j)}, 0.0}});
  const auto heat = cn::harmonic_map(plate, held);
  const Eigen::Map<const Eigen::VectorXd> u(heat.values().data(), V.rows());
  fmt::print("heat on the hill {:.4f}, mean {:.4f}\n", u(at(n / 2, n / 2)), u.mean());

  // Indices are checked when the view is constructed.
  F(7, 1) = 441;
  try {
    cn::view_tri(V, F);
  } catch (const cn::invalid_mesh& e) {
    fmt::print("{}\n", e.what());
  }
}
