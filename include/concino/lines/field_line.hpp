// field_line: a line that follows a vector field, with the reason why it stopped.
#pragma once

#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/lines/line_end.hpp>
#include <concino/mesh/mesh_point.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace concino {

/// A line along a field that is constant in each poly.
template<class M>
struct field_line {
  std::vector<mesh_point<M>> points;  // at a vert, on an edge, on a face of a volume, or inside a poly
  std::vector<poly_t<M>> polys;       // of the segments, from each point to the next: the poly whose field the segment
                                      // follows, or one of several
  double length = 0;
  line_end stopped_by = line_end::zero;
  line_end began_by = line_end::zero;  // of lines both ways: why the part backwards stopped
  std::vector<mesh_point<M>> cycle;   // the closed line to which this one winds; its last point is joined to the first
                                      // one
};

/// Options of integral_line.
struct integral_line_options {
  double max_length = std::numeric_limits<double>::infinity();  // above 0, in units of the mesh; of lines both ways for
                                                                // each part
  std::size_t max_steps = 0;                                    // segments, of lines both ways for each part; 0 means
                                                                // 16 times the polys plus 1,000
  bool backward = false;                                        // against the field
  bool both_ways = false;                                       // backward, then forward: one line through the start
  concino::progress progress = {};                              // of integral_lines
  concino::profiler* profiler = nullptr;                        // measures a call of integral_lines
};

}  // namespace concino
