// Bodies of stripe_angles.hpp: the smoothest complex function that turns along a field, and its angles.
#pragma once

#include <concino/directions/detail/stripes/stripe_angles.hpp>
#include <concino/directions/detail/surface/poly_planes.hpp>

#include <concino/core/eigenproblem.hpp>
#include <concino/core/error.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/operators/virtual_elements.hpp>
#include <concino/solve/ldlt.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace concino::detail {

/// At the corners of a poly: by how much the angle grows from its first corner along the mean of the field there, and
/// 1 or -1, by whether the line of the vert has the direction that agrees with the first corner's.
struct corner_waves {
  std::vector<double> phase, sign;  // by corner

  corner_waves(const oriented_surface& s, int n, const std::vector<std::complex<double>>& field, double frequency)
      : phase(s.vert.size()), sign(s.vert.size(), 1.0) {
    const poly_planes planes(s);
    const auto direction = [&](std::uint32_t c) {  // in the plane of the poly; the bisectors of both angles agree
      return planes.along[c] + planes.inside[c] / 2 - s.from[c] - s.angle[c] / 2 + std::arg(field[s.vert[c]]) / n;
    };
    for (std::size_t p = 0; p < s.num_polys(); ++p) {
      const std::uint32_t first = s.first[p], last = s.first[p + 1];
      double x = 0, y = 0;
      for (std::uint32_t c = first; c < last; ++c) {
        const double a = direction(c);
        if (n == 2 && std::cos(a - direction(first)) < 0) sign[c] = -1;
        x += sign[c] * std::cos(a), y += sign[c] * std::sin(a);
      }
      const double scale = 2 * std::numbers::pi * frequency / (last - first);
      for (std::uint32_t c = first; c < last; ++c) {
        const vec3 d = s.points[s.vert[c]] - s.points[s.vert[first]];
        phase[c] = scale * (x * dot(d, planes.axes[p][0]) + y * dot(d, planes.axes[p][1]));
      }
    }
  }
};

/// The energy of complex values at verts, of two rows each: in each poly that of a function by virtual elements, after
/// its values are turned back by the phases. The lower triangle.
CONCINO_INLINE Eigen::SparseMatrix<double> stripe_energy(const oriented_surface& s, const corner_waves& waves) {
  surface_arrays a;
  a.points = s.points;
  a.offsets = s.first;
  for (const std::uint32_t v : s.vert) a.verts.push_back(vert_id{v});
  const polygonmesh m(std::move(a));
  auto stiffness = virtual_elements.poly_matrices(m);
  local_matrix<vert_id> local;
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<std::uint32_t> corner;
  std::size_t p = 0;
  for (const poly_id poly : polys(m)) {
    stiffness(poly, local);
    corner.assign(local.size(), s.first[p]);
    for (std::size_t k = 0; k < local.size(); ++k)
      for (std::uint32_t c = s.first[p]; c < s.first[p + 1]; ++c)
        if (s.vert[c] == index_of(m, local.verts[k])) corner[k] = c;
    for (std::size_t k = 0; k < local.size(); ++k)
      for (std::size_t l = 0; l < local.size(); ++l) {
        const int i = static_cast<int>(s.vert[corner[k]]), j = static_cast<int>(s.vert[corner[l]]);
        if (j > i) continue;
        const double value = k >= l ? local.at(k, l) : local.at(l, k);
        const double turn = waves.phase[corner[k]] - waves.phase[corner[l]];
        const double c = value * std::cos(turn), d = value * std::sin(turn);
        const double si = waves.sign[corner[k]], sj = waves.sign[corner[l]];
        entries.emplace_back(2 * i, 2 * j, c);
        entries.emplace_back(2 * i + 1, 2 * j, si * d);
        entries.emplace_back(2 * i + 1, 2 * j + 1, si * sj * c);
        if (i != j) entries.emplace_back(2 * i, 2 * j + 1, -sj * d);
      }
    ++p;
  }
  for (std::uint32_t v = 0; v < s.num_verts(); ++v)
    for (const int row : {2 * static_cast<int>(v), 2 * static_cast<int>(v) + 1})
      entries.emplace_back(row, row, s.component[v] == oriented_surface::none ? 1.0 : 0.0);
  Eigen::SparseMatrix<double> matrix(2 * static_cast<int>(s.num_verts()), 2 * static_cast<int>(s.num_verts()));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// Makes the integral of the square over each component 1.
CONCINO_INLINE void normalize_components(const oriented_surface& s, Eigen::VectorXd& x) {
  std::vector<double> square(s.num_components, 0.0);
  for (std::uint32_t v = 0; v < s.num_verts(); ++v)
    if (s.component[v] != oriented_surface::none)
      square[s.component[v]] += s.mass[v] * (x[2 * v] * x[2 * v] + x[2 * v + 1] * x[2 * v + 1]);
  for (std::uint32_t v = 0; v < s.num_verts(); ++v) {
    const bool is_used = s.component[v] != oriented_surface::none && square[s.component[v]] > 0;
    const double factor = is_used ? 1 / std::sqrt(square[s.component[v]]) : 0;
    x[2 * v] *= factor, x[2 * v + 1] *= factor;
  }
}

/// The eigenvectors of the smallest eigenvalues of all components, by inverse iteration from the same start each time.
CONCINO_INLINE Eigen::VectorXd smallest_waves(const oriented_surface& s, const Eigen::SparseMatrix<double>& energy,
                                              const progress& on_progress, stripe_angles& result) {
  constexpr int max_iterations = 100;
  constexpr double tolerance = 1e-9;
  const auto rows = static_cast<Eigen::Index>(2 * s.num_verts());
  Eigen::VectorXd mass = Eigen::VectorXd::Ones(rows), x(rows);
  double area = 0;
  for (std::uint32_t v = 0; v < s.num_verts(); ++v) {
    if (s.component[v] != oriented_surface::none) mass[2 * v] = mass[2 * v + 1] = s.mass[v], area += s.mass[v];
    x[2 * v] = 1, x[2 * v + 1] = 0.5 * std::sin(1.0 + v);
  }
  const double small = 1 / area;  // eigenvalues of long waves on the surface are about so large
  Eigen::SparseMatrix<double> shifted = energy;
  for (int i = 0; i < rows; ++i) shifted.coeffRef(i, i) += 1e-3 * small * mass[i];
  ldlt solver;
  solver.factorize(shifted);
  for (int k = 0; k < max_iterations; ++k) {
    report_progress(on_progress, static_cast<double>(k) / max_iterations, "stripes");
    normalize_components(s, x);
    const Eigen::VectorXd ax = core::symmetric_product(energy, x);
    std::vector<double> value(s.num_components, 0.0), rest(s.num_components, 0.0);
    for (std::uint32_t i = 0; i < rows; ++i)
      if (s.component[i / 2] != oriented_surface::none) value[s.component[i / 2]] += x[i] * ax[i];
    for (std::uint32_t i = 0; i < rows; ++i)
      if (const std::uint32_t c = s.component[i / 2]; c != oriented_surface::none)
        rest[c] += (ax[i] - value[c] * mass[i] * x[i]) * (ax[i] - value[c] * mass[i] * x[i]) / mass[i];
    result.energy = result.residual = 0;
    for (std::size_t c = 0; c < value.size(); ++c) {
      result.energy = std::max(result.energy, value[c]);
      result.residual = std::max(result.residual, std::sqrt(rest[c]) / (std::abs(value[c]) + small));
    }
    if (result.residual <= tolerance) break;
    x = solver.solve(mass.cwiseProduct(x));
  }
  return x;
}

/// How the angle grows along the edge of corner c, as seen in the direction of the field at vert[c], and whether the
/// direction at the other end agrees with it (1) or not (-1). From the other end it is the same.
CONCINO_INLINE std::pair<double, double> growth_along_edge(const oriented_surface& s, int n,
                                                           const std::vector<std::complex<double>>& field,
                                                           double frequency, const Eigen::VectorXd& x,
                                                           std::uint32_t c) {
  if (s.twin[c] < c) {
    const auto [growth, sign] = growth_along_edge(s, n, field, frequency, x, s.twin[c]);
    return {-sign * growth, sign};
  }
  constexpr double pi = std::numbers::pi;
  const std::uint32_t v = s.vert[c], w = s.vert[s.next[c]];
  const double at_v = std::arg(field[v]) / n, at_w = std::arg(field[w]) / n;
  const double sign = n == 2 && std::cos(at_w - at_v - s.transport(c)) < 0 ? -1 : 1;
  const double wanted = pi * frequency * norm(s.points[w] - s.points[v]) *
                        (std::cos(at_v - s.from[c]) + sign * std::cos(at_w - s.back(c) - pi));
  const double difference =
      sign * std::atan2(x[2 * w + 1], x[2 * w]) - std::atan2(x[2 * v + 1], x[2 * v]) - wanted;
  return {wanted + std::remainder(difference, 2 * pi), sign};
}

/// Errors: invalid_argument if more than a thousand stripes would cross an edge. Their lines would fill the memory.
CONCINO_INLINE void check_frequency(const oriented_surface& s, double frequency) {
  constexpr double most_stripes = 1000;
  for (std::uint32_t c = 0; c < s.vert.size(); ++c)
    if (!(frequency * norm(s.points[s.vert[s.next[c]]] - s.points[s.vert[c]]) <= most_stripes))
      throw invalid_argument("stripes: more than 1,000 stripes would cross an edge; choose a lower frequency");
}

CONCINO_INLINE stripe_angles find_stripes(const oriented_surface& s, int n,
                                          const std::vector<std::complex<double>>& field, double frequency,
                                          const progress& on_progress) {
  check_frequency(s, frequency);
  stripe_angles result;
  const Eigen::SparseMatrix<double> energy = stripe_energy(s, corner_waves(s, n, field, frequency));
  const Eigen::VectorXd x = smallest_waves(s, energy, on_progress, result);
  result.angle.resize(s.vert.size());
  result.index.resize(s.num_polys());
  result.field_turns.resize(s.num_polys());
  for (std::size_t p = 0; p < s.num_polys(); ++p) {
    const std::uint32_t first = s.first[p], v = s.vert[first];
    const double start = std::atan2(x[2 * v + 1], x[2 * v]);
    double angle = start, direction = 1;
    for (std::uint32_t c = first; c < s.first[p + 1]; ++c) {
      result.angle[c] = angle;
      const auto [growth, sign] = growth_along_edge(s, n, field, frequency, x, c);
      angle += direction * growth;
      direction *= sign;
    }
    result.field_turns[p] = direction < 0;
    if (direction > 0) result.index[p] = static_cast<int>(std::lround((angle - start) / (2 * std::numbers::pi)));
  }
  return result;
}

}  // namespace concino::detail
