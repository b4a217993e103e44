// row_places: where rows of values of any lengths are in a flat array. jagged_array has one such array, incident_edges has two with rows at the same places.
#pragma once

#include <concino/core/flat_array.hpp>
#include <concino/mesh/detail/offsets.hpp>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

namespace concino::detail {

/// Before the first edit the rows are consecutive ("packed"): row i ends where row i+1 begins, so one array of offsets is enough, and tables whose rows have
/// equal lengths share it. The first edit gives every row an end and a capacity of its own ("loose"). Reading is the same in both states: row i is
/// between first(i) and last(i), and packed rows have last_ = first_ + 1.
class row_places {
  std::shared_ptr<const offsets> packed_;
  core::flat_array<std::uint32_t> loose_first_, loose_last_, room_;
  const std::uint32_t* first_ = nullptr;
  const std::uint32_t* last_ = nullptr;
  std::size_t size_ = 0;

  void update_pointers() {
    first_ = packed_ ? packed_->data() : loose_first_.data();
    last_ = packed_ ? packed_->data() + 1 : loose_last_.data();
  }

 public:
  /// Rows that may change get room for a multiple of so many values, and for at least one more than they have.
  static constexpr std::uint32_t room_unit = 8;

  row_places() = default;
  explicit row_places(std::shared_ptr<const offsets> packed) : packed_(std::move(packed)), size_(packed_->size() - 1) { update_pointers(); }
  row_places(const row_places& o) : packed_(o.packed_), loose_first_(o.loose_first_), loose_last_(o.loose_last_), room_(o.room_), size_(o.size_) {
    if (o.first_) update_pointers();
  }
  row_places(row_places&& o) noexcept { swap(o); }
  row_places& operator=(row_places o) noexcept {
    swap(o);
    return *this;
  }
  void swap(row_places& o) noexcept {
    using std::swap;
    swap(packed_, o.packed_), swap(loose_first_, o.loose_first_), swap(loose_last_, o.loose_last_), swap(room_, o.room_);
    swap(first_, o.first_), swap(last_, o.last_), swap(size_, o.size_);
  }

  std::size_t size() const { return size_; }
  std::uint32_t first(std::size_t i) const { return first_[i]; }
  std::uint32_t last(std::size_t i) const { return last_[i]; }
  std::uint32_t length(std::size_t i) const { return last_[i] - first_[i]; }
  std::uint32_t room(std::size_t i) const { return packed_ ? length(i) : room_[i]; }
  bool is_packed() const { return packed_ != nullptr; }

  const std::shared_ptr<const offsets>& shared_offsets() const { return packed_; }
  void share_offsets(const std::shared_ptr<const offsets>& equal) {
    assert(packed_ && equal && *packed_ == *equal);
    packed_ = equal;
    update_pointers();
  }

  void prefetch(std::size_t i) const {
    __builtin_prefetch(first_ + i);
    __builtin_prefetch(last_ + i);
    if (!packed_) __builtin_prefetch(room_.data() + i);
  }

  // Edits allocate their memory first, which changes no row, and cannot fail afterwards.

  /// The same rows, with a capacity of their own, where they are.
  void make_loose() {
    if (packed_) *this = loose([](std::uint32_t n) { return n; });
  }
  /// The same rows, apart from each other, so that most of them can grow where they are. Packed rows if the places were more than 32 bits can count.
  row_places spread() const {
    std::uint64_t values = 0;
    for (std::size_t i = 0; i < size_; ++i) values += room_for(length(i) + 1);
    if (values > std::numeric_limits<std::uint32_t>::max()) return loose([](std::uint32_t n) { return n; });
    return loose([](std::uint32_t n) { return room_for(n + 1); });
  }
  static std::uint32_t room_for(std::uint32_t n) { return (n + room_unit - 1) / room_unit * room_unit; }
  /// Where the last row ends that loose() has made.
  std::size_t end_of_values() const { return size_ == 0 ? 0 : std::size_t{loose_first_[size_ - 1]} + room_[size_ - 1]; }

  /// After this call, n calls of add() cannot fail.
  void reserve(std::size_t n) {
    make_loose();
    loose_first_.reserve_back(n), update_pointers();
    loose_last_.reserve_back(n), update_pointers();
    room_.reserve_back(n);
  }
  void add(std::size_t first, std::size_t length, std::size_t room) {
    loose_first_.push_back(static_cast<std::uint32_t>(first));
    loose_last_.push_back(static_cast<std::uint32_t>(first + length));
    room_.push_back(static_cast<std::uint32_t>(room));
    ++size_;
    update_pointers();
  }
  bool has_room(std::size_t i, std::uint32_t n) const { return !packed_ && room_[i] - length(i) >= n; }
  /// The capacity of a loose row that becomes too long.
  std::uint32_t larger_room(std::size_t i, std::size_t n) const { return std::max({std::uint32_t{4}, 2 * room(i), static_cast<std::uint32_t>(n)}); }
  void move_row(std::size_t i, std::size_t first, std::uint32_t room) {
    const std::uint32_t n = length(i);
    loose_first_[i] = static_cast<std::uint32_t>(first), loose_last_[i] = loose_first_[i] + n, room_[i] = room;
  }
  void set_length(std::size_t i, std::size_t n) { loose_last_[i] = loose_first_[i] + static_cast<std::uint32_t>(n); }
  /// Where a value is added to row i, which has room for it.
  std::uint32_t extend(std::size_t i) {
    assert(has_room(i, 1));
    return loose_last_[i]++;
  }
  /// Where the last value of row i is, which it loses.
  std::uint32_t shorten(std::size_t i) {
    assert(!packed_ && length(i) > 0);
    return --loose_last_[i];
  }

  /// Where the values of a row are, for undoing. A row that was packed remains where it was moved since, where it has at least as much room.
  struct place {
    std::uint32_t first, last, room;
    bool is_packed;
  };
  place place_of(std::size_t i) const { return {first_[i], last_[i], room(i), is_packed()}; }
  void restore_place(std::size_t i, const place& x) {
    if (packed_) return;
    if (x.is_packed) set_length(i, x.last - x.first);
    else loose_first_[i] = x.first, loose_last_[i] = x.last, room_[i] = x.room;
  }
  void restore_size(std::size_t rows) {
    if (packed_) return;
    loose_first_.resize(rows), loose_last_.resize(rows), room_.resize(rows);
    size_ = rows;
    update_pointers();
  }

 private:
  /// Consecutive rows with the capacity room(length).
  template<class Room>
  row_places loose(const Room& room) const {
    row_places p;
    p.loose_first_.resize(size_), p.loose_last_.resize(size_), p.room_.resize(size_);
    std::uint32_t at = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      p.loose_first_[i] = at;
      p.loose_last_[i] = at + length(i);
      p.room_[i] = room(length(i));
      at += p.room_[i];
    }
    p.size_ = size_;
    p.update_pointers();
    return p;
  }
};

}  // namespace concino::detail
