// The edges of a cavity: those of its old and of its new polys, found by the local numbers of their ends.
#pragma once

#include <concino/core/index_table.hpp>
#include <concino/core/small_array.hpp>
#include <concino/concepts/descriptors.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace concino::detail {

struct cavity_edge {
  unsigned a, b;                 // local numbers of its ends, a < b
  edge_id id;                    // none if the mesh does not have it yet
  std::uint32_t old_polys = 0;   // of the cavity, at it
  std::uint32_t new_polys = 0;
  std::uint32_t num_polys = 0;   // of the mesh, at it before
  std::uint32_t partner = ~0u;   // the number, of a new edge, of the old one whose descriptor it takes, and the other
                                 // way round
  poly_id first_poly{};          // of a surface, before: the first one of two; none if it has not two
  std::uint32_t first_new = ~0u;  // the place of the edge in the first new poly, if new_polys > 0

  bool has_partner() const { return partner != ~0u; }
  bool is_unused() const { return !id.is_none() && new_polys == 0 && old_polys == num_polys; }
  bool shares_all_but_one(const cavity_edge& x) const { return a == x.a || a == x.b || b == x.a || b == x.b; }
};

/// The edges of a cavity by the local numbers of their ends. A pointer to one is valid until the next is added.
class cavity_edges {
  core::small_array<cavity_edge, 80> edges_;
  core::index_table numbers_;

 public:
  /// Room for the edges of old and new polys that have `uses` edges in all.
  explicit cavity_edges(std::size_t uses) { edges_.reserve(uses / 3); }

  /// The number of the edge between two verts; it is added if it is new.
  unsigned number(unsigned a, unsigned b) {
    if (b < a) std::swap(a, b);
    const std::uint32_t hash = core::index_table::hash(std::uint64_t{a} << 32 | b);
    const std::uint32_t known =
        numbers_.find(hash, [&](std::uint32_t i) { return edges_[i].a == a && edges_[i].b == b; });
    if (known != core::index_table::none) return known;
    const auto fresh = static_cast<unsigned>(edges_.size());
    edges_.push_back({a, b, {}});
    numbers_.add(hash, fresh);
    return fresh;
  }
  cavity_edge& at(unsigned a, unsigned b) { return edges_[number(a, b)]; }

  std::size_t size() const { return edges_.size(); }
  std::size_t capacity() const { return edges_.capacity(); }
  unsigned number(const cavity_edge& x) const { return static_cast<unsigned>(&x - edges_.begin()); }
  cavity_edge& operator[](unsigned i) { return edges_[i]; }
  const cavity_edge& operator[](unsigned i) const { return edges_[i]; }
  cavity_edge* begin() { return edges_.begin(); }
  cavity_edge* end() { return edges_.end(); }
  const cavity_edge* begin() const { return edges_.begin(); }
  const cavity_edge* end() const { return edges_.end(); }
};

}  // namespace concino::detail
