// Which way up to print a part: the direction of the lowest cost.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/print/detail/supports/part_surface.hpp>

#include <cstddef>
#include <vector>

namespace concino {

struct build_direction_options {
  double max_angle_deg = 45;           // in [0, 90]: polys whose angle is smaller need supports, see overhangs
  double overhang_weight = 1;          // 0 or more, of the area of polys that overhang
  double support_weight = 1;           // 0 or more, of the volume of their supports
  double height_weight = 0.1;          // 0 or more, of the height of the part, which is the number of layers
  double plate_weight = 0.5;           // 0 or more, of the area that does not lie on the plate: else parts would stand
                                       // on edges
  std::size_t samples = 4;             // 1 to 100; n: 24 n^2 + 2 directions over the sphere are compared, besides those
                                       // of the hull
  std::size_t max_hull_faces = 100;    // up to this many faces of the convex hull are compared, large ones first
  double accuracy_deg = 0.1;           // in (0, 45]: the best directions are improved until changes by this angle make
                                       // them worse
  double plate_tolerance = 1e-6;       // in [0, 0.1]: polys lie on the plate if they are this close, as a fraction of
                                       // the diagonal of the part
  concino::progress progress = {};     // called with the fraction done and "best build direction"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// The best direction, and what overhangs if the part is built in it, in units of the mesh as overhang_report.
template<class M>
struct build_direction_result {
  vec3 direction = {0, 0, 1};         // of length 1, away from the plate
  double cost = 0;                    // as best_build_direction says
  double overhang_area = 0;
  double support_volume = 0;
  double plate_area = 0;
  double height = 0;
  std::vector<polygon_t<M>> ignored;  // polys without an area
};

namespace detail {

/// Costs of directions. Sizes are those of the part_surface.
struct build_direction_found {
  vec3 direction;
  double cost = 0, overhang_area = 0, support_volume = 0, plate_area = 0, height = 0;
};

build_direction_found find_build_direction(const part_surface& part, const build_direction_options& options);

}  // namespace detail

/// The direction in which printing a part is cheapest: auto d = best_build_direction(m); o = overhangs(m, {.direction =
/// d.direction});
/// Needs:  as overhangs.
/// Result: the direction of the lowest cost that was found:
///
///           overhang_weight a / A  +  support_weight v / A^(3/2)  +  height_weight h / A^(1/2)
///           +  plate_weight (1 - p / A)
///
///         with the area A of the part, and a, v, h, p the area, support_volume, height and plate_area of overhangs,
///         the plate at the lowest point. So the cost does not depend on the unit. Compared are the directions in which
///         a face of the convex hull lies on the plate, and others, which are spread around the principal axes of the
///         part's area; the best of both are improved locally. Faces of the hull within 0.06 degrees of a larger one
///         are joined with it. A part that is moved or turned has the same cost, and its direction turns with it if no
///         other is as good; without distinct principal axes this holds if a face of the hull is best, which is nearly
///         always so, else approximately. The minimum is not proved to be global.
/// Cost:   O(n) for each direction, and that of overhangs for those that can still be better than the best one;
///         parallel.
/// Errors: as overhangs; invalid_mesh if no poly has an area; cancelled.
template<EmbeddedMesh M>
build_direction_result<M> best_build_direction(const M& m, const build_direction_options& options = {}) {
  const core::profiled_options profiled(options, "best_build_direction");
  const detail::printed_part<M> part = detail::outer_surface(m, "best_build_direction");
  const auto found = detail::find_build_direction(part.surface, *profiled);
  const auto& s = part.surface;
  return {found.direction,
          found.cost,
          s.to_mesh(found.overhang_area, 2),
          s.to_mesh(found.support_volume, 3),
          s.to_mesh(found.plate_area, 2),
          s.to_mesh(found.height, 1),
          part.ignored};
}

// What to write instead of calls that cannot compile.
template<class... T> void best_build_direction(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void best_build_direction(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/print/detail/supports/best_build_direction.ipp>
#endif
