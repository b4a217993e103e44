// The polys of a surface as flat arrays, and those of a disk with its boundary loop.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Corner c is one of vert corners[c]; those of poly p are numbered from first[p] to first[p + 1].
struct flat_polys {
  std::vector<vec3> points;                            // in units of 2^exponent, so that the surface has a size of 1
  std::vector<std::uint32_t> first{0}, corners;
  std::vector<std::uint32_t> vert_index, poly_index;   // in the mesh, for messages
  int exponent = 0;

  std::size_t num_polys() const { return first.size() - 1; }
};

/// A surface that is a disk.
struct flat_disk : flat_polys {
  std::vector<std::uint32_t> loop;                   // the verts of the boundary, with the surface on their left
  std::vector<std::array<std::uint32_t, 2>> edges;   // each once, smaller vert first, sorted
  std::vector<std::uint32_t> other_poly;             // by corner, of the edge that begins there; no_poly: boundary

  static constexpr std::uint32_t no_poly = static_cast<std::uint32_t>(-1);
};

/// Scales the points.      Errors: invalid_mesh if there are no polys, or a point is not finite.
void scale_polys(flat_polys& f, const char* caller);

/// Finds the loop and the edges, and scales the points.
/// Errors: invalid_mesh if the surface is no disk, which says why and what to do.
void make_disk(flat_disk& f, const char* caller);

/// The place in the loop of the vert that is farthest from the centre of the boundary.
std::size_t farthest_in_loop(const flat_disk& f);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/parametrize/detail/flat_polys.ipp>
#endif
