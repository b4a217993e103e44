// field_line: a line that follows a vector field, with the reason why it stopped.
#pragma once

#include <concino/core/progress.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/mesh_point.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace concino {

/// Why a line stopped.
enum class line_end {
  boundary,           // it reached the boundary of the mesh
  sink,               // a place inside where no poly, face or edge around it leads on
  zero,               // the field is zero where the line would go on, or the poly there has no area or volume
  max_length,         // the wanted length
  non_manifold_edge,  // an edge of a surface with three polys or more, or a face with three
  closed,             // it came back to its start
  winds_to_cycle,     // it comes ever closer to a closed line, or runs round one that does not contain its start: see cycle
  max_steps,          // the wanted number of steps
  too_close,          // it came too close to another line of evenly_spaced_lines, or to itself
};

/// A line along a field that is constant in each poly.
template<class M>
struct field_line {
  std::vector<vec3> points;
  std::vector<mesh_point<M>> places;  // of the points: at a vert, on an edge, on a face of a volume, or inside a poly
  std::vector<poly_t<M>> polys;       // of the segments, from each point to the next: the poly whose field the segment follows, or one of several
  double length = 0;
  line_end stopped_by = line_end::zero;
  line_end began_by = line_end::zero;  // of lines both ways: why the part backwards stopped
  std::vector<vec3> cycle;             // the closed line to which this one winds; its last point is joined to the first one
};

/// Options of integral_line.
struct integral_line_options {
  double max_length = std::numeric_limits<double>::infinity();  // above 0, in units of the mesh; of lines both ways for each part
  std::size_t max_steps = 0;                                    // segments, of lines both ways for each part; 0 means 16 times the polys plus 1,000
  bool backward = false;                                        // against the field
  bool both_ways = false;                                       // backward, then forward: one line through the start
  concino::progress progress = {};                              // of integral_lines
};

}  // namespace concino
