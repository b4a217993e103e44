// row_places: where rows of values of any lengths are in a flat array. jagged_array has one such array, incident_lists
// has two or three with rows at the same places.
#pragma once

#include <concino/core/flat_array.hpp>
#include <concino/mesh/detail/rows/offsets.hpp>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

namespace concino::detail {

/// Before the first edit the rows are consecutive ("packed"): row i ends where row i+1 begins, so one array of offsets
/// is enough, and tables whose rows have equal lengths share it. The first edit gives every row an end and a capacity
/// of its own ("editable"), which are beside its beginning, since edits in random order wait for each part of the
/// memory that they use. Reading is the same in both states: row i is between first(i) and last(i), which are one
/// number apart, and those of row i + 1 are 1 or 4 numbers behind them.
///
/// WithSecond: each row has a second one in an array of its own, with another length. Editable rows and their second
/// ones begin at the same place and have the same capacity; packed ones have offsets of their own.
template<bool WithSecond = false>
class row_places {
 public:
  struct editable_row {
    std::uint32_t first, last, room, second_last = 0;  // four numbers, so that no row is on two cache lines
  };

 private:
  struct no_second {};
  struct second_rows {
    std::shared_ptr<const offsets> packed;
    const std::uint32_t* first = nullptr;  // the numbers of row i are at [i << shift_], as those of the first rows
    const std::uint32_t* last = nullptr;
  };
  std::shared_ptr<const offsets> packed_;
  core::flat_array<editable_row> editable_rows_;
  const std::uint32_t* first_ = nullptr;
  std::uint32_t shift_ = 0;  // the number of row i is at first_[i << shift_]
  std::size_t size_ = 0;
  [[no_unique_address]] std::conditional_t<WithSecond, second_rows, no_second> second_;

  void update_pointers() {
    first_ = packed_ ? packed_->data() : reinterpret_cast<const std::uint32_t*>(editable_rows_.data());
    shift_ = packed_ ? 0 : 2;
    if constexpr (WithSecond) {
      second_.first = packed_ ? second_.packed->data() : first_;
      second_.last = second_.first + (packed_ ? 1 : 3);
    }
  }

 public:
  /// Rows that may change get room for a multiple of so many values, and for at least one more than they have.
  static constexpr std::uint32_t room_unit = 8;

  row_places() = default;
  explicit row_places(std::shared_ptr<const offsets> packed)
    requires(!WithSecond)
      : packed_(std::move(packed)), size_(packed_->size() - 1) { update_pointers(); }
  row_places(std::shared_ptr<const offsets> packed, std::shared_ptr<const offsets> second)
    requires WithSecond
      : packed_(std::move(packed)), size_(packed_->size() - 1), second_{std::move(second)} { update_pointers(); }
  row_places(const row_places& o)
      : packed_(o.packed_), editable_rows_(o.editable_rows_), size_(o.size_), second_(o.second_) {
    if (o.first_) update_pointers();
  }
  row_places(row_places&& o) noexcept { swap(o); }
  row_places& operator=(row_places o) noexcept {
    swap(o);
    return *this;
  }
  void swap(row_places& o) noexcept {
    using std::swap;
    swap(packed_, o.packed_), swap(editable_rows_, o.editable_rows_);
    swap(first_, o.first_), swap(shift_, o.shift_), swap(size_, o.size_);
    if constexpr (WithSecond) swap(second_, o.second_);
  }

  std::size_t size() const { return size_; }
  std::uint32_t first(std::size_t i) const { return first_[i << shift_]; }
  std::uint32_t last(std::size_t i) const { return first_[(i << shift_) + 1]; }
  std::uint32_t length(std::size_t i) const { return last(i) - first(i); }
  std::uint32_t second_first(std::size_t i) const { return second_.first[i << shift_]; }
  std::uint32_t second_last(std::size_t i) const { return second_.last[i << shift_]; }
  std::uint32_t second_length(std::size_t i) const { return second_last(i) - second_first(i); }
  /// The length of the longest row at this place.
  std::uint32_t longest(std::size_t i) const {
    if constexpr (WithSecond) return std::max(length(i), second_length(i));
    else return length(i);
  }
  std::uint32_t room(std::size_t i) const { return packed_ ? longest(i) : editable_rows_[i].room; }
  bool is_packed() const { return packed_ != nullptr; }

  const std::shared_ptr<const offsets>& shared_offsets() const { return packed_; }
  const std::shared_ptr<const offsets>& second_shared_offsets() const { return second_.packed; }
  void share_offsets(const std::shared_ptr<const offsets>& equal) {
    assert(packed_ && equal && *packed_ == *equal);
    packed_ = equal;
    update_pointers();
  }

  // Edits allocate their memory first, which changes no row, and cannot fail afterwards.

  /// The same rows, with a capacity of their own, where they are. Needs: no second rows, or with_spare_capacity()
  /// before.
  void make_editable() {
    assert(!WithSecond || !packed_);
    if (packed_) *this = editable([](std::uint32_t n) { return n; });
  }
  /// The same rows with unused memory after each, so that most of them can grow without being moved. Without that if
  /// the values were more than 32 bits can count.
  row_places with_spare_capacity() const {
    std::uint64_t values = 0;
    for (std::size_t i = 0; i < size_; ++i) values += room_for(longest(i) + 1);
    if (values > std::numeric_limits<std::uint32_t>::max()) return editable([](std::uint32_t n) { return n; });
    return editable([](std::uint32_t n) { return room_for(n + 1); });
  }
  static std::uint32_t room_for(std::uint32_t n) { return (n + room_unit - 1) / room_unit * room_unit; }

  /// Copies the values of the same rows at other places to these ones. The room of rows, and what is between them, has
  /// values of none. `to` is empty. It gets capacity for half as much again, so that rows can move to its end: memory
  /// that is not used yet costs nothing, and moving all values to other memory much.
  template<class T>
  void copy_rows(const row_places& before, const core::flat_array<T>& from, core::flat_array<T>& to) const {
    resize_for_rows(to);
    for (std::size_t i = 0; i < size_; ++i)
      std::copy_n(from.data() + before.first(i), before.length(i), to.data() + first(i));
  }
  /// The same for the second rows.
  template<class T>
  void copy_second_rows(const row_places& before, const core::flat_array<T>& from, core::flat_array<T>& to) const {
    resize_for_rows(to);
    for (std::size_t i = 0; i < size_; ++i)
      std::copy_n(from.data() + before.second_first(i), before.second_length(i), to.data() + first(i));
  }

  /// After this call, n calls of add() cannot fail.
  void reserve(std::size_t n) {
    make_editable();
    editable_rows_.reserve_back(n);
    update_pointers();
  }
  void add(std::size_t first, std::size_t length, std::size_t room) {
    const auto at = static_cast<std::uint32_t>(first);
    editable_rows_.push_back({at, static_cast<std::uint32_t>(first + length), static_cast<std::uint32_t>(room), at});
    ++size_;
    update_pointers();
  }
  bool has_room(std::size_t i, std::uint32_t n) const { return !packed_ && editable_rows_[i].room - length(i) >= n; }
  bool has_second_room(std::size_t i, std::uint32_t n) const {
    return !packed_ && editable_rows_[i].room - second_length(i) >= n;
  }
  /// The capacity of an editable row that becomes too long.
  std::uint32_t larger_room(std::size_t i, std::size_t n) const {
    return room_for(std::max(2 * room(i), static_cast<std::uint32_t>(n)));
  }
  void move_row(std::size_t i, std::size_t first, std::uint32_t room) {
    editable_rows_[i] = editable_row_of(i, static_cast<std::uint32_t>(first), room);
  }
  void set_length(std::size_t i, std::size_t n) {
    editable_rows_[i].last = editable_rows_[i].first + static_cast<std::uint32_t>(n);
  }
  void set_second_length(std::size_t i, std::size_t n) {
    editable_rows_[i].second_last = editable_rows_[i].first + static_cast<std::uint32_t>(n);
  }
  /// Where a value is added to row i, which has room for it.
  std::uint32_t extend(std::size_t i) {
    assert(has_room(i, 1));
    return editable_rows_[i].last++;
  }
  /// The same for the second row.
  std::uint32_t extend_second(std::size_t i) {
    assert(has_second_room(i, 1));
    return editable_rows_[i].second_last++;
  }
  /// Where the last value of row i is, which it loses.
  std::uint32_t shorten(std::size_t i) {
    assert(!packed_ && length(i) > 0);
    return --editable_rows_[i].last;
  }

  /// Where the values of a row are, for undoing. A row that was packed then, and was moved since, is not moved back: it
  /// has at least as much room now.
  struct row_extent {
    std::uint32_t first, length, room, second_length;
    bool is_packed;
  };
  row_extent extent_of(std::size_t i) const {
    row_extent x{first(i), length(i), room(i), 0, is_packed()};
    if constexpr (WithSecond) x.second_length = second_length(i);
    return x;
  }
  void restore_extent(std::size_t i, const row_extent& x) {
    if (packed_) return;
    const std::uint32_t first = x.is_packed ? editable_rows_[i].first : x.first;
    editable_rows_[i] = {first, first + x.length, x.is_packed ? editable_rows_[i].room : x.room,
                         first + x.second_length};
  }
  void restore_size(std::size_t rows) {
    if (packed_) return;
    editable_rows_.resize(rows);
    size_ = rows;
    update_pointers();
  }

 private:
  /// Row i of these at another place.
  editable_row editable_row_of(std::size_t i, std::uint32_t first, std::uint32_t room) const {
    if constexpr (WithSecond) return {first, first + length(i), room, first + second_length(i)};
    else return {first, first + length(i), room};
  }
  /// Consecutive rows with the capacity room(length).
  template<class Room>
  row_places editable(const Room& room) const {
    row_places p;
    std::uint32_t at = 0;
    p.editable_rows_.resize(size_);
    for (std::size_t i = 0; i < size_; ++i) {
      p.editable_rows_[i] = editable_row_of(i, at, room(longest(i)));
      at += p.editable_rows_[i].room;
    }
    p.size_ = size_;
    p.update_pointers();
    return p;
  }
  template<class T>
  void resize_for_rows(core::flat_array<T>& to) const {
    const std::size_t end =
        size_ > 0 ? std::size_t{editable_rows_[size_ - 1].first} + editable_rows_[size_ - 1].room : 0;
    to.reserve(end + end / 2);
    to.resize(end);
    std::fill_n(to.data(), end, T{});
  }
};

}  // namespace concino::detail
