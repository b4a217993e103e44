// Defines disk_embedding.hpp, but for the pieces.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/number_text.hpp>
#include <concino/parametrize/detail/disk_embedding.hpp>
#include <concino/parametrize/detail/poly_triangles.hpp>
#include <concino/solve/ldlt.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace concino::detail {

CONCINO_INLINE std::vector<uv_point> circle_of_loop(const flat_disk& f, const char* caller) {
  const std::size_t n = f.loop.size(), start = farthest_in_loop(f);
  std::vector<double> length(n);
  double total = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t a = f.loop[(start + i) % n], b = f.loop[(start + i + 1) % n];
    length[i] = distance(f.points[a], f.points[b]);
    if (!(length[i] > 0))
      core::throw_joined<invalid_mesh>({caller, ": the boundary edge of verts ", f.vert_index[a], " and ",
                                        f.vert_index[b], " has no length; merge them with repair(m, {.merge_within = "
                                        "0}), or give positions of the boundary"});
    total += length[i];
  }
  std::vector<uv_point> at(n);
  double walked = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * walked / total;
    at[(start + i) % n] = {std::cos(angle), std::sin(angle)};
    walked += length[i];
  }
  return at;
}

CONCINO_INLINE void set_edge_weight(const flat_disk& f, const std::array<std::uint32_t, 2>& ends, double weight,
                                    std::vector<double>& by_edge) {
  const std::array<std::uint32_t, 2> key{std::min(ends[0], ends[1]), std::max(ends[0], ends[1])};
  const auto it = std::lower_bound(f.edges.begin(), f.edges.end(), key);
  if (it == f.edges.end() || *it != key) return;
  if (!(weight > 0) || !std::isfinite(weight))
    core::throw_joined<invalid_argument>({"tutte: the weight of the edge of verts ", f.vert_index[key[0]], " and ",
                                          f.vert_index[key[1]], " is ", core::number_text(weight),
                                          "; it must be positive and finite"});
  by_edge[static_cast<std::size_t>(it - f.edges.begin())] = weight;
}

/// The given positions in the order of the loop.
inline std::vector<uv_point> convex_loop(const flat_disk& f,
                                         const std::vector<std::pair<std::uint32_t, uv_point>>& boundary) {
  constexpr auto none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> place(f.points.size(), none);
  for (std::size_t i = 0; i < f.loop.size(); ++i) place[f.loop[i]] = i;
  std::vector<uv_point> at(f.loop.size());
  std::vector<unsigned char> is_known(f.loop.size());
  for (const auto& [v, x] : boundary) {
    if (place[v] == none)
      core::throw_joined<invalid_argument>(
          {"tutte: a position is given at vert ", f.vert_index[v], ", which is not on the boundary"});
    at[place[v]] = x;
    is_known[place[v]] = 1;
  }
  const std::size_t n = at.size();
  double turn = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_known[i])
      core::throw_joined<invalid_argument>({"tutte: boundary vert ", f.vert_index[f.loop[i]],
                                            " has no position; give all of them or none"});
    const uv_point &a = at[i], &b = at[(i + 1) % n], &c = at[(i + 2) % n];
    const double x = b[0] - a[0], y = b[1] - a[1], z = c[0] - b[0], w = c[1] - b[1];
    const double angle = std::atan2(x * w - y * z, x * z + y * w);
    constexpr double rounding = 1e-9;  // of points on a straight line
    if (!(angle >= -rounding) || (x == 0 && y == 0))
      core::throw_joined<invalid_argument>(
          {"tutte: the positions of the boundary are in no convex position, counter-clockwise, at vert ",
           f.vert_index[f.loop[(i + 1) % n]]});
    turn += angle;
  }
  if (!(std::abs(turn - 2 * std::numbers::pi) < 1e-3))
    throw invalid_argument("tutte: the positions of the boundary go round more than once");
  return at;
}

CONCINO_INLINE disk_embedding embed_disk(const flat_disk& f,
                                         const std::vector<std::pair<std::uint32_t, uv_point>>& boundary,
                                         const std::vector<double>& weights) {
  const std::vector<uv_point> on_loop = boundary.empty() ? circle_of_loop(f, "tutte") : convex_loop(f, boundary);
  disk_embedding result{std::vector<uv_point>(f.points.size()), attached_pieces(f)};
  std::vector<int> unknown(f.points.size(), 0);
  for (std::size_t i = 0; i < f.loop.size(); ++i) {
    unknown[f.loop[i]] = -1;
    result.uv[f.loop[i]] = on_loop[i];
  }
  int n = 0;
  for (int& u : unknown)
    if (u == 0) u = n++;
  if (n == 0) return result;
  double largest = 1;
  if (!weights.empty()) largest = *std::max_element(weights.begin(), weights.end());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, 2);
  for (std::size_t e = 0; e < f.edges.size(); ++e) {
    const double w = weights.empty() ? 1 : weights[e] / largest;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::uint32_t v = f.edges[e][k], other = f.edges[e][1 - k];
      if (unknown[v] < 0) continue;
      entries.emplace_back(unknown[v], unknown[v], w);
      if (unknown[other] >= 0) {
        entries.emplace_back(unknown[v], unknown[other], -w);
      } else {
        right(unknown[v], 0) += w * result.uv[other][0];
        right(unknown[v], 1) += w * result.uv[other][1];
      }
    }
  }
  Eigen::SparseMatrix<double> system(n, n);
  system.setFromTriplets(entries.begin(), entries.end());
  ldlt solver;
  solver.factorize(system);
  for (Eigen::Index k = 0; k < 2; ++k) {
    const Eigen::VectorXd x = solver.solve(right.col(k));
    for (std::size_t v = 0; v < unknown.size(); ++v)
      if (unknown[v] >= 0) result.uv[v][static_cast<std::size_t>(k)] = x[unknown[v]];
  }
  return result;
}

}  // namespace concino::detail
