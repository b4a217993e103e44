// Weights of bones, or of other handles, at the verts of a mesh.
#pragma once

#include <concino/core/compiled.hpp>

#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino {

/// A weight of a bone at a vert, by its index.
struct skin_weight {
  std::size_t vert = 0, bone = 0;
  double weight = 0;
};

/// Weights of bones at verts: 0 or more, of sum 1 at each vert that has some. Only those that are not 0 are stored.
class skin_weights {
  std::size_t num_bones_ = 0;
  std::vector<std::size_t> first_{0};
  std::vector<std::uint32_t> bones_;
  std::vector<double> values_;

 public:
  skin_weights() = default;
  /// From a list in any order. Weights of the same vert and bone add up. They are divided by their sum at each vert.
  /// num_verts: the index bound of the mesh.
  /// Errors: invalid_argument if a vert or bone is not below its number, a weight is negative or not finite, or the
  ///         sum at a vert overflows or is 0 although it is in the list; unsupported for 2^32 bones or more.
  skin_weights(std::size_t num_verts, std::size_t num_bones, const std::vector<skin_weight>& all);
  /// From a matrix of a row for each vert, and a column for each bone. Rows of zeros have no weights.
  explicit skin_weights(const Eigen::SparseMatrix<double>& matrix);

  std::size_t num_verts() const { return first_.size() - 1; }
  std::size_t num_bones() const { return num_bones_; }
  /// The bones that have a weight at the vert of this index, in increasing order, and the weights.
  std::span<const std::uint32_t> bones(std::size_t vert) const {
    return {bones_.data() + first_[vert], bones_.data() + first_[vert + 1]};
  }
  std::span<const double> weights(std::size_t vert) const {
    return {values_.data() + first_[vert], values_.data() + first_[vert + 1]};
  }
  double weight(std::size_t vert, std::size_t bone) const;

  /// The k largest weights of each vert, divided by their sum; of equal ones those of the first bones.
  /// Errors: invalid_argument if k is 0.
  skin_weights at_most(std::size_t k) const;
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/deform/detail/skin/skin_weights.ipp>
#endif
