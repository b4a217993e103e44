// line_end: why a line stopped.
#pragma once

namespace concino {

/// Why a line along a field, or a geodesic, stopped.
enum class line_end {
  boundary,        // it reached the boundary of the mesh; of a geodesic also: its direction at the start leads out of
                   // the surface
  sink,            // a place inside where no poly, face or edge around it leads on
  zero,            // the field is zero where the line would go on, or the poly there has no area or volume
  max_length,      // the wanted length
  non_manifold,    // an edge of a surface with three polys or more, or a face with three; of a geodesic also: a vert
                   // about which the polys are not one fan
  closed,          // it came back to its start
  winds_to_cycle,  // it comes ever closer to a closed line, or runs round one that does not contain its start: see
                   // field_line
  max_steps,       // the wanted number of steps
  too_close,       // it came too close to another line of evenly_spaced_lines, or to itself
};

}  // namespace concino
