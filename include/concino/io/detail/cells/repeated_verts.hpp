// Polys with a vert twice: what load_options::repeated_verts makes of them.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/message.hpp>
#include <concino/io/detail/cells/corners.hpp>
#include <concino/io/options.hpp>
#include <concino/mesh/arrays.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace concino {

namespace detail {

/// Ends what readers say that they expect instead of a vert twice.
inline constexpr const char* repeated_verts_hint = " (or set options.repeated_verts)";

/// Removes corners from a cycle of verts until no two neighbours are equal, and no vert lies between two equal ones.
class cycle_collapser {
  std::vector<std::uint32_t> kept_;

 public:
  /// Result: the positions of the corners that stay, in order; fewer than three if nothing stays.      Cost: O(n).
  std::span<const std::uint32_t> operator()(const vert_id* v, std::size_t n);
};

/// Collapses a cycle in place. Result: its length; n if nothing stays, so that it is still no element of a mesh.
std::uint32_t collapse_verts(vert_id* v, std::uint32_t n);

/// The polys with a vert twice that a reader has found. A reader that does not refuse them leaves those of surfaces as
/// they are.
class polys_with_repeats {
  std::size_t num_ = 0, num_vanished_ = 0;
  std::string first_;
  cycle_collapser collapse_;

 public:
  concino::repeated_verts policy = concino::repeated_verts::refuse;
  std::vector<std::uint32_t> dropped;  // polys of a volume that have become none, by their numbers in the file, in
                                       // order
  std::size_t num_cut = 0;             // polygons that became triangles

  bool empty() const { return num_ == 0; }
  /// Adds a poly by its number in the file. place() says where in the file it is, or returns an empty text.
  template<class Place>
  void add(std::size_t poly, const Place& place) {
    if (num_++ > 0) return;
    const std::string where = place();
    first_ = core::joined({"poly ", poly, " of the file", where.empty() ? "" : ", ", where});
  }
  void add_vanished() { ++num_vanished_; }

  /// The number of verts of what will become of a polygon: 0 for nothing, 3 for triangles.
  std::size_t size_after(const vert_id* v, std::size_t n);

  void report(load_report& r) const;
};

/// Triangulates a polygon that passes a vert twice. Triangles with a vert twice are left out.
/// Result: the verts of the triangles, three each. They do not depend on where the cycle begins, and are the same,
///         reversed, for the reversed cycle.
std::vector<vert_id> cut_cycle(std::vector<vert_id> cycle, std::span<const vec3> points);

/// Collapses the faces of one polyhedron: the number of faces, and for each the number of its verts and these.
/// Result: the same of what stays; 0 faces if fewer than four do.
std::vector<vert_id> collapsed_faces(const vert_id* list, std::span<const vec3> points);
/// Whether a face of a polyhedron has a vert twice.
bool has_repeated_vert(const vert_id* list, std::vector<std::uint64_t>& scratch);

}  // namespace detail

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/io/detail/cells/repeated_verts.ipp>
#endif
