// Bodies of skin_weights.hpp: weights of bones, or of other handles, at the verts of a mesh.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/number_text.hpp>
#include <concino/deform/skin_weights.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace concino {

CONCINO_INLINE skin_weights::skin_weights(std::size_t num_verts, std::size_t num_bones,
                                          const std::vector<skin_weight>& all)
    : num_bones_(num_bones), first_(num_verts + 1, 0) {
  if (num_bones > std::numeric_limits<std::uint32_t>::max())
    core::throw_joined<unsupported>({"skin_weights: ", num_bones, " bones are more than 2^32 - 1"});
  for (const skin_weight& w : all) {
    if (w.vert >= num_verts || w.bone >= num_bones)
      core::throw_joined<invalid_argument>({"skin_weights: vert ", w.vert, " and bone ", w.bone,
                                            " have a weight, but there are ", num_verts, " verts and ", num_bones,
                                            " bones"});
    if (!(w.weight >= 0) || !std::isfinite(w.weight))
      core::throw_joined<invalid_argument>({"skin_weights: the weight of bone ", w.bone, " at vert ", w.vert, " is ",
                                            core::number_text(w.weight), "; it must be finite and 0 or more"});
    ++first_[w.vert + 1];
  }
  std::vector<std::size_t> begin(num_verts + 1, 0);
  for (std::size_t v = 0; v < num_verts; ++v) begin[v + 1] = begin[v] + first_[v + 1];
  std::vector<std::pair<std::uint32_t, double>> sorted(all.size());
  std::vector<std::size_t> next = begin;
  for (const skin_weight& w : all) sorted[next[w.vert]++] = {static_cast<std::uint32_t>(w.bone), w.weight};
  first_.assign(1, 0);
  for (std::size_t v = 0; v < num_verts; ++v) {
    const auto from = sorted.begin() + static_cast<std::ptrdiff_t>(begin[v]),
               until = sorted.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]);
    std::sort(from, until);
    double sum = 0;
    for (auto w = from; w != until; ++w) sum += w->second;
    if (from != until && (!(sum > 0) || !std::isfinite(sum)))
      core::throw_joined<invalid_argument>({"skin_weights: the sum of the weights at vert ", v, " is ",
                                            core::number_text(sum), "; it must be finite and more than 0"});
    for (auto w = from; w != until; ++w) {
      if (w->second == 0) continue;
      if (bones_.size() > first_[v] && bones_.back() == w->first) {
        values_.back() += w->second / sum;
      } else {
        bones_.push_back(w->first);
        values_.push_back(w->second / sum);
      }
    }
    first_.push_back(bones_.size());
  }
}

namespace detail {

CONCINO_INLINE std::vector<skin_weight> entries_of(const Eigen::SparseMatrix<double>& matrix) {
  std::vector<skin_weight> all;
  for (int c = 0; c < matrix.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, c); it; ++it)
      if (it.value() != 0) all.push_back({static_cast<std::size_t>(it.row()), static_cast<std::size_t>(c), it.value()});
  return all;
}

}  // namespace detail

CONCINO_INLINE skin_weights::skin_weights(const Eigen::SparseMatrix<double>& matrix)
    : skin_weights(static_cast<std::size_t>(matrix.rows()), static_cast<std::size_t>(matrix.cols()),
                   detail::entries_of(matrix)) {}

CONCINO_INLINE double skin_weights::weight(std::size_t vert, std::size_t bone) const {
  const auto all = bones(vert);
  const auto found = std::lower_bound(all.begin(), all.end(), bone);
  return found == all.end() || *found != bone ? 0
                                              : values_[first_[vert] + static_cast<std::size_t>(found - all.begin())];
}

CONCINO_INLINE skin_weights skin_weights::at_most(std::size_t k) const {
  if (k == 0) core::throw_joined<invalid_argument>({"skin_weights::at_most: k is 0; each vert needs a weight"});
  skin_weights fewer;
  fewer.num_bones_ = num_bones_;
  std::vector<std::size_t> order;
  for (std::size_t v = 0; v < num_verts(); ++v) {
    const auto all_bones = bones(v);
    const auto all = weights(v);
    order.clear();
    for (std::size_t i = 0; i < all.size(); ++i) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return all[a] > all[b]; });
    if (order.size() > k) order.resize(k);
    std::sort(order.begin(), order.end());
    double sum = 0;
    for (const std::size_t i : order) sum += all[i];
    for (const std::size_t i : order) {
      fewer.bones_.push_back(all_bones[i]);
      fewer.values_.push_back(all[i] / sum);
    }
    fewer.first_.push_back(fewer.bones_.size());
  }
  return fewer;
}

}  // namespace concino
