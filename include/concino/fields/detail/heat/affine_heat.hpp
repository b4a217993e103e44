// Heat flow of tangent vectors, and of positions seen from each vert, over a surface of triangles. On flat arrays only.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/residual.hpp>
#include <concino/core/tangent_vector.hpp>
#include <concino/geometry/support/tangent_frames.hpp>

#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace concino::detail {

/// An edge between verts a and b, as seen from both. A vector in the frame of b is, in the frame of a, rotated by an
/// angle; where the frames have opposite orientations, it is also reflected.
struct transport_edge {
  int a, b;
  double weight;
  tangent_vector from_a, from_b;  // the edge as a vector in the frame of each end
  double cosine, sine;            // of the angle
  bool reflects;

  tangent_vector to_a(const tangent_vector& x) const {
    const double y = reflects ? -x.y : x.y;
    return {cosine * x.x - sine * y, sine * x.x + cosine * y};
  }
  tangent_vector to_b(const tangent_vector& x) const {
    const double y = cosine * x.y - sine * x.x;
    return {cosine * x.x + sine * x.y, reflects ? -y : y};
  }
};

/// The equations of heat for one short time. Weights are positive, so heat is, too.
struct affine_heat {
  std::vector<transport_edge> edges;
  std::vector<double> mass;  // by vert; 1 at verts without triangles
  std::vector<unsigned char> is_used;  // by vert: whether it has triangles
  double time = 0;
  bool reflects = false;               // some edge does
  Eigen::SparseMatrix<double> scalars, vectors;  // lower triangles; the vector at vert i has rows 2 i and 2 i + 1

  std::size_t size() const { return mass.size(); }
};

/// time: in the units of the triangles, squared; 0: the square of the length of edges, averaged by area.
affine_heat make_affine_heat(const core::unfolded_triangles& triangles, const std::vector<core::tangent_frame>& frames,
                             double time);

/// Heat of several sorts at each vert. All are scaled by one power of two of the vert, so that they do not underflow
/// far from their sources.
struct diffused {
  Eigen::VectorXd heat, second_heat;      // of the sources with value 1; with the length of their vectors
  Eigen::VectorXd square;                 // the squared lengths of vectors to the sources, times heat
  Eigen::VectorXd first, second, offset;  // transported vectors; vectors to the sources, times heat; two numbers at
                                          // each vert
  std::vector<int> round;                 // -1 where no heat arrived

  bool is_reached(std::size_t v) const { return round[v] >= 0; }
  static tangent_vector at(const Eigen::VectorXd& x, std::size_t v) {
    const auto i = 2 * static_cast<Eigen::Index>(v);
    return {x[i], x[i + 1]};
  }
};
struct vector_source {
  int vert;
  tangent_vector vector;
};
/// What to compute besides the heat and the first vectors.
struct diffusion_outputs {
  bool second_heat = false, second = false, offset = false;  // second: of vectors that are turned by a right angle;
                                                             // offset: and squares
};

/// Errors: invalid_argument if the time is so short that heat vanishes from one vert to the next; solver_error.
diffused diffuse(const affine_heat& equations, core::solver_ref scalar_solver, core::solver_ref vector_solver,
                 const std::vector<vector_source>& sources, const diffusion_outputs& extra, const char* caller);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/heat/affine_diffusion.ipp>
#include <concino/fields/detail/heat/affine_heat.ipp>
#endif
