// The log of a repair: elements by kind of change, from which the records and sentences are made.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/repair/repair_result.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace concino::detail {

class repair_log {
  std::vector<std::uint32_t> vert_index_, poly_index_;  // by number of a vert or poly
  std::array<std::vector<std::uint32_t>, num_repair_kinds> elements_;
  std::vector<repair_record> single_;

 public:
  /// The indices in the mesh before of the verts and polys, which are numbered without gaps here.
  repair_log(std::vector<std::uint32_t> vert_index, std::vector<std::uint32_t> poly_index)
      : vert_index_(std::move(vert_index)), poly_index_(std::move(poly_index)) {}

  const std::vector<std::uint32_t>& vert_index() const { return vert_index_; }
  const std::vector<std::uint32_t>& poly_index() const { return poly_index_; }
  std::vector<std::uint32_t>& of(repair_kind kind) { return elements_[static_cast<std::size_t>(kind)]; }
  void add(repair_kind kind, std::uint32_t number) { of(kind).push_back(number); }
  /// A record of its own, of a poly; the sentence has indices.
  void add_single(repair_kind kind, std::uint32_t number, std::string what) {
    single_.push_back({kind, {number}, std::move(what)});
  }
  bool has_changes() const {
    for (std::size_t k = 0; k < num_repair_kinds; ++k)
      if (!elements_[k].empty() && !is_left(static_cast<repair_kind>(k))) return true;
    return false;
  }
  /// Moves the records and sentences to the result; numbers become indices.
  void write(repair_result& to);
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/repair/detail/repair_log.ipp>
#endif
