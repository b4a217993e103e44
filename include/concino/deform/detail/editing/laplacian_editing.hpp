// Laplacian editing: the system of the unknown displacements.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/residual.hpp>
#include <concino/core/vec3.hpp>
#include <concino/deform/detail/arap/components.hpp>

#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Verts are numbers. Lengths are in units, a power of 2, that make the size near 1. Row 3 i + d is coordinate d of
/// unknown vert i.
class laplacian_editing {
  double unit_ = 1;
  edge_components components_;
  std::vector<vec3> start_;  // moved by the best rigid motions of the handles
  std::vector<std::uint32_t> vert_of_unknown_;
  Eigen::SparseMatrix<double> lower_;
  Eigen::VectorXd load_;

  /// The rows of the changes of the Laplacian vectors: what remains of those of a displacement u, when those of the
  /// start are mapped by the similarity I + T(u) that is best for the edges of the vert. Divided by the roots of
  /// masses.
  Eigen::SparseMatrix<double, Eigen::RowMajor> change_of_vectors(const Eigen::SparseMatrix<double>& laplacian,
                                                                 const std::vector<double>& mass) const;

 public:
  /// laplacian: both triangles.
  /// Errors: see laplacian_deform.
  laplacian_editing(const std::vector<vec3>& rest, const std::vector<std::size_t>& used,
                    const Eigen::SparseMatrix<double>& laplacian, const std::vector<double>& mass,
                    const std::vector<std::uint32_t>& handles, const std::vector<vec3>& positions);

  const Eigen::SparseMatrix<double>& lower() const { return lower_; }
  const Eigen::VectorXd& load() const { return load_; }
  /// Errors: always solver_error, which names the vert of the row and its component.
  [[noreturn, gnu::cold]] void throw_singular(Eigen::Index row) const;
  /// The points for these displacements; those of handles are where the rigid motion puts them.
  std::vector<vec3> points(const Eigen::VectorXd& u) const;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/deform/detail/editing/laplacian_editing.ipp>
#endif
