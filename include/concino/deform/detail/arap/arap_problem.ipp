// Bodies of arap_problem.hpp: as rigid as possible: the edges of a shape with their weights, its unknown verts, and the
// two steps of an iteration.
#pragma once

#include <concino/core/error.hpp>
#include <concino/deform/detail/arap/arap_problem.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace concino::detail {

CONCINO_INLINE void arap_problem::keep_edges(const Eigen::SparseMatrix<double>& laplacian) {
  double largest = 0;
  for (int c = 0; c < laplacian.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator it(laplacian, c); it; ++it)
      largest = std::max(largest, std::abs(it.value()));
  weight_unit_ = power_of_two_above(largest);
  std::vector<double> diagonal(static_cast<std::size_t>(laplacian.outerSize()));
  for (int c = 0; c < laplacian.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator it(laplacian, c); it; ++it)
      if (it.row() == c) diagonal[static_cast<std::size_t>(c)] = std::abs(it.value());
  std::size_t twice_negative = 0;
  for (int c = 0; c < laplacian.outerSize(); ++c) {
    for (Eigen::SparseMatrix<double>::InnerIterator it(laplacian, c); it; ++it) {
      if (it.row() == c) continue;
      if (polys_.is_empty()) {
        // smaller ones are 0 but for rounding
        const double rounding =
            1e-12 * (diagonal[static_cast<std::size_t>(c)] + diagonal[static_cast<std::size_t>(it.row())]);
        if (!(std::abs(it.value()) > rounding)) continue;
        twice_negative += it.value() < 0;
      }
      to_.push_back(static_cast<std::uint32_t>(it.row()));
      weight_.push_back((polys_.is_empty() ? 2 * std::abs(it.value()) : it.value()) / weight_unit_);
    }
    first_.push_back(static_cast<std::uint32_t>(to_.size()));
  }
  num_made_positive_ = twice_negative / 2;
}

CONCINO_INLINE arap_problem::arap_problem(std::vector<vec3> points, const std::vector<std::size_t>& used,
                                          const Eigen::SparseMatrix<double>& laplacian,
                                          const std::vector<std::size_t>& handles, arap_polys polys)
    : rest_(std::move(points)), unknown_(rest_.size(), not_unknown), is_handle_(rest_.size(), false),
      polys_(std::move(polys)) {
  unit_ = unit_of(rest_, used);
  for (vec3& x : rest_) x /= unit_;
  keep_edges(laplacian);
  if (!polys_.is_empty()) {
    polys_.divide_weights(weight_unit_);
    polys_.sum_edges(rest_, first_, to_, out_, in_, own_);
  }
  components_ = edge_components::find(rest_.size(), first_.data(), to_.data());
  std::vector<bool> has_handle(components_.number, false);
  for (const std::size_t v : handles) {
    if (!is_handle_[v]) handles_.push_back(static_cast<std::uint32_t>(v));
    is_handle_[v] = true;
    has_handle[components_.of[v]] = true;
  }
  for (const std::size_t v : used) {
    if (is_handle_[v] || first_[v] == first_[v + 1]) continue;
    if (!has_handle[components_.of[v]])
      throw_not_determined("prepare_deform", components_, v, "has no handle, so that its place is not determined");
    unknown_[v] = static_cast<std::uint32_t>(vert_of_unknown_.size());
    vert_of_unknown_.push_back(static_cast<std::uint32_t>(v));
  }
}

CONCINO_INLINE Eigen::SparseMatrix<double> arap_problem::lower_triangle() const {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t row = 0; row < num_unknowns(); ++row) {
    const std::uint32_t v = vert_of_unknown_[row];
    double sum = 0;
    for (std::uint32_t k = first_[v]; k < first_[v + 1]; ++k) {
      sum += weight_[k];
      const std::uint32_t column = unknown_[to_[k]];
      if (column != not_unknown && column < row)
        entries.emplace_back(static_cast<int>(row), static_cast<int>(column), -weight_[k]);
    }
    entries.emplace_back(static_cast<int>(row), static_cast<int>(row), sum);
  }
  const auto n = static_cast<Eigen::Index>(num_unknowns());
  Eigen::SparseMatrix<double> lower(n, n);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

CONCINO_INLINE std::vector<vec3> arap_problem::rigid_start(const std::vector<vec3>& position) const {
  std::vector<vec3> at(rest_.size());
  for (const std::uint32_t v : handles_) at[v] = position[v] / unit_;
  std::vector<vec3> x = components_.moved(rest_, handles_, at);
  for (std::size_t v = 0; v < rest_.size(); ++v) x[v] = is_handle_[v] ? position[v] : unit_ * x[v];
  return x;
}

}  // namespace concino::detail
