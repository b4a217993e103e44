// The edges of a cavity: those of its old and of its new polys, found by the local numbers of their ends.
#pragma once

#include <concino/core/small_array.hpp>
#include <concino/concepts/descriptors.hpp>

#include <cstdint>
#include <cstring>
#include <vector>

namespace concino::detail {

struct cavity_edge {
  unsigned a, b;                 // local numbers of its ends, a < b
  edge_id id;                    // none if the mesh does not have it yet
  std::uint32_t old_polys = 0;   // of the cavity, at it
  std::uint32_t new_polys = 0;
  std::uint32_t num_polys = 0;   // of the mesh, at it before
  cavity_edge* partner = nullptr;  // of a new edge, the old one whose descriptor it takes, and the other way round

  bool is_left_over() const { return !id.is_none() && new_polys == 0 && old_polys == num_polys; }
};

class cavity_edges {
  static constexpr unsigned largest_matrix = 24;  // verts, up to which the number of every edge is in a matrix

  unsigned verts_;
  core::small_array<cavity_edge, 40> edges_;
  unsigned char number_[largest_matrix * largest_matrix];  // of the edge plus 1, if there are few verts
  std::vector<std::uint32_t> slots_;                       // else a hash table of these numbers

  static std::size_t hash(unsigned a, unsigned b) {
    const std::uint64_t x = (std::uint64_t{a} << 32 | b) * 0x9e3779b97f4a7c15u;
    return static_cast<std::size_t>(x >> 32 ^ x);
  }
  std::uint32_t& slot(unsigned a, unsigned b) {
    std::size_t i = hash(a, b) & (slots_.size() - 1);
    while (slots_[i] != 0 && (edges_[slots_[i] - 1].a != a || edges_[slots_[i] - 1].b != b)) i = (i + 1) & (slots_.size() - 1);
    return slots_[i];
  }
  unsigned add(unsigned a, unsigned b) {
    edges_.push_back({a, b, {}});
    return static_cast<unsigned>(edges_.size());
  }

 public:
  /// Room for the edges of `corners` corners on `verts` verts.
  cavity_edges(unsigned verts, std::size_t corners) : verts_(verts) {
    if (verts <= largest_matrix && corners < 255) {
      std::memset(number_, 0, std::size_t{verts} * verts);
    } else {
      std::size_t n = 64;
      while (n < 2 * corners) n *= 2;
      slots_.assign(n, 0);
    }
  }

  /// The edge between two verts; it is added if it is new.
  cavity_edge& at(unsigned a, unsigned b) {
    if (b < a) std::swap(a, b);
    if (!slots_.empty()) {
      std::uint32_t& number = slot(a, b);
      if (number == 0) number = add(a, b);
      return edges_[number - 1];
    }
    unsigned char& number = number_[a * verts_ + b];
    if (number == 0) number = static_cast<unsigned char>(add(a, b));
    return edges_[number - 1u];
  }

  std::size_t size() const { return edges_.size(); }
  cavity_edge* begin() { return edges_.begin(); }
  cavity_edge* end() { return edges_.end(); }
};

}  // namespace concino::detail
