// Eigenpairs of large sparse matrices, and Laplacian eigenfunctions of surfaces and volumes of any polys, by Spectra.
// Needs: Spectra (Debian: libspectra-dev).
#pragma once

#include <concino/adapters/detail/spectra_lanczos.hpp>
#include <concino/concepts/sparse_solver.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/residual.hpp>
#include <concino/core/system_checks.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/operators/mass_matrix.hpp>
#include <concino/solve/ldlt.hpp>

#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

struct eigenpairs_options {
  double tolerance = 1e-10;  // of residuals, relative to the eigenvalue plus the shift, or rounding errors of K u if larger; above 0 and below 1
  int max_restarts = 1000;   // of the iteration, 1 or more
  /// K + shift M is factorised; in units of the eigenvalues, finite, 0 or more. 0: the mean of the diagonal of K, divided by that of M and by the number
  /// of rows.
  double shift = 0;
};

struct eigenpairs_result {
  Eigen::VectorXd values;     // smallest first
  Eigen::MatrixXd vectors;    // one per column, orthonormal with respect to the mass; the entry with the largest absolute value is positive
  Eigen::VectorXd residuals;  // |K u - lambda M u| / |M u|, in units of the eigenvalues
  std::size_t solves = 0;
  std::size_t isolated = 0;  // rows without entries, where vectors are 0
};

namespace detail {

/// K and M without the rows that are empty in both, scaled so that their diagonals are about 1; lower triangles.
struct eigenproblem {
  Eigen::SparseMatrix<double> stiffness, mass;
  std::vector<int> row;  // row numbers in the input matrices
  int stiffness_exponent = 0, mass_exponent = 0;
  double shift = 1;  // in units of the scaled eigenvalues

  static void expect(bool good, core::message why) {
    if (!good) core::throw_joined<invalid_argument>(why);
  }

  static void check(const Eigen::SparseMatrix<double>& k, const Eigen::SparseMatrix<double>& m, const eigenpairs_options& options) {
    const std::string tolerance = core::number_text(options.tolerance), input_shift = core::number_text(options.shift);
    expect(options.tolerance > 0 && options.tolerance < 1, {"eigenpairs: tolerance is ", tolerance, "; it must be above 0 and below 1"});
    expect(options.max_restarts > 0, {"eigenpairs: max_restarts must be 1 or more"});
    expect(options.shift >= 0 && std::isfinite(options.shift), {"eigenpairs: shift is ", input_shift, "; it must be finite and 0 or more"});
    expect(k.rows() == m.rows() && k.cols() == m.cols(), {"eigenpairs: the mass has ", static_cast<std::size_t>(m.rows()), " rows, the other matrix ",
                                                          static_cast<std::size_t>(k.rows()), "; they must be of the same size"});
    core::check_square("eigenpairs", k);
  }

  eigenproblem(const Eigen::SparseMatrix<double>& k, const Eigen::SparseMatrix<double>& m, const eigenpairs_options& options) {
    check(k, m, options);
    Eigen::SparseMatrix<double> k_storage, m_storage;
    const auto &whole_k = core::compressed(k, k_storage), &whole_m = core::compressed(m, m_storage);
    core::check_entries("eigenpairs", whole_k);
    core::check_entries("eigenpairs, mass", whole_m);
    const std::vector<int> new_row = number_rows(whole_k, whole_m);
    choose_scales(core::diagonal(whole_k), core::diagonal(whole_m), options.shift);
    stiffness = part(whole_k, new_row, stiffness_exponent);
    mass = part(whole_m, new_row, mass_exponent);
  }

  /// Lists the rows that have entries.   Result: the position of each row in that list, or -1.
  std::vector<int> number_rows(const Eigen::SparseMatrix<double>& k, const Eigen::SparseMatrix<double>& m) {
    std::vector<int> new_row(static_cast<std::size_t>(k.cols()), -1);
    for (const auto* a : {&k, &m})
      for (int c = 0; c < a->cols(); ++c)
        for (int e = a->outerIndexPtr()[c]; e < a->outerIndexPtr()[c + 1]; ++e)
          if (a->valuePtr()[e] != 0) new_row[static_cast<std::size_t>(c)] = new_row[static_cast<std::size_t>(a->innerIndexPtr()[e])] = 0;
    for (int c = 0; c < k.cols(); ++c)
      if (new_row[static_cast<std::size_t>(c)] == 0) {
        new_row[static_cast<std::size_t>(c)] = static_cast<int>(row.size());
        row.push_back(c);
      }
    return new_row;
  }

  /// Chooses the powers of 2 by which both matrices are divided, and the shift, from the means of their diagonals.
  /// Errors: solver_error if a row has no mass.
  void choose_scales(const std::vector<double>& k_diagonal, const std::vector<double>& m_diagonal, double input_shift) {
    double k_mean = 0, m_mean = 0;
    const double n = static_cast<double>(row.size());
    for (const int c : row) {
      if (!(m_diagonal[static_cast<std::size_t>(c)] > 0))
        core::throw_joined<solver_error>(
            {"eigenpairs: row ", static_cast<std::size_t>(c), " has no positive mass, so it has no finite eigenvalue; leave it out"});
      k_mean += std::abs(k_diagonal[static_cast<std::size_t>(c)]) / n;
      m_mean += m_diagonal[static_cast<std::size_t>(c)] / n;
    }
    if (m_mean > 0) mass_exponent = std::ilogb(m_mean);
    if (k_mean > 0) stiffness_exponent = std::ilogb(k_mean);
    if (input_shift > 0) shift = std::ldexp(input_shift, mass_exponent - stiffness_exponent);
    else if (k_mean > 0) shift = std::ldexp(k_mean, -stiffness_exponent) / std::ldexp(m_mean, -mass_exponent) / n;
  }

  Eigen::SparseMatrix<double> part(const Eigen::SparseMatrix<double>& a, const std::vector<int>& new_row, int exponent) const {
    const auto n = static_cast<Eigen::Index>(row.size());
    Eigen::SparseMatrix<double> r(n, n);
    r.reserve(a.nonZeros());
    for (int c = 0; c < n; ++c) {
      r.startVec(c);
      const int column = row[static_cast<std::size_t>(c)];
      for (int e = a.outerIndexPtr()[column]; e < a.outerIndexPtr()[column + 1]; ++e) {
        const int to = new_row[static_cast<std::size_t>(a.innerIndexPtr()[e])];
        if (to >= c) r.insertBack(to, c) = std::ldexp(a.valuePtr()[e], -exponent);
      }
    }
    r.finalize();
    return r;
  }

  eigenpairs_result result(const eigenbasis& found, Eigen::Index rows) const {
    eigenpairs_result r;
    const Eigen::Index count = found.values.size();
    r.values.resize(count);
    r.residuals.resize(count);
    r.vectors = Eigen::MatrixXd::Zero(rows, count);
    r.solves = found.solves;
    r.isolated = static_cast<std::size_t>(rows) - row.size();
    for (Eigen::Index i = 0; i < count; ++i) {
      const Eigen::VectorXd u = found.vectors.col(i);
      Eigen::Index largest = 0;
      for (Eigen::Index k = 1; k < u.size(); ++k)
        if (std::abs(u[k]) > std::abs(u[largest]) * (1 + 1e-6)) largest = k;
      const int unit = stiffness_exponent - mass_exponent;
      r.values[i] = std::ldexp(found.values[i], unit);
      r.residuals[i] = std::ldexp(eigen_residual(stiffness, mass, found.values[i], u).size, unit);
      const int halved = mass_exponent >> 1;
      const double factor = std::ldexp(u[largest] < 0 ? -1.0 : 1.0, -halved) * (mass_exponent == 2 * halved ? 1 : std::sqrt(0.5));
      for (Eigen::Index k = 0; k < u.size(); ++k) r.vectors(row[static_cast<std::size_t>(k)], i) = factor * u[k];
    }
    return r;
  }
};

}  // namespace detail

/// The smallest eigenvalues lambda of K u = lambda M u, and their vectors.
/// Needs:  K symmetric and positive semidefinite, such as minus a Laplacian; M symmetric and positive definite, lumped or not; of both only the lower
///         triangle is read. Rows that are empty in both are left out and counted. count: at least 1, at most the number of remaining rows.
///         solver: a SparseSolver for K + shift M, which is positive definite.
/// Result: `count` pairs, multiple eigenvalues repeated, with verified residuals; deterministic. Eigenvalues that are zero are zero up to rounding.
///         Multiplying K and M by powers of 2 scales values exactly, and also vectors if that of M is a power of 4.
/// Cost:   one factorisation and, for each pair, some 3 to 11 solves; O(rows count) memory. If rows < 2 count + 1 or there are no more than 32 rows,
///         all at once in O(rows^3).
/// Errors: invalid_argument if count or an option is out of its range, or the matrices differ in size. solver_error if a matrix has entries that
///         are not finite, a row has no mass, or M is not positive definite. solver_error if not all pairs have converged: it names how many have,
///         and the residual. Those of the solver.
/// Source: Lehoucq, Sorensen 1996, "Deflation techniques for an implicitly restarted Arnoldi iteration", in Spectra; paper section 2.2.
template<class Solver = ldlt>
  requires SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
eigenpairs_result eigenpairs(const Eigen::SparseMatrix<double>& k, const Eigen::SparseMatrix<double>& m, std::size_t count,
                             const eigenpairs_options& options = {}, Solver&& solver = {}) {
  const detail::eigenproblem problem(k, m, options);
  const std::size_t rows = problem.row.size();
  if (count < 1 || count > rows)
    core::throw_joined<invalid_argument>({"eigenpairs: ", count, " eigenpairs are requested; the problem has ", rows, " rows with entries, so request 1 to ", rows});
  const auto wanted = static_cast<Eigen::Index>(count);
  detail::eigenbasis found;
  if (rows <= 32 || rows < 2 * count + 1) {
    const auto n = static_cast<Eigen::Index>(rows);
    found = detail::eigenpairs_within(problem.stiffness, problem.mass, Eigen::MatrixXd::Identity(n, n));
    found.values.conservativeResize(wanted);
    found.vectors.conservativeResize(Eigen::NoChange, wanted);
  } else {
    const Eigen::SparseMatrix<double> shifted = problem.stiffness + problem.shift * problem.mass;
    core::factorize_symmetric(solver, shifted);
    const auto solve = [&](const Eigen::VectorXd& b) -> Eigen::VectorXd { return std::as_const(solver).solve(b); };
    found = detail::smallest_eigenpairs(problem.stiffness, problem.mass, solve, problem.shift, wanted, options.tolerance, options.max_restarts);
  }
  return problem.result(found, k.rows());
}

struct eigenfunctions_options {
  bool lumped = true;        // mass matrix, see mass_matrix: if it is not lumped, values converge from above
  double tolerance = 1e-10;  // as that of eigenpairs
  int max_restarts = 1000;   // as that of eigenpairs
};

template<class M>
struct eigenfunctions_result {
  std::vector<double> values;                  // smallest first, in units of 1 / length^2
  std::vector<vert_map<M, double>> functions;  // the integral of the square of each is 1, of a product of two 0, with respect to the mass
  std::vector<double> residuals;               // as those of eigenpairs
  std::size_t isolated = 0;                    // verts without polys, where functions are 0
};

/// The Laplacian eigenfunctions of a surface or a volume, with Neumann boundary conditions: minus the Laplacian of each is its value times the
/// function, and its normal derivative at the boundary is zero. The Laplacian is that of the discretisation argument, after the count, or that of
/// virtual_elements.
/// Needs:  EmbeddedMesh M, no temporary; with a Discretisation also what that needs. count: at least 1, at most the verts of polys. solver: as for
///         eigenpairs.
/// Result: `count` functions; the first is constant with value 0, and the value 0 occurs once per component of polys. Errors of values
///         decrease with the square of the edge length. Scaling the mesh by a power of 2 scales values exactly, and also functions, but those of
///         volumes only for a power of 4.
/// Cost:   as laplacian, mass_matrix and eigenpairs.
/// Errors: as laplacian, mass_matrix and eigenpairs.
/// Source: Vallet, Levy 2008, "Spectral geometry processing with manifold harmonics"; Reuter, Wolter, Peinecke 2006, "Laplace-Beltrami spectra as
///         Shape-DNA"; Kac 1966, "Can one hear the shape of a drum?".
template<class M, class Solver = ldlt>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
eigenfunctions_result<std::remove_cvref_t<M>> eigenfunctions(M&& m, std::size_t count, const eigenfunctions_options& options = {},
                                                             Solver&& solver = {}) {
  return eigenfunctions(m, count, virtual_elements, options, solver);
}
template<class M, class D, class Solver = ldlt>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> && Discretisation<D, M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
eigenfunctions_result<std::remove_cvref_t<M>> eigenfunctions(M&& m, std::size_t count, const D& discretisation,
                                                             const eigenfunctions_options& options = {}, Solver&& solver = {}) {
  const Eigen::SparseMatrix<double> k = -laplacian(m, discretisation);
  const eigenpairs_result pairs = eigenpairs(k, mass_matrix(m, {.lumped = options.lumped}), count,
                                             {.tolerance = options.tolerance, .max_restarts = options.max_restarts}, solver);
  eigenfunctions_result<std::remove_cvref_t<M>> r;
  for (Eigen::Index i = 0; i < pairs.values.size(); ++i) {
    r.values.push_back(pairs.values[i]);
    r.residuals.push_back(pairs.residuals[i]);
    r.functions.push_back(make_vert_map<double>(m, 0.0));
    std::span<double> u = r.functions.back().values();
    for (std::size_t v = 0; v < u.size(); ++v) u[v] = pairs.vectors(static_cast<Eigen::Index>(v), i);
  }
  for (const vert_t<M> v : verts(m)) {
    bool has_poly = false;
    for ([[maybe_unused]] const poly_t<M> p : adj_v2p(m, v)) has_poly = true;
    r.isolated += !has_poly;
  }
  return r;
}

// What to write instead of calls that cannot compile.
template<class... T> void eigenfunctions(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter
template<class... T> void eigenfunctions(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void eigenfunctions(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: a point at each vert, or with_points(m, map)

}  // namespace concino
