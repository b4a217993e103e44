// Bodies of smoothest_values.hpp: the eigenproblems and linear systems of n-direction fields.
#pragma once

#include <concino/core/eigenproblem.hpp>
#include <concino/directions/detail/smoothest/smoothest_values.hpp>
#include <concino/solve/ldlt.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>

namespace concino::detail {

/// The unknowns of one component, each a complex number with two rows.
struct component_system {
  std::vector<std::uint32_t> verts;       // by number
  Eigen::SparseMatrix<double> stiffness;  // lower triangle
  Eigen::VectorXd mass, right;            // by row
};

/// Adds the entries of a complex number times z_column as rows of real and imaginary parts; the lower triangle.
inline void add_complex(int row, int column, const complex_value& x, std::vector<Eigen::Triplet<double>>& entries) {
  entries.emplace_back(2 * row, 2 * column, x.real());
  entries.emplace_back(2 * row + 1, 2 * column + 1, x.real());
  entries.emplace_back(2 * row + 1, 2 * column, x.imag());
  if (row != column) entries.emplace_back(2 * row, 2 * column + 1, -x.imag());
}

/// The systems of all components, with the wishes in them.
inline std::vector<component_system> component_systems(const oriented_surface& s, const connection_energy& e,
                                                       const wanted_values& wishes) {
  std::vector<component_system> all(s.num_components);
  std::vector<int> number(s.num_verts(), -1);
  std::vector<std::vector<Eigen::Triplet<double>>> entries(s.num_components);
  for (std::uint32_t v = 0; v < s.num_verts(); ++v) {
    if (s.component[v] == oriented_surface::none || wishes.is_fixed[v]) continue;
    component_system& c = all[s.component[v]];
    number[v] = static_cast<int>(c.verts.size());
    add_complex(number[v], number[v], e.diagonal[v] + wishes.weight[v], entries[s.component[v]]);
    c.verts.push_back(v);
  }
  for (component_system& c : all) {
    const auto rows = 2 * static_cast<Eigen::Index>(c.verts.size());
    c.right = Eigen::VectorXd::Zero(rows);
    c.mass = Eigen::VectorXd::Zero(rows);
    for (Eigen::Index k = 0; k < rows; ++k) {
      const std::uint32_t v = c.verts[static_cast<std::size_t>(k / 2)];
      c.mass[k] = s.mass[v];
      c.right[k] = wishes.weight[v] * (k % 2 ? wishes.wanted[v].imag() : wishes.wanted[v].real());
    }
  }
  const auto move_right = [&](component_system& c, int row, const complex_value& x) {
    c.right[2 * row] -= x.real();
    c.right[2 * row + 1] -= x.imag();
  };
  for (const connection_energy::entry& x : e.entries) {
    const std::uint32_t at = s.component[x.i];
    const int row = number[x.i], column = number[x.j];  // numbers grow with verts: the lower triangle
    if (row >= 0 && column >= 0) add_complex(row, column, x.value, entries[at]);
    else if (row >= 0) move_right(all[at], row, x.value * wishes.wanted[x.j]);
    else if (column >= 0) move_right(all[at], column, std::conj(x.value) * wishes.wanted[x.i]);
  }
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto rows = 2 * static_cast<Eigen::Index>(all[k].verts.size());
    all[k].stiffness.resize(rows, rows);
    all[k].stiffness.setFromTriplets(entries[k].begin(), entries[k].end());
  }
  return all;
}

/// Start vectors that no symmetry of a surface has, the same each time; the second of a pair is i times the first.
inline Eigen::MatrixXd start_vectors(Eigen::Index rows, Eigen::Index columns) {
  Eigen::MatrixXd x(rows, columns);
  std::uint64_t state = 1;
  const auto random = [&] {  // a linear congruential generator (Knuth)
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state >> 11) * 0x1p-53 - 0.5;
  };
  for (Eigen::Index c = 0; c + 1 < columns; c += 2)
    for (Eigen::Index r = 0; r + 1 < rows; r += 2) {
      const double a = random(), b = random();
      x(r, c) = a;
      x(r + 1, c) = b;
      x(r, c + 1) = -b;
      x(r + 1, c + 1) = a;
    }
  return x;
}

/// The field with the smallest eigenvalue, by inverse iteration with a block of vectors that holds the eigenspace of a
/// sphere, which has 2 n + 1 dimensions.
inline double smallest_mode(const component_system& c, int n, Eigen::VectorXd& x, double& residual,
                            const progress& on_progress) {
  constexpr int max_iterations = 300;
  constexpr double tolerance = 1e-10;
  const Eigen::Index rows = c.stiffness.rows(), columns = std::min<Eigen::Index>(rows, 2 * std::min(2 * n + 2, 12));
  double scale = 0;  // below the first eigenvalues that are not 0
  for (Eigen::Index k = 0; k < rows; ++k) scale += c.stiffness.coeff(k, k) / c.mass[k];
  scale /= static_cast<double>(rows) * static_cast<double>(rows);
  Eigen::SparseMatrix<double> mass(rows, rows);
  mass.setIdentity();
  for (Eigen::Index k = 0; k < rows; ++k) mass.valuePtr()[k] = c.mass[k];
  const Eigen::SparseMatrix<double> shifted = c.stiffness + (1e-3 * scale) * mass;
  ldlt solver;
  solver.factorize(shifted);
  core::eigenbasis basis = core::eigenpairs_within(c.stiffness, mass, start_vectors(rows, columns));
  for (int i = 0; i < max_iterations; ++i) {
    report_progress(on_progress, static_cast<double>(i) / max_iterations, "direction_field");
    for (Eigen::Index k = 0; k < columns; ++k)
      basis.vectors.col(k) = solver.solve(c.mass.cwiseProduct(basis.vectors.col(k)));
    basis = core::eigenpairs_within(c.stiffness, mass, basis.vectors);
    x = basis.vectors.col(0);
    const Eigen::VectorXd rest =
        core::symmetric_product(c.stiffness, x) - basis.values[0] * c.mass.cwiseProduct(x);
    residual = std::sqrt(rest.cwiseAbs2().cwiseQuotient(c.mass).sum()) / (std::abs(basis.values[0]) + scale);
    if (residual <= tolerance) break;
  }
  return std::max(basis.values[0], 0.0);
}

/// The energy of values over the integral of their squares, in each component.
inline std::vector<double> quotients(const oriented_surface& s, const connection_energy& e,
                                     const std::vector<complex_value>& z) {
  std::vector<double> energy(s.num_components, 0.0), square(s.num_components, 0.0);
  for (std::uint32_t v = 0; v < s.num_verts(); ++v) {
    if (s.component[v] == oriented_surface::none) continue;
    energy[s.component[v]] += e.diagonal[v] * std::norm(z[v]);
    square[s.component[v]] += s.mass[v] * std::norm(z[v]);
  }
  for (const auto& x : e.entries) energy[s.component[x.i]] += 2 * std::real(std::conj(z[x.i]) * x.value * z[x.j]);
  for (std::size_t k = 0; k < energy.size(); ++k) energy[k] = square[k] > 0 ? energy[k] / square[k] : 0;
  return energy;
}

CONCINO_INLINE smoothest_values find_smoothest(const oriented_surface& s, const connection_energy& e, int n,
                                               const wanted_values& wishes, const progress& on_progress) {
  smoothest_values r;
  r.value = wishes.wanted;
  std::vector<unsigned char> is_wanted(s.num_components);
  constexpr double rounding = 1e-12;
  for (std::uint32_t v = 0; v < s.num_verts(); ++v)
    if (s.component[v] != oriented_surface::none &&
        (wishes.is_fixed[v] || wishes.weight[v] > rounding * e.diagonal[v]))
      is_wanted[s.component[v]] = 1;
  std::vector<double> smallest(s.num_components, -1.0);
  const auto systems = component_systems(s, e, wishes);
  for (std::size_t k = 0; k < systems.size(); ++k) {
    const component_system& c = systems[k];
    if (c.verts.empty()) continue;
    Eigen::VectorXd x;
    if (is_wanted[k]) {
      ldlt solver;
      solver.factorize(c.stiffness);
      x = solver.solve(c.right);
    } else {
      double residual = 0;
      smallest[k] = smallest_mode(c, n, x, residual, on_progress);
      r.residual = std::max(r.residual, residual);
    }
    for (std::size_t i = 0; i < c.verts.size(); ++i) {
      const auto row = 2 * static_cast<Eigen::Index>(i);
      r.value[c.verts[i]] = {x[row], x[row + 1]};
    }
  }
  r.energy = quotients(s, e, r.value);
  for (std::size_t k = 0; k < smallest.size(); ++k)
    if (smallest[k] >= 0) r.energy[k] = smallest[k];
  return r;
}

}  // namespace concino::detail
