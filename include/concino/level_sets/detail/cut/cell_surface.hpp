// The surface of a cell: which facets meet at each edge, and whether it is a sphere.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/index_table.hpp>
#include <concino/graph/disjoint_sets.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Reads the facets of one cell after another and reuses its memory. Edges are known by their verts.
class cell_surface {
  static constexpr std::uint32_t none = ~0u;
  static constexpr std::size_t few = 7;  // facets: two closed surfaces have more

  std::vector<std::uint32_t> verts_;     // by corner
  std::vector<std::uint32_t> ends_;      // by facet: where its corners end
  std::vector<unsigned char> outward_;   // by facet
  std::vector<std::uint64_t> edges_;     // by corner: the two verts of the edge to the next corner, the smaller one
                                         // first
  std::vector<std::uint32_t> facets_;     // by corner
  std::vector<std::uint32_t> mates_;
  core::index_table first_at_;           // of each edge, the first corner
  disjoint_sets pieces_;

 public:
  void clear() { verts_.clear(), ends_.clear(), outward_.clear(); }
  void add_corner(std::uint32_t vert) { verts_.push_back(vert); }
  void end_facet(bool is_outward) {
    ends_.push_back(static_cast<std::uint32_t>(verts_.size()));
    outward_.push_back(is_outward);
  }

  /// Whether each edge is used twice, in opposite directions if facets are seen from outside. Then mates() has the
  /// other use of each edge.
  bool find_mates();
  const std::vector<std::uint32_t>& mates() const { return mates_; }

  /// Whether the facets form one closed oriented surface without handles that does not touch itself, after find_mates()
  /// was true.
  bool is_sphere(std::size_t num_verts);

 private:
  bool are_connected();
  void list_edges();
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/cut/cell_surface.ipp>
#endif
