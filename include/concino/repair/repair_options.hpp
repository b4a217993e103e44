// The options of repair.
#pragma once

#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace concino {

/// What repair does with triangles without area. Corners that verts merged by repair make equal are always removed.
enum class degenerate_elements : std::uint8_t {
  keep,
  remove,    // they are removed, which may leave holes
  collapse,  // edges are collapsed whose ends coincide; else the vert between the other two splits the edge of these,
             // so that neighbours meet there. No point moves.
};

/// How repair fills holes of surfaces.
enum class hole_filling : std::uint8_t {
  minimal_area,  // with the triangles of its verts that have the smallest area in total, by dynamic programming
  fan,           // with triangles around a new vert at the mean of its verts
};

/// What repair does with triangles that intersect others.
enum class intersecting_triangles : std::uint8_t {
  ignore,
  report,  // the result names them
  remove,  // they are removed, and the holes that this makes are filled, of any size
};

/// By default, repair does what has only one right answer.
struct repair_options {
  std::optional<double> merge_within = std::nullopt;  // a distance, finite and 0 or more: verts at most this far apart
                                                      // become one, and verts connected by such distances too, at
                                                      // their mean; 0: equal points. Unless given, none are merged
  bool remove_duplicates = true;                      // of polys with the same verts, the first one remains
  bool remove_unreferenced = true;                    // removes verts without polys and faces without polys
  degenerate_elements degenerate = degenerate_elements::keep;  // of surfaces: what happens to triangles without area
  bool split_non_manifold = false;  // of surfaces: edges of more than two polys and verts of several fans are split
                                    // so that each fan has its own
  bool orient = false;              // of surfaces: polys are wound like most of their component, and outward where it
                                    // is closed; a closed component inside another one may stay inward
  std::size_t fill_holes = 0;       // of surfaces: holes of at most this many edges are filled; 0: none
  hole_filling filling = hole_filling::minimal_area;  // how holes are filled; a hole of four edges of a quadmesh by a
                                                      // quad
  intersecting_triangles intersecting = intersecting_triangles::ignore;  // of surfaces: what happens to polys that
                                                                         // intersect others
  bool turn_inverted = true;  // of volumes: cells of negative volume are turned where that fits their neighbours
  bool unite_faces = true;    // of polyhedra: faces with the same verts become one
  concino::progress progress = nullptr;   // called with "repair"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

}  // namespace concino
