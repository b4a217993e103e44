// frame_field(m): three perpendicular vectors at each vert and poly of a volume, as smooth as they can be.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/directions/detail/frames/frame_problem.hpp>
#include <concino/generate/to_tets.hpp>
#include <concino/geometry/outward_vector.hpp>
#include <concino/mesh/element_map.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino {

struct frame_field_options {
  double sharp_angle = 45;  // degrees, from 0 to 180: boundary edges with more between the normals of their faces are
                            // sharp
  int max_rounds = 300;     // 1 or more
  double tolerance = 1e-4;  // from 0 to 1: it ends when the mean change of a round, of functions of length 1, is less
  concino::progress progress = nullptr;   // called with "frame_field" after each round
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

template<class M>
struct frame_field_result {
  vert_map<M, orthonormal_frame> verts;
  poly_map<M, orthonormal_frame> polys;
  double energy = 0;           // the integral of the squared gradient of the functions of the frames; a length
  int rounds = 0;              // how many were made
  bool has_converged = false;  // whether the last round changed less than the tolerance
};

namespace detail {

/// numbers: of the verts, by index.
template<class M>
boundary_polygons polygons_of_boundary(const M& m, const std::vector<std::uint32_t>& numbers) {
  boundary_polygons b;
  for (const face_t<M> f : faces(m)) {
    if (!is_boundary(m, f)) continue;
    for (const vert_t<M> v : adj_f2v(m, f)) b.verts.push_back(numbers[index_of(m, v)]);
    b.first.push_back(b.verts.size());
    b.areas.push_back(outward_vector(m, *adj_f2p(m, f).begin(), f));
  }
  return b;
}

}  // namespace detail

/// A field of frames in a volume: at each vert and poly three perpendicular vectors, up to the 24 rotations of a cube,
/// as smooth as they can be and aligned to the boundary. Hexes that follow them are like cubes.
/// auto frames = frame_field(tets); frames.polys[p][0];
/// Needs:  Embedded VolumeMesh M, no temporary, of any polys.
/// Result: orthonormal, right-handed frames. At a vert where the boundary is smooth the first vector is vert_normal,
///         the direction of the sum of the area vectors. Where it is not, on a sharp edge or at a corner, the frame is
///         the best for the normals of all parts there, and contains them if they are perpendicular. The frame of a
///         poly is nearest to the mean of those of its verts. The problem is not convex: the result is a local minimum,
///         found in the same way each time. Verts of no poly have the axes as frames.
/// Cost:   a factorisation for each of some lengths, and nine solves in each round. Computed on the verts of
///         to_tets(m).
/// Errors: invalid_mesh if m has no polys, a point is not finite, or a poly has no positive volume; invalid_argument if
///         an option is out of its range; cancelled; those of laplacian.
/// Source: Ray, Sokolov, Levy 2016, "Practical 3D frame field generation", the functions of degree 4 and the boundary;
///         Palmer, Bommes, Solomon 2020, "Algebraic representations for volumetric frame fields": diffusion and
///         projection in turn, with lengths that decrease.
template<class M>
  requires requirement::is_lvalue_or_view<M> && VolumeMesh<M> && Embedded<M>
frame_field_result<std::remove_cvref_t<M>> frame_field(M&& m, const frame_field_options& options = {}) {
  const core::profiled_options profiled(options, "frame_field");
  detail::check_frame_options(profiled->sharp_angle, profiled->max_rounds, profiled->tolerance);
  std::vector<std::size_t> inverted;
  const tetmesh tets = to_tets(m, {.properties = false, .inverted_cells = &inverted});
  if (num_polys(m) == 0) core::throw_joined<invalid_mesh>({"frame_field: the mesh has no polys"});
  if (!inverted.empty())
    core::throw_joined<invalid_mesh>({"frame_field: poly ", inverted[0],
                                      " cannot be cut into tets of positive volume; validate() lists such polys"});
  auto normals = detail::normals_of_parts(
      detail::polygons_of_boundary(m, core::numbered(m, verts(m), vert_index_bound(m))), num_verts(tets),
      profiled->sharp_angle);
  const detail::smooth_frames found = detail::solve_frames(
      tets, std::move(normals), {profiled->max_rounds, profiled->tolerance, profiled->progress});

  frame_field_result<std::remove_cvref_t<M>> result{make_vert_map<orthonormal_frame>(m),
                                                    make_poly_map<orthonormal_frame>(m), found.energy, found.rounds,
                                                    found.has_converged};
  std::size_t i = 0;
  for (const vert_t<M> v : verts(m)) result.verts[v] = found.frames[i++];
  const detail::closest_frame closest;
  std::vector<orthonormal_frame> of_verts;
  for (const poly_t<M> p : polys(m)) {
    of_verts.clear();
    for (const vert_t<M> v : adj_p2v(m, p)) of_verts.push_back(result.verts[v]);
    result.polys[p] = closest.to_mean(of_verts);
  }
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void frame_field(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void frame_field(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void frame_field(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
