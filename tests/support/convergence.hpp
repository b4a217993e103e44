// Errors of the operators on mesh families of the unit square and the unit cube under refinement. docs/convergence.md shows them, and tests compare
// them with new results.
#pragma once

#include <concino/fields/poisson.hpp>
#include <concino/operators.hpp>
#include <concino/operators/de_goes.hpp>
#include <concino/operators/virtual_refinement.hpp>

#include <support/convergence_families.hpp>
#include <support/convergence_table.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace concino::testing {

/// Multiplies a symmetric matrix, of which only the lower triangle is read, by x.
inline void multiply(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& x, Eigen::VectorXd& y) {
  const int n = static_cast<int>(a.cols()), *const begin = a.outerIndexPtr(), *const row = a.innerIndexPtr();
  const double *const value = a.valuePtr(), *const from = x.data();
  y.setZero(n);
  double* const to = y.data();
  for (int c = 0; c < n; ++c) {
    double sum = 0;
    for (int k = begin[c]; k < begin[c + 1]; ++k) {
      const int r = row[k];
      if (r < c) continue;
      sum += value[k] * from[r];
      if (r > c) to[r] += value[k] * from[c];
    }
    to[c] += sum;
  }
}

/// A smooth function without symmetries and, since it is an eigenfunction, its Laplacian: -lap u = load u.
template<int D>
struct smooth_problem {
  static constexpr double load = D == 2 ? 3 : 4;
  static double value(const vec3& x) { return std::exp(x.x) * std::cos(2 * x.y) * (D == 2 ? 1 : std::sin(x.z + 1)); }
  static vec3 gradient(const vec3& x) {
    const double e = std::exp(x.x), c = std::cos(2 * x.y), s = D == 2 ? 1 : std::sin(x.z + 1);
    return {e * c * s, -2 * e * std::sin(2 * x.y) * s, D == 2 ? 0 : e * c * std::cos(x.z + 1)};
  }
};

/// The values of f(point) at the verts.
template<class M, class F>
vert_map<M, double> at_verts(const M& m, const F& f) {
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = f(to_vec3(point(m, v)));
  return u;
}

/// The L2 norm of the error of the gradient per poly of u, which approximates the smooth function, integrated by the mean over the verts.
template<class M>
double gradient_error(const M& m, const vert_map<M, double>& u) {
  using problem = smooth_problem<dimension_v<M>>;
  const auto g = gradient(m, u);
  double sum = 0;
  for (const auto p : polys(m)) {
    double squares = 0, n = 0;
    for (const auto v : adj_p2v(m, p)) {
      const vec3 d = g[p] - problem::gradient(to_vec3(point(m, v)));
      squares += dot(d, d);
      n += 1;
    }
    sum += measure(m, p) * squares / n;
  }
  return std::sqrt(sum);
}

/// The same of the function itself.
template<class M>
double gradient_error(const M& m) { return gradient_error(m, at_verts(m, smooth_problem<dimension_v<M>>::value)); }

/// The solution of the Poisson problem of the smooth function, which is prescribed on the boundary.
template<class M, class Which, class Solver>
vert_map<M, double> solve_poisson(const M& m, const Which& which, Solver&& solver) {
  using problem = smooth_problem<dimension_v<M>>;
  const auto f = at_verts(m, [](const vec3& x) { return problem::load * problem::value(x); });
  const auto on_boundary = boundary_verts(m);
  std::vector<std::pair<vert_t<M>, double>> given;
  for (const auto v : verts(m))
    if (on_boundary[v]) given.emplace_back(v, problem::value(to_vec3(point(m, v))));
  return poisson(m, f, which, {.values = given}, solver);
}

/// The L2 norm, by the lumped mass, of the difference of u and the smooth function.
template<class M>
double value_error(const M& m, const vert_map<M, double>& u) {
  const auto exact = at_verts(m, smooth_problem<dimension_v<M>>::value);
  const auto mass = vert_masses(m);
  double sum = 0;
  for (const auto v : verts(m)) sum += mass[v] * (u[v] - exact[v]) * (u[v] - exact[v]);
  return std::sqrt(sum);
}

template<class M, class Which, class Solver>
double poisson_error(const M& m, const Which& which, Solver&& solver) { return value_error(m, solve_poisson(m, which, solver)); }

/// The eigenvalues, in ascending order, and eigenvectors of the small problem A x = value B x, by Cholesky and Jacobi's rotations. (Eigen's solver
/// would take longer to compile than all the rest.)
struct small_eigenproblem {
  using matrix = std::vector<std::vector<double>>;
  std::vector<double> values;
  matrix vectors;  // vectors[k] belongs to values[k]

  small_eigenproblem(matrix a, matrix b) {
    const std::size_t n = a.size();
    for (std::size_t j = 0; j < n; ++j) {  // b = L L^T, and a becomes L^-1 a L^-T
      for (std::size_t k = 0; k < j; ++k)
        for (std::size_t i = j; i < n; ++i) b[i][j] -= b[i][k] * b[j][k];
      const double root = std::sqrt(b[j][j]);
      for (std::size_t i = j; i < n; ++i) b[i][j] /= root;
    }
    for (int side = 0; side < 2; ++side)
      for (std::size_t c = 0; c < n; ++c)
        for (std::size_t i = 0; i < n; ++i) {
          double& x = side == 0 ? a[i][c] : a[c][i];
          for (std::size_t k = 0; k < i; ++k) x -= b[i][k] * (side == 0 ? a[k][c] : a[c][k]);
          x /= b[i][i];
        }
    matrix turn(n, std::vector<double>(n));
    for (std::size_t i = 0; i < n; ++i) turn[i][i] = 1;
    for (int sweep = 0; sweep < 20; ++sweep)
      for (std::size_t p = 0; p < n; ++p)
        for (std::size_t q = p + 1; q < n; ++q) {
          const double angle = 0.5 * std::atan2(2 * a[p][q], a[q][q] - a[p][p]), c = std::cos(angle), s = std::sin(angle);
          const auto rotate = [&](double& x, double& y) {
            const double old = x;
            x = c * old - s * y;
            y = s * old + c * y;
          };
          for (std::size_t k = 0; k < n; ++k) rotate(a[k][p], a[k][q]);
          for (std::size_t k = 0; k < n; ++k) rotate(a[p][k], a[q][k]);
          for (std::size_t k = 0; k < n; ++k) rotate(turn[k][p], turn[k][q]);
        }
    std::vector<std::size_t> order(n);
    for (std::size_t k = 0; k < n; ++k) order[k] = k;
    std::sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) { return a[x][x] < a[y][y]; });
    for (const std::size_t k : order) {
      values.push_back(a[k][k]);
      std::vector<double> v(n);
      for (std::size_t i = n; i-- > 0;) {  // L^T v = turned
        v[i] = turn[i][k];
        for (std::size_t j = i + 1; j < n; ++j) v[i] -= b[j][i] * v[j];
        v[i] /= b[i][i];
      }
      vectors.push_back(v);
    }
  }
};

/// The root mean square of the relative errors of the lowest non-zero Neumann eigenvalues: 5 of the square, up to 4 pi^2, or 6 of the cube, up to
/// 2 pi^2. They are computed by inverse iteration of a few more vectors, from the true eigenfunctions, with Rayleigh-Ritz.
template<class M, class Which, class Solver>
double eigenvalue_error(const M& m, const Which& which, Solver&& solver) {
  constexpr double pi = 3.14159265358979323846;
  constexpr int D = dimension_v<M>;
  std::vector<std::array<int, 3>> modes;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < (D == 2 ? 1 : 3); ++k)
        if (i * i + j * j + k * k <= (D == 2 ? 5 : 3)) modes.push_back({i, j, k});
  std::vector<double> known;
  for (const auto& [i, j, k] : modes)
    if (const int sum = i * i + j * j + k * k; sum > 0 && sum <= (D == 2 ? 4 : 2)) known.push_back(pi * pi * sum);
  std::sort(known.begin(), known.end());

  const Eigen::SparseMatrix<double> stiffness = -laplacian(m, which), mass = mass_matrix(m, {.lumped = false});
  const Eigen::SparseMatrix<double> shifted = stiffness + mass;
  solver.factorize(shifted);
  const std::size_t size = modes.size();
  const auto n = shifted.cols();
  std::vector<Eigen::VectorXd> x(size, Eigen::VectorXd(n)), ax = x, mx = x;
  for (const auto v : verts(m)) {
    const vec3 at = to_vec3(point(m, v));
    for (std::size_t c = 0; c < size; ++c) {
      const auto& [i, j, k] = modes[c];
      x[c][static_cast<Eigen::Index>(index_of(m, v))] = std::cos(pi * i * at.x) * std::cos(pi * j * at.y) * std::cos(pi * k * at.z);
    }
  }
  std::vector<double> values;
  for (int round = 0;; ++round) {
    small_eigenproblem::matrix a(size, std::vector<double>(size)), b = a;
    for (std::size_t c = 0; c < size; ++c) {
      multiply(shifted, x[c], ax[c]);
      multiply(mass, x[c], mx[c]);
    }
    for (std::size_t c = 0; c < size; ++c)
      for (std::size_t d = 0; d < size; ++d) {
        a[c][d] = x[c].dot(ax[d]);
        b[c][d] = x[c].dot(mx[d]);
      }
    const small_eigenproblem small(a, b);
    values = small.values;
    if (round == 4) break;
    // A Ritz vector divided by its value nearly solves the system with M times it as right-hand side. Only the correction is computed.
    std::vector<Eigen::VectorXd> next;
    for (std::size_t c = 0; c < size; ++c) {
      Eigen::VectorXd ritz = Eigen::VectorXd::Zero(n), lacks = ritz;
      for (std::size_t d = 0; d < size; ++d) {
        const double factor = small.vectors[c][d];
        ritz += factor / values[c] * x[d];
        lacks += factor * mx[d];
        lacks -= factor / values[c] * ax[d];
      }
      next.push_back(ritz);
      next.back() += solver.solve(lacks);
    }
    x = next;
  }
  double sum = 0;
  for (std::size_t i = 0; i < known.size(); ++i) {
    const double error = (values[i + 1] - 1) / known[i] - 1;
    sum += error * error;
  }
  return std::sqrt(sum / static_cast<double>(known.size()));
}

/// The rows of the table for one family and its first `sizes` sizes; make_solver(tolerance) returns the solver.
template<class M, class MakeSolver>
std::vector<convergence_row> measure_convergence(family f, std::size_t sizes, const MakeSolver& make_solver) {
  std::vector<M> meshes;
  for (std::size_t i = 0; i < sizes; ++i) meshes.push_back(make_family<M>(f, levels<M>()[i]));
  std::vector<convergence_row> rows;
  const auto add = [&](const char* what, const char* which, const auto& error) {
    rows.push_back({what, which, kind_name<M>, name_of(f)});
    for (const M& m : meshes) {
      try {
        rows.back().errors.push_back(error(m));
      } catch (const unsupported&) {
        rows.back().errors.push_back(std::numeric_limits<double>::quiet_NaN());
      }
    }
  };
  add("gradient", "-", [](const M& m) { return gradient_error(m); });
  add("poisson", "virtual_elements", [&](const M& m) { return poisson_error(m, virtual_elements, make_solver(1e-9)); });
  if constexpr (!(TriMesh<M> || TetMesh<M>)) {  // where all discretisations are the same
    add("poisson", "virtual_refinement", [&](const M& m) { return poisson_error(m, virtual_refinement, make_solver(1e-9)); });
    if constexpr (SurfaceMesh<M>) add("poisson", "de_goes", [&](const M& m) { return poisson_error(m, de_goes, make_solver(1e-9)); });
  }
  add("eigenvalues", "virtual_elements", [&](const M& m) { return eigenvalue_error(m, virtual_elements, make_solver(1e-3)); });  // of corrections
  return rows;
}

}  // namespace concino::testing
