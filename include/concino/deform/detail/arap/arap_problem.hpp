// As rigid as possible: the edges of a shape with their weights, its unknown verts, and the two steps of an iteration.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/residual.hpp>
#include <concino/core/vec3.hpp>
#include <concino/deform/detail/arap/arap_polys.hpp>
#include <concino/deform/detail/arap/components.hpp>

#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Options of the iteration, see deform_options.
struct arap_limits {
  int max_iterations = 0;
  double tolerance = 0;
};

/// Verts are numbers below the index bound of the mesh. Lengths are in units, a power of 2, that make the size near 1.
class arap_problem {
  enum : std::uint32_t { not_unknown = static_cast<std::uint32_t>(-1) };
  std::vector<vec3> rest_;
  double unit_ = 1, weight_unit_ = 1;
  std::vector<std::uint32_t> first_{0}, to_;  // edges from each vert
  std::vector<double> weight_;                // of the equations; twice those of spokes
  edge_components components_;
  std::vector<std::uint32_t> unknown_, vert_of_unknown_, handles_;  // handles: each once
  std::vector<bool> is_handle_;
  std::size_t num_made_positive_ = 0;
  arap_polys polys_;                  // empty: spokes, by the edges
  std::vector<vec3> out_, in_, own_;  // see arap_polys::sum_edges; empty: spokes

  void keep_edges(const Eigen::SparseMatrix<double>& laplacian);

 public:
  /// laplacian: both triangles; points of all indices, those of deleted verts arbitrary. polys: empty for spokes; for
  /// spokes and rims laplacian is theirs.
  /// Errors: solver_error if a component with edges has no handle.
  arap_problem(std::vector<vec3> points, const std::vector<std::size_t>& used,
               const Eigen::SparseMatrix<double>& laplacian, const std::vector<std::size_t>& handles,
               arap_polys polys = {});

  std::size_t num_made_positive() const { return num_made_positive_; }
  std::size_t num_unknowns() const { return vert_of_unknown_.size(); }
  std::size_t vert_of_unknown(std::size_t row) const { return vert_of_unknown_[row]; }
  bool is_handle(std::size_t vert) const { return vert < is_handle_.size() && is_handle_[vert]; }
  const std::vector<std::uint32_t>& handles() const { return handles_; }

  /// The lower triangle of the system of the unknown verts.
  Eigen::SparseMatrix<double> lower_triangle() const;

  /// All verts moved by the best rigid motion of the handles of their component.
  /// position: of each handle, by index of the vert.
  std::vector<vec3> rigid_start(const std::vector<vec3>& position) const;

  /// Iterates from `points`, which have the positions of the handles, and returns the energies. The first one is that
  /// of the start.
  std::vector<double> iterate(core::solver_ref solver, const Eigen::SparseMatrix<double>& lower,
                              const arap_limits& limits, std::vector<vec3>& points, bool& has_converged) const;

 private:
  /// The best rotation at each vert, and the energy.
  double local_step(const std::vector<vec3>& x, std::vector<rotation_columns>& rotations) const;
  struct vert_sums {
    double products = 0;  // of its edges with their rest, rotated
    double whole = 0;     // what that would be if the edges were their rest, rotated
  };
  /// Finds the best rotation of a vert.
  vert_sums rotate(std::size_t v, const std::vector<vec3>& x, rotation_columns& rotation) const;
  /// Without cancellation.
  double energy(const std::vector<vec3>& x, const std::vector<rotation_columns>& rotations) const;
  /// The right side of the equation of a vert, without the handles.
  vec3 right_side(std::size_t v, const std::vector<rotation_columns>& rotations) const;
  void global_step(core::solver_ref solver, const Eigen::SparseMatrix<double>& lower,
                   const std::vector<rotation_columns>& rotations, bool check, std::vector<vec3>& x) const;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/deform/detail/arap/arap_iteration.ipp>
#include <concino/deform/detail/arap/arap_problem.ipp>
#endif
