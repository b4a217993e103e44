// Bodies of arap_polys.hpp: as rigid as possible with spokes and rims: the matrices of polys.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/deform/detail/arap/arap_polys.hpp>

#include <algorithm>
#include <array>

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
  for (std::size_t p = 0; p < num_polys(); ++p) {
    const double n = first_[p + 1] - first_[p];  // each vert of the poly sees it
    for_each_pair(p, [&](std::uint32_t i, std::uint32_t j, double w) {
      const int a = static_cast<int>(vert_[first_[p] + i]), b = static_cast<int>(vert_[first_[p] + j]);
      for (const auto& [row, column, sign] : {std::array{a, b, 1}, {b, a, 1}, {a, a, -1}, {b, b, -1}})
        entries.emplace_back(row, column, sign * n * w);
    });
  }
  const auto n = static_cast<Eigen::Index>(size);
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

CONCINO_INLINE void arap_polys::divide_weights(double unit) {
  for (double& w : weight_) w /= unit;
}

CONCINO_INLINE void arap_polys::sum_edges(const std::vector<vec3>& rest, const std::vector<std::uint32_t>& first,
                                          const std::vector<std::uint32_t>& to, std::vector<vec3>& out,
                                          std::vector<vec3>& in, std::vector<vec3>& own) const {
  out.assign(to.size(), {});
  in.assign(to.size(), {});
  own.assign(rest.size(), {});
  std::vector<vec3> sum;  // of weights times the edges to each vert of the poly
  for (std::size_t p = 0; p < num_polys(); ++p) {
    const std::uint32_t* v = vert_.data() + first_[p];
    const std::uint32_t n = first_[p + 1] - first_[p];
    sum.assign(n, {});
    for_each_pair(p, [&](std::uint32_t i, std::uint32_t j, double w) {
      const vec3 e = w * (rest[v[i]] - rest[v[j]]);
      sum[i] += e;
      sum[j] -= e;
    });
    for (std::uint32_t i = 0; i < n; ++i) {
      own[v[i]] += sum[i];
      for (std::uint32_t j = 0; j < n; ++j) {
        if (j == i) continue;
        const auto begin = to.begin() + first[v[i]], end = to.begin() + first[v[i] + 1];
        const auto k = static_cast<std::size_t>(std::lower_bound(begin, end, v[j]) - to.begin());
        out[k] += sum[j];
        in[k] += sum[i];
      }
    }
  }
}

CONCINO_INLINE double arap_polys::energy_of(std::size_t poly, const std::vector<vec3>& rest, const std::vector<vec3>& x,
                                            const std::vector<rotation_columns>& rotations,
                                            std::vector<vec3>& difference) const {
  const std::uint32_t* v = vert_.data() + first_[poly];
  const std::uint32_t n = first_[poly + 1] - first_[poly];
  const rotation_columns& r = rotations[v[0]];
  difference.clear();  // from the rest that is rotated with the first vert
  for (std::uint32_t i = 0; i < n; ++i) difference.push_back(x[v[i]] - x[v[0]] - turned(r, rest[v[i]] - rest[v[0]]));
  double squares = 0;
  moment_matrix moments, edges;
  for_each_pair(poly, [&](std::uint32_t i, std::uint32_t j, double w) {
    const vec3 d = difference[i] - difference[j], e = rest[v[i]] - rest[v[j]];
    squares += w * dot(d, d);
    moments.add(w, e, d);
    edges.add(w, e, e);
  });
  double sum = n * squares;
  for (std::uint32_t i = 1; i < n; ++i) {
    rotation_columns d;
    for (std::size_t c = 0; c < 3; ++c) d[c] = r[c] - rotations[v[i]][c];
    for (std::size_t c = 0; c < 3; ++c) sum += dot(d[c], 2 * moments.of[c] + turned(d, edges.of[c]));
  }
  return sum;
}

CONCINO_INLINE double arap_polys::energy(const std::vector<vec3>& rest, const std::vector<vec3>& x,
                                         const std::vector<rotation_columns>& rotations) const {
  constexpr std::size_t block = 256;
  std::vector<double> energies((num_polys() + block - 1) / block);
  parallel_for(
      energies.size(),
      [&](std::size_t b) {
        std::vector<vec3> difference;
        for (std::size_t p = b * block; p < std::min(num_polys(), (b + 1) * block); ++p)
          energies[b] += energy_of(p, rest, x, rotations, difference);
      },
      1);
  double whole = 0;
  for (const double e : energies) whole += e;
  return std::max(0.0, whole);
}

}  // namespace concino::detail
