// The edges of a cavity: those of its old and of its new polys, found by the local numbers of their ends.
#pragma once

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
  std::uint32_t partner = ~0u;   // the number, of a new edge, of the old one whose descriptor it takes, and the other way round
  poly_id first_poly{};          // of a surface, before: the first one of two; none if it has not two
  std::uint32_t first_new = ~0u;  // the place of the edge in the first new poly, if new_polys > 0

  bool has_partner() const { return partner != ~0u; }
  bool is_left_over() const { return !id.is_none() && new_polys == 0 && old_polys == num_polys; }
  bool shares_all_but_one(const cavity_edge& x) const { return a == x.a || a == x.b || b == x.a || b == x.b; }
};

/// The edges of a cavity by the local numbers of their ends. A pointer to one is valid until the next is added.
class cavity_edges {
 public:
  static constexpr unsigned largest_matrix = 24;  // verts, up to which the number of every edge is in a matrix; else the numbers are in a hash table

 private:
  unsigned verts_;
  core::small_array<cavity_edge, 80> edges_;
  core::small_array<std::uint32_t, largest_matrix * largest_matrix> numbers_;  // of edges plus 1

  /// Where the search in the hash table starts.
  std::size_t first_slot(unsigned a, unsigned b) const {
    const std::uint64_t hash = (std::uint64_t{a} << 32 | b) * 0x9e3779b97f4a7c15u;
    return static_cast<std::size_t>(hash >> 32 ^ hash) & (numbers_.size() - 1);
  }
  void enlarge_table() {
    const std::size_t n = 2 * numbers_.size();
    numbers_.clear(), numbers_.resize(n, 0);
    for (std::uint32_t i = 0; i < edges_.size(); ++i) number_at(edges_[i].a, edges_[i].b) = i + 1;
  }
  std::uint32_t& number_at(unsigned a, unsigned b) {
    if (verts_ <= largest_matrix) return numbers_[a * verts_ + b];
    std::size_t i = first_slot(a, b);
    while (numbers_[i] != 0 && (edges_[numbers_[i] - 1].a != a || edges_[numbers_[i] - 1].b != b)) i = (i + 1) & (numbers_.size() - 1);
    return numbers_[i];
  }

 public:
  /// Room for the edges of old and new polys that have `uses` edges in all, on `verts` verts.
  cavity_edges(unsigned verts, std::size_t uses) : verts_(verts) {
    std::size_t n = 64;
    if (verts > largest_matrix)
      while (n < uses / 2) n *= 2;  // in large cavities, most edges have more polys
    numbers_.resize(verts > largest_matrix ? n : std::size_t{verts} * verts, 0);
    edges_.reserve(uses / 3);
  }

  /// The number of the edge between two verts; it is added if it is new.
  unsigned number(unsigned a, unsigned b) {
    if (b < a) std::swap(a, b);
    std::uint32_t* plus_one = &number_at(a, b);
    if (*plus_one == 0) {
      if (verts_ > largest_matrix && 2 * edges_.size() >= numbers_.size()) enlarge_table(), plus_one = &number_at(a, b);
      edges_.push_back({a, b, {}});
      *plus_one = static_cast<std::uint32_t>(edges_.size());
    }
    return *plus_one - 1;
  }
  /// Adds an edge that has got its number elsewhere; number() does not find it.
  void add(unsigned a, unsigned b) { edges_.push_back({std::min(a, b), std::max(a, b), {}}); }
  void reserve(std::size_t n) { edges_.reserve(n); }
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
