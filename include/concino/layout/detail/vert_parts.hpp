// The two parts into which marked facets divide the polys at one of their verts.
#pragma once

#include <concino/graph/disjoint_sets.hpp>
#include <concino/layout/detail/cell_patch.hpp>

#include <array>
#include <utility>
#include <vector>

namespace concino::detail {

/// A patch with some of its facets marked, and how many of them are at each ridge and edge.
struct marked_patch {
  const cube_tables& t;
  const boundary_flags& boundary;
  const std::vector<vec3>& points;
  std::vector<unsigned char> is_marked;      // by facet
  std::vector<std::uint32_t> num_marked_at;  // by ridge
  poly_incidence at_verts;                   // of corners

  /// Whether an edge belongs to a marked facet.
  bool has_mark(std::uint32_t edge) const { return t.dimension == 2 ? is_marked[edge] != 0 : num_marked_at[edge] > 0; }
};

/// The polys at a vert, and the places outside of the mesh beyond facets at the boundary, in two parts.
class vert_parts {
  const marked_patch& m_;
  const std::uint32_t v_;
  disjoint_sets nodes_;                                                   // first polys, then places beyond facets
  std::vector<std::uint32_t> root_;                                       // of these, once all are united
  std::vector<std::pair<std::uint32_t, std::uint32_t>> facets_, beyond_;  // facets and polys; facets and places

  std::uint32_t corner(std::uint32_t n) const { return m_.at_verts.entry(v_, n); }
  void find_facets();
  void unite_through_facets();
  void unite_outside();
  vec3 inward(const std::vector<std::uint32_t>& polys, bool at_boundary) const;

 public:
  bool are_two = false;                          // and each marked facet has one on each side
  bool has_polys[2] = {}, has_boundary[2] = {};  // polys, and facets at the boundary that are not marked

  vert_parts(const marked_patch& m, std::uint32_t v);
  std::uint32_t num_polys() const { return static_cast<std::uint32_t>(m_.at_verts.count(v_)); }
  /// The part of the n-th poly at the vert: 0 or 1.
  unsigned part(std::uint32_t n) const { return root_[n] == root_[0] ? 0 : 1; }
  /// From the vert into a part: as long as its polys are thick there; along the boundary if it has some.
  vec3 into(unsigned part) const;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/layout/detail/vert_parts.ipp>
#endif
