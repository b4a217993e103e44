// Frames at the verts of tets, as smooth as they can be and aligned to the boundary.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/progress.hpp>
#include <concino/directions/detail/frames/octahedral.hpp>
#include <concino/mesh/tetmesh.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

struct frame_problem_options {
  int max_rounds = 300;
  double tolerance = 1e-4;
  concino::progress progress = nullptr;
};

struct smooth_frames {
  std::vector<orthonormal_frame> frames;
  double energy = 0;
  int rounds = 0;
  bool has_converged = false;
};

/// The polygons of the boundary of a volume.
struct boundary_polygons {
  std::vector<std::uint32_t> verts;     // numbers of the verts of the first polygon in cyclic order, of the second, ...
  std::vector<std::size_t> first{0};    // those of polygon i are verts[first[i]] ... verts[first[i + 1] - 1]
  std::vector<vec3> areas;              // area vectors, outward
};

/// The unit normals of the boundary at each vert, one for each smooth part of the boundary around it.
/// sharp_angle: between the normals of polygons, in degrees.
std::vector<std::vector<vec3>> normals_of_parts(const boundary_polygons& boundary, std::size_t num_verts,
                                                double sharp_angle);

/// Errors: invalid_argument that names the option.
void check_frame_options(double sharp_angle, int max_rounds, double tolerance);

/// normals: of the boundary at each vert; none inside.
/// Errors: solver_error, cancelled.
smooth_frames solve_frames(const tetmesh& m, std::vector<std::vector<vec3>> normals,
                           const frame_problem_options& options);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/directions/detail/frames/frame_problem.ipp>
#endif
