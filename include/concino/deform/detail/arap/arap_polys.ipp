// Bodies of arap_polys.hpp: as rigid as possible with spokes and rims: the matrices of polys, and their part of both
// steps of an iteration.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/deform/detail/arap/arap_polys.hpp>

#include <algorithm>

namespace concino::detail {

CONCINO_INLINE void arap_polys::add(const std::vector<std::uint32_t>& verts, const std::vector<double>& entries) {
  vert_.insert(vert_.end(), verts.begin(), verts.end());
  first_.push_back(static_cast<std::uint32_t>(vert_.size()));
  std::size_t at = 0;
  for (std::size_t i = 0; i < verts.size(); ++i, ++at)  // the last of each row is on the diagonal
    for (std::size_t j = 0; j < i; ++j) weight_.push_back(-entries[at++]);
  first_weight_.push_back(weight_.size());
}

CONCINO_INLINE Eigen::SparseMatrix<double> arap_polys::laplacian(std::size_t size) const {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(4 * weight_.size());
  for (std::size_t p = 0; p + 1 < first_.size(); ++p) {
    const double n = first_[p + 1] - first_[p];  // each vert of the poly sees it
    std::size_t at = first_weight_[p];
    for (std::uint32_t i = first_[p]; i < first_[p + 1]; ++i)
      for (std::uint32_t j = first_[p]; j < i; ++j, ++at) {
        const int a = static_cast<int>(vert_[i]), b = static_cast<int>(vert_[j]);
        const double w = n * weight_[at];
        for (const auto& [row, column, sign] : {std::array{a, b, 1}, {b, a, 1}, {a, a, -1}, {b, b, -1}})
          entries.emplace_back(row, column, sign * w);
      }
  }
  const auto n = static_cast<Eigen::Index>(size);
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

CONCINO_INLINE void arap_polys::prepare(const std::vector<vec3>& rest, double weight_unit) {
  for (double& w : weight_) w /= weight_unit;
  first_place_.assign(rest.size() + 1, 0);
  for (const std::uint32_t v : vert_) ++first_place_[v + 1];
  for (std::size_t v = 0; v < rest.size(); ++v) first_place_[v + 1] += first_place_[v];
  place_.resize(vert_.size());
  poly_.resize(vert_.size());
  pull_.assign(vert_.size(), {});
  std::vector<std::uint32_t> next(first_place_.begin(), first_place_.end() - 1);
  for (std::size_t p = 0; p + 1 < first_.size(); ++p) {
    std::size_t at = first_weight_[p];
    for (std::uint32_t i = first_[p]; i < first_[p + 1]; ++i) {
      place_[next[vert_[i]]++] = i;
      poly_[i] = static_cast<std::uint32_t>(p);
      for (std::uint32_t j = first_[p]; j < i; ++j) {
        const vec3 e = weight_[at++] * (rest[vert_[i]] - rest[vert_[j]]);
        pull_[i] += e;
        pull_[j] -= e;
      }
    }
  }
}

CONCINO_INLINE double arap_polys::squares(std::size_t poly, const std::vector<vec3>& y) const {
  double sum = 0;
  const double* w = weight_.data() + first_weight_[poly];
  for (std::size_t i = 0; i < first_[poly + 1] - first_[poly]; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const vec3 d = y[i] - y[j];
      sum += *w++ * dot(d, d);
    }
  return sum;
}

CONCINO_INLINE double arap_polys::local_step(const std::vector<vec3>& rest, const std::vector<vec3>& x,
                                             std::vector<rotation_columns>& rotations) const {
  const std::size_t num_polys = first_.size() - 1;
  std::vector<moment_matrix> moments(num_polys);
  std::vector<double> bound(num_polys), energy(num_polys);
  // y: the points of the poly, relative to the first one
  const auto fill = [&](std::size_t p, const std::vector<vec3>& points, std::vector<vec3>& y) {
    y.clear();
    for (std::uint32_t k = first_[p]; k < first_[p + 1]; ++k) y.push_back(points[vert_[k]] - points[vert_[first_[p]]]);
  };
  constexpr std::size_t block = 256;
  const std::size_t num_blocks = (num_polys + block - 1) / block;
  const auto for_each_poly = [&](const auto& f) {
    parallel_for(
        num_blocks,
        [&](std::size_t b) {
          std::vector<vec3> y, z;
          for (std::size_t p = b * block; p < std::min(num_polys, (b + 1) * block); ++p) f(p, y, z);
        },
        1);
  };
  for_each_poly([&](std::size_t p, std::vector<vec3>& y, std::vector<vec3>& z) {
    fill(p, x, y);
    fill(p, rest, z);
    for (std::size_t i = 0; i < y.size(); ++i) moments[p].add(1, pull_[first_[p] + i], y[i]);
    bound[p] = 0.5 * (squares(p, y) + squares(p, z));
  });
  parallel_for(
      rest.size(),
      [&](std::size_t v) {
        if (first_place_[v] == first_place_[v + 1]) return;
        moment_matrix sum;
        double whole_bound = 0;
        for (std::uint32_t k = first_place_[v]; k < first_place_[v + 1]; ++k) {
          const std::uint32_t p = poly_[place_[k]];
          for (std::size_t d = 0; d < 3; ++d) sum.of[d] += moments[p].of[d];
          whole_bound += bound[p];
        }
        rotations[v] = best_rotation(sum, whole_bound);
      },
      block);
  // Relative to the rotation of the first vert, so that nothing large cancels where the rotations are nearly equal.
  for_each_poly([&](std::size_t p, std::vector<vec3>& y, std::vector<vec3>& z) {
    fill(p, x, y);
    fill(p, rest, z);
    const rotation_columns& r = rotations[vert_[first_[p]]];
    moment_matrix differences, edges;
    for (std::size_t i = 0; i < y.size(); ++i) {
      y[i] -= turned(r, z[i]);
      differences.add(1, pull_[first_[p] + i], y[i]);
      edges.add(1, pull_[first_[p] + i], z[i]);
    }
    double sum = static_cast<double>(y.size()) * squares(p, y);
    for (std::uint32_t k = first_[p] + 1; k < first_[p + 1]; ++k) {
      rotation_columns d;
      for (std::size_t c = 0; c < 3; ++c) d[c] = r[c] - rotations[vert_[k]][c];
      for (std::size_t c = 0; c < 3; ++c) sum += dot(d[c], 2 * differences.of[c] + turned(d, edges.of[c]));
    }
    energy[p] = sum;
  });
  double whole = 0;
  for (const double e : energy) whole += e;
  return std::max(0.0, whole);
}

CONCINO_INLINE std::vector<rotation_columns> arap_polys::sums_of(const std::vector<rotation_columns>& rotations) const {
  std::vector<rotation_columns> sums(first_.size() - 1);
  parallel_for(
      sums.size(),
      [&](std::size_t p) {
        for (std::uint32_t k = first_[p]; k < first_[p + 1]; ++k)
          for (std::size_t d = 0; d < 3; ++d) sums[p][d] += rotations[vert_[k]][d];
      },
      256);
  return sums;
}

}  // namespace concino::detail
