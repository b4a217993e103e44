// What tetrahedralize() can be asked for, and what passes between it and its back ends.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/core/function_ref.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/core/vec3.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace concino {

/// A part of the enclosed volume, bounded by polys of the surface and by facets.
struct tet_region {
  vec3 inside;             // any point of it
  std::uint32_t label = 0; // given to its tets
  double max_volume = 0;   // of a tet; 0: no limit of its own
};

/// Points are numbered for segments and facets: first the verts of the surface, in the order of verts(m), then the
/// extra points.
struct tetrahedralize_options {
  double radius_edge = 0;       // largest ratio of the radius of the circumsphere of a tet to its shortest edge, 1 or
                                // more; 0: any
  double min_dihedral_deg = 0;  // smallest dihedral angle of a tet, in degrees, below 70; 0: any
  double max_volume = 0;        // of a tet; 0: any
  function_ref<double(const vec3&)> edge_length = nullptr;  // the longest edge of a tet with its centroid there, above
                                                            // 0; a back end may call it in another process
  bool keep_boundary = true;    // the boundary of the result is the surface itself; false: it may get more verts, for
                                // better and smaller tets
  std::span<const vec3> extra_points = {};                                  // further verts
  std::span<const std::array<std::uint32_t, 2>> segments = {};              // pairs of points that edges join
  std::span<const std::array<std::uint32_t, 3>> facets = {};                // triangles inside that are unions of faces
  std::span<const vec3> holes = {};                                         // points of parts that are left empty
  std::span<const tet_region> regions = {};                                 // parts with labels
  bool in_process = false;      // false: a back end that may crash runs in a child process where the system is Linux
  double max_seconds = 600;     // of a child process, which is ended then
  std::size_t max_bytes = 0;    // of memory that a child process may take; 0: any
  concino::progress progress = nullptr;  // called with 0, 1 and, while a child process runs, something between
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// What was noticed. Polys and tets that have no place in the promise of the call are listed here.
struct tetrahedralize_report {
  std::vector<std::uint32_t> not_planar;   // polys of the surface, by index, that are not planar: it was cut into
                                           // triangles there
  std::vector<poly_id> beyond_radius_edge; // tets that miss what was asked for
  std::vector<poly_id> beyond_min_dihedral;
  std::vector<poly_id> beyond_edge_length;
  std::vector<poly_id> beyond_max_volume;  // that of their region included
  std::string not_met = {};        // one sentence that says how many tets miss what, and which option helps; empty if
                                   // none does
  double seconds_of_check = 0;     // of the surface, before the back end ran
  double seconds_of_back_end = 0;
  double seconds_of_verification = 0;  // of the tets
};

/// What a back end gets: a closed surface of triangles without intersections, counter-clockwise seen from outside or,
/// all of them, from inside.
struct tetrahedralize_input {
  std::vector<vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // of the surface, then the facets inside
  std::size_t surface_triangles = 0;
  std::vector<std::array<std::uint32_t, 2>> segments;
  double diagonal = 0;  // of the box around all points
};

/// What a back end returns. It fills the hull of the surface up to the outermost triangles; holes are removed
/// afterwards.
struct tetrahedralize_output {
  std::vector<vec3> points;                               // those of the input first
  std::vector<std::array<std::uint32_t, 4>> tets;         // of either orientation
  std::vector<std::array<std::uint32_t, 3>> facets;       // the faces into which the triangles were divided, each once
  std::vector<std::uint32_t> triangle_of_facet;           // the triangle of the input that each lies in
};

namespace requirement {

/// A back end of tetrahedralize(): name() is used in messages. One that approximates the surface has also `double
/// surface_distance(double diagonal) const`, which says how far the boundary of the tets may be off, given the diagonal
/// of the box of the surface; its output may have any points, and needs no facets.
template<class B>
concept is_tet_back_end = requires(const B& b, const tetrahedralize_input& in, const tetrahedralize_options& o) {
  { b.tetrahedralize(in, o) } -> std::same_as<tetrahedralize_output>;
  { b.name() } -> std::convertible_to<const char*>;
};

template<class B> concept approximates_surface = is_tet_back_end<B> && requires(const B& b) {
  { b.surface_distance(1.0) } -> std::convertible_to<double>;
};

}  // namespace requirement

}  // namespace concino
