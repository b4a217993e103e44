// Reads the polys of any volume that a level set cuts in two parts, on two threads.
#pragma once

#include <concino/core/large_pages.hpp>
#include <concino/core/parallel.hpp>
#include <concino/core/temporary_array.hpp>
#include <concino/level_sets/detail/simple_cell_reader.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace concino::detail {

/// What a simple_cell_reader of all polys finds. Of many polys, two readers each read some, and what the second one has found is added to the first one.
template<class M>
class parallel_cell_reader {
  static constexpr std::size_t min_polys = 4000;  // for two readers: one needs a microsecond for each poly

  const M& m_;
  const unsigned char* vert_states_;
  std::uint32_t* number_of_face_;
  core::temporary_array<std::uint32_t> numbers_of_second_;  // number_of_face of second_
  std::optional<simple_cell_reader<M>> first_, second_;
  std::span<const poly_t<M>> polys_of_second_;
  std::vector<std::uint32_t> places_of_second_;  // by place of second_: its number in `places`

 public:
  /// number_of_face: see simple_cells.
  parallel_cell_reader(const M& m, const unsigned char* vert_states, std::uint32_t* number_of_face)
      : m_(m), vert_states_(vert_states), number_of_face_(number_of_face) {}

  /// As simple_cell_reader::read().
  template<class U>
  bool read(const U& u, std::span<const poly_t<M>> polys, const unsigned char* poly_states) {
    const auto read_all = [&] { return first_.emplace(m_, vert_states_, number_of_face_).read(u, polys, poly_states); };
    if (polys.size() < min_polys || core::num_threads() == 1) return read_all();
    const std::size_t half = polys.size() / 16 * 9;  // the second reader needs a new array of all faces
    bool is_first_read = false, is_second_read = false;
    const auto read_first = [&] {
      first_.emplace(m_, vert_states_, number_of_face_);
      first_->cells.reserve(polys.size());
      is_first_read = first_->read(u, polys.first(half), poly_states);
    };
    const auto read_second = [&] {
      numbers_of_second_ = core::temporary_array<std::uint32_t>(face_index_bound(m_), ~0u);
      is_second_read = second_.emplace(m_, vert_states_, numbers_of_second_.data()).read(u, polys.subspan(half), poly_states);
    };
    core::run_both(true, read_first, read_second);
    if (is_first_read && is_second_read) {
      polys_of_second_ = polys.subspan(half);
      return true;
    }
    second_.reset();
    return read_all();  // few of all polys may be difficult
  }

  /// Adds what the second reader has found, after read(). Returns false if one of the polys is unusual; the arrays are of no use then.
  bool join() {
    if (!second_) return true;
    join_places();
    for (const std::uint32_t c : first_->cells.append(second_->cells, places_of_second_))
      for (const face_t<M> f : adj_p2f(m_, polys_of_second_[c]))
        if (num_elements(adj_f2p(m_, f)) > 2) return false;
    return !first_->cells.has_equal_faces();
  }

  simple_cells& cells() { return first_->cells; }
  std::vector<level_place>& places() { return first_->places; }
  place_ends& ends() { return first_->ends; }

  /// The number of the place on an edge, or none.
  std::uint32_t place_on_edge(std::uint32_t index) const {
    if (const std::uint32_t x = first_->place_on_edge(index); x != ~0u || !second_) return x;
    const std::uint32_t x = second_->place_on_edge(index);
    return x == ~0u ? x : places_of_second_[x];
  }

 private:
  void join_places() {
    const place_ends& from = second_->ends;
    place_ends& to = first_->ends;
    const std::size_t n = second_->places.size();
    core::reserve_pages(places_of_second_, n);
    for (const level_place& x : second_->places) {
      std::uint32_t number = first_->place_on_edge(x.element);
      if (number == ~0u) {
        number = static_cast<std::uint32_t>(first_->places.size());
        const auto first = static_cast<std::uint32_t>(to.points.size());
        first_->places.push_back({x.kind, x.element, first, first + 1});
        for (const std::uint32_t end : {x.below, x.above}) {
          to.vert_indices.push_back(from.vert_indices[end]);
          to.points.push_back(from.points[end]);
          to.values.push_back(from.values[end]);
        }
      }
      places_of_second_.push_back(number);
    }
  }
};

}  // namespace concino::detail
