// Bodies of laplacian_editing.hpp: Laplacian editing: the system of the unknown displacements.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/deform/detail/editing/laplacian_editing.hpp>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace concino::detail {

inline Eigen::Vector3d column_of(const vec3& a) { return {a.x, a.y, a.z}; }
/// The matrix of the product with a: a x b.
inline Eigen::Matrix3d cross_matrix(const vec3& a) {
  Eigen::Matrix3d m;
  m << 0, -a.z, a.y, a.z, 0, -a.x, -a.y, a.x, 0;
  return m;
}

/// The inverse of a symmetric matrix that has no negative eigenvalues; along vectors that it maps to 0, 0.
CONCINO_INLINE Eigen::Matrix3d pseudo_inverse(const Eigen::Matrix3d& a) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(a);
  Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const double value = solver.eigenvalues()[i];
    const Eigen::Vector3d axis = solver.eigenvectors().col(i);
    if (value > 1e-10 * solver.eigenvalues()[2]) inverse += axis * axis.transpose() / value;
  }
  return inverse;
}

/// Whether points are on a line, but for rounding.
CONCINO_INLINE bool are_on_a_line(const std::vector<vec3>& points) {
  vec3 longest;
  for (const vec3& x : points)
    if (norm(x - points.front()) > norm(longest)) longest = x - points.front();
  for (const vec3& x : points)
    if (norm(cross(longest, x - points.front())) > 1e-10 * dot(longest, longest)) return false;
  return true;
}

/// Errors: solver_error if a component with an unknown has no handles, or only such on a line.
CONCINO_INLINE void check_handles(const edge_components& components, const std::vector<vec3>& rest,
                                  const std::vector<std::uint32_t>& handles,
                                  const std::vector<std::uint32_t>& unknowns) {
  std::vector<std::vector<vec3>> of(components.number);
  for (const std::uint32_t v : handles) of[components.of[v]].push_back(rest[v]);
  std::vector<bool> is_checked(components.number, false);
  for (const std::uint32_t v : unknowns) {
    const std::uint32_t c = components.of[v];
    if (is_checked[c]) continue;
    is_checked[c] = true;
    if (of[c].empty())
      throw_not_determined("laplacian_deform", components, v, "has no handle, so that its place is not determined");
    if (are_on_a_line(of[c]))
      throw_not_determined("laplacian_deform", components, v,
                           "has handles on a line only, so that its rotation is not determined");
  }
}

CONCINO_INLINE Eigen::SparseMatrix<double, Eigen::RowMajor> laplacian_editing::change_of_vectors(
    const Eigen::SparseMatrix<double>& laplacian, const std::vector<double>& mass) const {
  std::vector<Eigen::Triplet<double>> entries;
  for (int v = 0; v < laplacian.outerSize(); ++v) {
    const auto for_each_edge = [&](const auto& f) {
      for (Eigen::SparseMatrix<double>::InnerIterator it(laplacian, v); it; ++it)
        if (it.row() != v && it.value() != 0)
          f(static_cast<int>(it.row()), it.value(),
            start_[static_cast<std::size_t>(it.row())] - start_[static_cast<std::size_t>(v)]);
    };
    vec3 vector;  // at the start
    double squares = 0;
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
    for_each_edge([&](int, double w, const vec3& e) {
      vector += w * e;
      squares += std::abs(w) * dot(e, e);
      inertia -= std::abs(w) * cross_matrix(e) * cross_matrix(e);
    });
    if (!(squares > 0)) continue;
    const double root = std::sqrt(mass[static_cast<std::size_t>(v)]);
    const Eigen::Vector3d along = column_of(vector) / squares;
    const Eigen::Matrix3d turn = cross_matrix(vector) * pseudo_inverse(inertia);
    for_each_edge([&](int to, double w, const vec3& e) {
      const Eigen::Matrix3d block = (w * Eigen::Matrix3d::Identity() - std::abs(w) * along * column_of(e).transpose() +
                                     std::abs(w) * turn * cross_matrix(e)) /
                                    root;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          entries.emplace_back(3 * v + i, 3 * to + j, block(i, j));
          entries.emplace_back(3 * v + i, 3 * v + j, -block(i, j));
        }
    });
  }
  const auto n = static_cast<Eigen::Index>(3 * start_.size());
  Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

CONCINO_INLINE laplacian_editing::laplacian_editing(const std::vector<vec3>& rest, const std::vector<std::size_t>& used,
                                                    const Eigen::SparseMatrix<double>& laplacian,
                                                    const std::vector<double>& mass,
                                                    const std::vector<std::uint32_t>& handles,
                                                    const std::vector<vec3>& positions) {
  unit_ = unit_of(rest, used);
  std::vector<vec3> unit_rest = rest, at(rest.size());
  for (vec3& x : unit_rest) x /= unit_;
  for (std::size_t i = 0; i < handles.size(); ++i) at[handles[i]] = positions[i] / unit_;
  constexpr int is_no_unknown = -1;
  std::vector<int> unknown(rest.size(), is_no_unknown);
  std::vector<bool> is_handle(rest.size(), false);
  for (const std::uint32_t v : handles) is_handle[v] = true;
  double weight = 0, largest_mass = 0;
  for (const std::size_t v : used) {
    const double diagonal = std::abs(laplacian.coeff(static_cast<int>(v), static_cast<int>(v)));
    if (!(diagonal > 0)) continue;
    if (!(mass[v] > 0)) core::throw_joined<invalid_mesh>({"laplacian_deform: vert ", v, " has no mass"});
    weight = std::max(weight, diagonal);
    largest_mass = std::max(largest_mass, mass[v]);
    if (is_handle[v]) continue;
    unknown[v] = static_cast<int>(vert_of_unknown_.size());
    vert_of_unknown_.push_back(static_cast<std::uint32_t>(v));
  }
  components_ = edge_components::find(rest.size(), laplacian.outerIndexPtr(), laplacian.innerIndexPtr());
  check_handles(components_, unit_rest, handles, vert_of_unknown_);
  start_ = components_.moved(unit_rest, handles, at);
  std::vector<double> unit_mass = mass;
  for (double& x : unit_mass) x /= power_of_two_above(largest_mass);
  const auto change = change_of_vectors(laplacian / power_of_two_above(weight), unit_mass);
  const Eigen::SparseMatrix<double> whole = change.transpose() * change;
  const auto n = static_cast<Eigen::Index>(3 * vert_of_unknown_.size());
  load_ = Eigen::VectorXd::Zero(n);
  std::vector<Eigen::Triplet<double>> entries;
  for (int c = 0; c < whole.outerSize(); ++c) {
    const auto vert = static_cast<std::size_t>(c / 3), d = static_cast<std::size_t>(c % 3);
    const double displacement = is_handle[vert] ? at[vert][d] - start_[vert][d] : 0;
    for (Eigen::SparseMatrix<double>::InnerIterator it(whole, c); it; ++it) {
      const int i = unknown[static_cast<std::size_t>(it.row() / 3)], row = 3 * i + static_cast<int>(it.row() % 3);
      if (i == is_no_unknown) continue;
      const int column = 3 * unknown[vert] + static_cast<int>(d);
      if (unknown[vert] == is_no_unknown) load_[row] -= it.value() * displacement;
      else if (column <= row) entries.emplace_back(row, column, it.value());
    }
  }
  lower_.resize(n, n);
  lower_.setFromTriplets(entries.begin(), entries.end());
}

CONCINO_INLINE void laplacian_editing::throw_singular(Eigen::Index row) const {
  throw_not_determined("laplacian_deform", components_, vert_of_unknown_[static_cast<std::size_t>(row / 3)],
                       "has too few handles to determine the points of this vert");
}

CONCINO_INLINE std::vector<vec3> laplacian_editing::points(const Eigen::VectorXd& u) const {
  std::vector<vec3> x = start_;
  for (std::size_t i = 0; i < vert_of_unknown_.size(); ++i)
    for (std::size_t d = 0; d < 3; ++d) x[vert_of_unknown_[i]][d] += u[static_cast<Eigen::Index>(3 * i + d)];
  for (vec3& p : x) p *= unit_;
  return x;
}

}  // namespace concino::detail
