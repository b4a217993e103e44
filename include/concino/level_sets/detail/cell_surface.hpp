// The surface of a cell: which facets meet at each edge, and whether it is a sphere.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/graph/disjoint_sets.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// The surface of a cell with few facets: a sum of hashes of edges, with the signs of their directions. If it is 0 and there are twice as many corners as
/// edges, each edge is used once in each direction.
class few_facets {
  std::uint64_t sum_ = 0;
  std::size_t num_corners_ = 0, num_facets_ = 0;

 public:
  static constexpr std::size_t max_size = 7;

  void add_facet(std::span<const std::uint32_t> corners, bool is_outward) {
    std::uint64_t of_facet = 0, a = corners.back();
    for (const std::uint64_t b : corners) {
      const std::uint64_t hash = ((a < b ? a << 32 | b : b << 32 | a) + 1) * 0x9e3779b97f4a7c15u, mixed = (hash ^ hash >> 31) * 0xbf58476d1ce4e5b9u;
      of_facet += a < b ? mixed : std::uint64_t{0} - mixed;
      a = b;
    }
    sum_ += is_outward ? of_facet : std::uint64_t{0} - of_facet;
    num_corners_ += corners.size(), ++num_facets_;
  }
  /// As cell_surface::is_sphere().
  bool is_sphere(std::size_t num_verts, std::size_t num_edges) const {
    return num_corners_ == 2 * num_edges && num_verts + num_facets_ == num_edges + 2 && sum_ == 0;
  }
};

/// Reads the facets of one cell after another and reuses its memory. Edges are known by their verts.
class cell_surface {
  static constexpr std::uint32_t none = ~0u;

  std::vector<std::uint32_t> verts_;     // by corner
  std::vector<std::uint32_t> ends_;      // by facet: where its corners end
  std::vector<unsigned char> outward_;   // by facet
  std::vector<std::uint64_t> edges_;     // by corner: the two verts of the edge to the next corner, the smaller one first
  std::vector<std::uint32_t> facets_;     // by corner
  std::vector<std::uint32_t> mates_, slots_;
  disjoint_sets pieces_;

 public:
  void clear() { verts_.clear(), ends_.clear(), outward_.clear(); }
  void add_corner(std::uint32_t vert) { verts_.push_back(vert); }
  void end_facet(bool is_outward) {
    ends_.push_back(static_cast<std::uint32_t>(verts_.size()));
    outward_.push_back(is_outward);
  }
  void add_facet(std::span<const std::uint32_t> corners, bool is_outward) {
    verts_.insert(verts_.end(), corners.begin(), corners.end());
    end_facet(is_outward);
  }

  /// The n corners that were added last.
  const std::uint32_t* last_corners(std::size_t n) const { return verts_.data() + (verts_.size() - n); }

  /// Whether each edge is used twice, in opposite directions if facets are seen from outside. Then mates() has the other use of each edge.
  bool find_mates();
  const std::vector<std::uint32_t>& mates() const { return mates_; }

  /// Whether the facets form one closed oriented surface without handles that does not touch itself, after find_mates() was true.
  bool is_sphere(std::size_t num_verts);
  /// The same without find_mates(), if the number of edges is known.
  bool is_sphere(std::size_t num_verts, std::size_t num_edges);

 private:
  bool are_connected();
  std::uint32_t& slot_of(std::uint32_t corner);
  void clear_slots();
  void list_edges();
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/cell_surface.ipp>
#endif
