// Bodies of frame_problem.hpp: smooth frames by alternating diffusion and projection.
#pragma once

#include <concino/directions/detail/frames/frame_problem.hpp>

#include <concino/core/progress.hpp>
#include <concino/geometry/edge_length.hpp>
#include <concino/graph/disjoint_sets.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/operators/mass_matrix.hpp>
#include <concino/solve/ldlt.hpp>
#include <concino/solve/solve_columns.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace concino::detail {

CONCINO_INLINE void check_frame_options(double sharp_angle, int max_rounds, double tolerance) {
  if (!(sharp_angle >= 0 && sharp_angle <= 180))
    throw invalid_argument("frame_field: sharp_angle must be from 0 to 180 degrees");
  if (max_rounds < 1) throw invalid_argument("frame_field: max_rounds must be 1 or more");
  if (!(tolerance >= 0 && tolerance <= 1)) throw invalid_argument("frame_field: tolerance must be from 0 to 1");
}

/// Corners of polygons at one vert are in one set if the boundary is smooth between them.
CONCINO_INLINE disjoint_sets smooth_parts(const boundary_polygons& b, double sharp_angle) {
  struct polygon_edge {
    std::array<std::uint32_t, 2> ends;  // the lower first
    std::array<std::size_t, 2> corners;
    std::size_t polygon;
  };
  std::vector<polygon_edge> all;
  for (std::size_t i = 0; i + 1 < b.first.size(); ++i)
    for (std::size_t c = b.first[i]; c < b.first[i + 1]; ++c) {
      const std::size_t next = c + 1 < b.first[i + 1] ? c + 1 : b.first[i];
      if (b.verts[c] < b.verts[next]) all.push_back({{b.verts[c], b.verts[next]}, {c, next}, i});
      else all.push_back({{b.verts[next], b.verts[c]}, {next, c}, i});
    }
  std::sort(all.begin(), all.end(), [](const polygon_edge& x, const polygon_edge& y) {
    return x.ends != y.ends ? x.ends < y.ends : x.corners < y.corners;
  });
  disjoint_sets parts(b.verts.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size() && all[i].ends == all[j].ends; ++j) {
      const vec3 &n = b.areas[all[i].polygon], &o = b.areas[all[j].polygon];
      if (std::atan2(norm(cross(n, o)), dot(n, o)) > sharp_angle * (std::numbers::pi / 180)) continue;
      for (const std::size_t k : {0u, 1u}) parts.unite(all[i].corners[k], all[j].corners[k]);
    }
  return parts;
}

CONCINO_INLINE std::vector<std::vector<vec3>> normals_of_parts(const boundary_polygons& b, std::size_t num_verts,
                                                               double sharp_angle) {
  disjoint_sets parts = smooth_parts(b, sharp_angle);
  std::vector<vec3> sum(b.verts.size());
  for (std::size_t i = 0; i + 1 < b.first.size(); ++i)
    for (std::size_t c = b.first[i]; c < b.first[i + 1]; ++c) sum[parts.root(c)] += b.areas[i];
  std::vector<std::vector<vec3>> normals(num_verts);
  for (std::size_t c = 0; c < b.verts.size(); ++c)
    if (const double length = norm(sum[c]); parts.root(c) == c && length > 0)
      normals[b.verts[c]].push_back(sum[c] / length);
  return normals;
}

/// What is known of the frames at each vert, and the step from any functions to the frames nearest to them.
class frame_constraints {
  std::vector<std::vector<vec3>> normals_;
  closest_frame closest_;
  std::vector<orthonormal_frame> fixed_;  // where the boundary is not smooth

 public:
  explicit frame_constraints(std::vector<std::vector<vec3>> normals) : normals_(std::move(normals)) {
    fixed_.resize(normals_.size(), some_frame({0, 0, 1}));
    for (std::size_t v = 0; v < normals_.size(); ++v) {
      if (normals_[v].size() < 2) continue;
      quartic sum{};
      for (const vec3& n : normals_[v]) add(sum, harmonics_at(n));
      fixed_[v] = closest_(sum, fixed_[v]);
    }
  }
  std::size_t size() const { return normals_.size(); }

  /// The part of the function that is the same for all frames that are allowed at v.
  quartic known_part(std::size_t v) const {
    if (normals_[v].empty()) return {};
    return normals_[v].size() == 1 ? harmonics_around(normals_[v][0]) : harmonics_of(fixed_[v]);
  }
  orthonormal_frame nearest(std::size_t v, const quartic& q, const orthonormal_frame& near) const {
    if (normals_[v].empty()) return closest_(q, near);
    return normals_[v].size() == 1 ? closest_aligned_frame(q, normals_[v][0]) : fixed_[v];
  }
};

/// The matrix M - t L, where t is the square of a length. Verts without mass get a 1.
CONCINO_INLINE Eigen::SparseMatrix<double> diffusion_matrix(const Eigen::SparseMatrix<double>& laplacian,
                                                            const std::vector<double>& mass, double t) {
  Eigen::SparseMatrix<double> a = -t * laplacian;
  for (std::size_t v = 0; v < mass.size(); ++v) {
    const int i = static_cast<int>(v);
    a.coeffRef(i, i) += mass[v] > 0 ? mass[v] : 1;
  }
  a.makeCompressed();
  return a;
}

/// One round: the functions are diffused, then replaced by those of the nearest frames.
/// Result: the root of the mean squared change.
CONCINO_INLINE double diffuse_and_project(const frame_constraints& known, const ldlt& solver,
                                          const std::vector<double>& mass, Eigen::MatrixXd& functions,
                                          std::vector<orthonormal_frame>& frames) {
  Eigen::MatrixXd b = functions;
  double total = 0, change = 0;
  for (std::size_t v = 0; v < mass.size(); ++v) b.row(static_cast<int>(v)) *= mass[v], total += mass[v];
  const Eigen::MatrixXd diffused = solve_columns(solver, b);
  for (std::size_t v = 0; v < mass.size(); ++v) {
    const int row = static_cast<int>(v);
    quartic q;
    for (std::size_t i = 0; i < 9; ++i) q[i] = diffused(row, static_cast<int>(i));
    frames[v] = known.nearest(v, q, frames[v]);
    q = harmonics_of(frames[v]);
    for (std::size_t i = 0; i < 9; ++i) {
      double& old = functions(row, static_cast<int>(i));
      change += mass[v] * (q[i] - old) * (q[i] - old);
      old = q[i];
    }
  }
  return std::sqrt(change / total);
}

/// The integral of the squared gradient, as a sum of squared differences: exactly 0 for constant functions.
CONCINO_INLINE double frame_energy(const Eigen::SparseMatrix<double>& laplacian, const Eigen::MatrixXd& functions) {
  double energy = 0;
  for (int j = 0; j < laplacian.outerSize(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator at(laplacian, j); at; ++at) {
      if (at.row() >= j) continue;
      double squares = 0;
      for (int i = 0; i < 9; ++i) {
        const double d = functions(at.row(), i) - functions(j, i);
        squares += d * d;
      }
      energy += at.value() * squares;
    }
  return energy;
}

CONCINO_INLINE smooth_frames solve_frames(const tetmesh& m, std::vector<std::vector<vec3>> normals,
                                          const frame_problem_options& options) {
  const frame_constraints known(std::move(normals));
  const Eigen::SparseMatrix<double> l = laplacian(m);
  const auto masses = vert_masses(m);
  const std::vector<double> mass(masses.data(), masses.data() + known.size());
  double edge = 0;
  for (const edge_id e : edges(m)) edge += edge_length(m, e) / static_cast<double>(num_edges(m));

  smooth_frames result;
  result.frames.resize(known.size(), some_frame({0, 0, 1}));
  Eigen::MatrixXd functions(static_cast<int>(known.size()), 9);
  for (std::size_t v = 0; v < known.size(); ++v) {
    const quartic q = known.known_part(v);
    for (std::size_t i = 0; i < 9; ++i) functions(static_cast<int>(v), static_cast<int>(i)) = q[i];
  }
  ldlt solver;
  const double volume = std::accumulate(mass.begin(), mass.end(), 0.0);
  for (double length = std::cbrt(volume) / 2; !result.has_converged; length /= 2) {
    const bool is_last = length < 2 * edge;
    solver.factorize(diffusion_matrix(l, mass, length * length));
    double change = 1;
    while (result.rounds < options.max_rounds && change > (is_last ? options.tolerance : 0.01)) {
      change = diffuse_and_project(known, solver, mass, functions, result.frames);
      ++result.rounds;
      report_progress(options.progress, static_cast<double>(result.rounds) / options.max_rounds, "frame_field");
    }
    if (is_last || result.rounds >= options.max_rounds) {
      result.has_converged = is_last && change <= options.tolerance;
      break;
    }
  }
  result.energy = frame_energy(l, functions);
  return result;
}

}  // namespace concino::detail
