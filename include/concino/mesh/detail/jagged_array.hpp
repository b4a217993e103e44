// jagged_array: rows of values in one flat array. `jagged_array<T, N>` has N values per row, `jagged_array<T, 0>` has rows of any lengths. All
// connectivity of the native meshes is stored in these.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/concepts/ranges.hpp>
#include <concino/core/error.hpp>
#include <concino/core/flat_array.hpp>
#include <concino/mesh/detail/alive_elements.hpp>
#include <concino/mesh/detail/equal_rows.hpp>
#include <concino/mesh/detail/offsets.hpp>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace concino::detail {

/// Rows of any lengths. Before the first edit the rows are consecutive ("packed"): row i ends where row i+1 begins, so one array of offsets is
/// enough, and tables whose rows have equal lengths share it. The first edit that changes the length of a row gives every row an end of its
/// own ("loose"). A row that exceeds its capacity moves to the end. Reading is the same in both states: row i is between first_[i] and last_[i],
/// and packed rows have last_ = first_ + 1.
template<class T>
class jagged_array<T, 0> {
  std::shared_ptr<const offsets> packed_;
  offsets loose_first_, loose_last_, room_;
  const std::uint32_t* first_ = nullptr;
  const std::uint32_t* last_ = nullptr;
  std::size_t size_ = 0;
  core::flat_array<T> data_;

  void update_pointers() {
    first_ = packed_ ? packed_->data() : loose_first_.data();
    last_ = packed_ ? packed_->data() + 1 : loose_last_.data();
  }

  void check_index_range(std::size_t more) const {
    if (data_.size() + more > std::numeric_limits<std::uint32_t>::max()) throw unsupported("jagged_array: the mesh has more than 2^32 adjacencies of one kind");
  }

  void reserve_offsets(std::size_t n) {
    make_editable();
    if (std::min({loose_first_.capacity(), loose_last_.capacity(), room_.capacity()}) - size_ >= n) return;
    reserve_more(loose_first_, n), update_pointers();
    reserve_more(loose_last_, n), update_pointers();
    reserve_more(room_, n);
  }

  void move_row(std::size_t i, std::uint32_t room) {
    check_index_range(room);
    const std::size_t n = loose_last_[i] - loose_first_[i];
    const std::size_t from = loose_first_[i], to = data_.size();
    data_.reserve_back(room);
    data_.resize(to + room);
    std::copy_n(data_.data() + from, n, data_.data() + to);
    loose_first_[i] = static_cast<std::uint32_t>(to);
    loose_last_[i] = static_cast<std::uint32_t>(to + n);
    room_[i] = room;
  }

 public:
  jagged_array() = default;
  jagged_array(std::shared_ptr<const offsets> where, std::vector<T> data) : jagged_array(std::move(where), core::flat_array<T>(std::move(data))) {}
  jagged_array(std::shared_ptr<const offsets> where, core::flat_array<T> data) : packed_(std::move(where)), data_(std::move(data)) {
    assert(packed_ && !packed_->empty() && packed_->back() == data_.size());
    size_ = packed_->size() - 1;
    update_pointers();
  }
  jagged_array(const jagged_array& o)
      : packed_(o.packed_), loose_first_(o.loose_first_), loose_last_(o.loose_last_), room_(o.room_), size_(o.size_), data_(o.data_) {
    if (o.first_) update_pointers();
  }
  jagged_array(jagged_array&& o) noexcept { swap(o); }
  jagged_array& operator=(jagged_array o) noexcept {
    swap(o);
    return *this;
  }
  void swap(jagged_array& o) noexcept {
    using std::swap;
    swap(packed_, o.packed_), swap(loose_first_, o.loose_first_), swap(loose_last_, o.loose_last_), swap(room_, o.room_);
    swap(first_, o.first_), swap(last_, o.last_), swap(size_, o.size_), swap(data_, o.data_);
  }

  std::size_t size() const { return size_; }
  /// The position of the first value of row i among all values. It does not change while only commit_row() adds values.
  std::size_t first(std::size_t i) const { return first_[i]; }
  const T* begin(std::size_t i) const { return data_.data() + first_[i]; }
  const T* end(std::size_t i) const { return data_.data() + last_[i]; }
  T* begin(std::size_t i) { return data_.data() + first_[i]; }
  id_span<T> operator[](std::size_t i) const { return {begin(i), end(i)}; }
  std::uint32_t length(std::size_t i) const { return last_[i] - first_[i]; }
  /// The number of values in memory, including those that edits left unused.
  std::size_t num_values() const { return data_.size(); }

  /// Requests the memory that tells where row i is, which will be read soon.
  void prefetch_row(std::size_t i) const {
    __builtin_prefetch(first_ + i);
    __builtin_prefetch(last_ + i);
    if (!packed_) __builtin_prefetch(room_.data() + i);
  }

  /// The offsets, which other tables with rows of the same lengths can share; null after an edit.
  const std::shared_ptr<const offsets>& shared_offsets() const { return packed_; }
  /// Shares the equal offsets of another table, so that they are stored once.
  template<class U>
  void share_offsets(const jagged_array<U, 0>& o) {
    assert(packed_ && o.shared_offsets() && *packed_ == *o.shared_offsets());
    packed_ = o.shared_offsets();
    update_pointers();
  }

  // Edits allocate their memory first, which changes no row, and cannot fail afterwards.

  /// After this call remove() and clear_row() cannot fail.
  void make_editable() {
    if (!packed_) return;
    offsets first(size_), last(size_), room(size_);
    for (std::size_t i = 0; i < size_; ++i) {
      first[i] = first_[i];
      last[i] = last_[i];
      room[i] = last[i] - first[i];
    }
    loose_first_ = std::move(first);
    loose_last_ = std::move(last);
    room_ = std::move(room);
    packed_.reset();
    update_pointers();
  }
  /// After this call, n calls of add_row() with that many values in all cannot fail.
  void reserve_rows(std::size_t n, std::size_t values) {
    reserve_offsets(n);
    check_index_range(values);
    data_.reserve_back(values);
  }
  /// After this call, n calls of push(i) cannot fail. It uses memory that reserve_rows() reserved, so it must come before that.
  void reserve_in_row(std::size_t i, std::uint32_t n) {
    make_editable();
    if (room_[i] - length(i) < n) move_row(i, std::max({std::uint32_t{4}, 2 * room_[i], length(i) + n}));
  }
  /// Writes a row behind the last one; commit_row(), which cannot fail, adds it. The values may be in these rows; if `first` is null, the caller
  /// writes them.
  T* stage_row(const T* first, std::size_t n, std::size_t room = 0) {
    reserve_offsets(1);
    check_index_range(std::max(n, room));
    return data_.stage(first, n, std::max(n, room));
  }
  /// Adds the row that was staged with the same arguments.
  void commit_row(std::size_t n, std::size_t room = 0) {
    room = std::max(n, room);
    const std::size_t at = data_.size();
    loose_first_.push_back(static_cast<std::uint32_t>(at));
    loose_last_.push_back(static_cast<std::uint32_t>(at + n));
    room_.push_back(static_cast<std::uint32_t>(room));
    data_.resize(at + room);
    ++size_;
    update_pointers();
  }

  /// Adds a row with a capacity of at least `room` values.
  template<class It>
  void add_row(It from, It to, std::size_t room = 0) {
    const auto n = static_cast<std::size_t>(to - from);
    stage_row(std::to_address(from), n, room);
    commit_row(n, room);
  }
  void push(std::size_t i, const T& value) {
    const T kept = value;  // a copy: value may be in these rows
    reserve_in_row(i, 1);
    data_[loose_last_[i]++] = kept;
  }
  /// Adds a value to row i, which is sorted and remains so.
  void insert_sorted(std::size_t i, const T& value) {
    push(i, value);
    T* const first = begin(i);
    for (std::size_t k = length(i) - 1; k > 0 && first[k] < first[k - 1]; --k) std::swap(first[k], first[k - 1]);
  }
  /// Removes the value from row i; the others keep their order.
  void remove(std::size_t i, const T& value) {
    make_editable();
    T* const e = data_.data() + loose_last_[i];
    T* at = begin(i);
    while (at != e && !(*at == value)) ++at;
    if (at == e) return;
    for (; at + 1 != e; ++at) *at = at[1];
    --loose_last_[i];
  }
  // After reserve_in_row() these are faster than the functions above.

  /// Adds a value to row i, which has room for it.
  void push_reserved(std::size_t i, const T& value) {
    assert(!packed_ && length(i) < room_[i]);
    data_[loose_last_[i]++] = value;
  }
  /// Removes the k-th value of row i; the last one takes its place.
  void remove_at(std::size_t i, std::size_t k) {
    assert(!packed_ && k < length(i));
    begin(i)[k] = data_[--loose_last_[i]];
  }
  /// The place of a value in row i, which has it.
  std::size_t position(std::size_t i, const T& value) const {
    const T* const row = begin(i);
    std::size_t k = 0;
    while (!(row[k] == value)) ++k;
    return k;
  }
  void clear_row(std::size_t i) {
    make_editable();
    loose_last_[i] = loose_first_[i];
  }
  /// The number of values that resize_row(i, n) needs behind the last row; reserve_rows() reserves them.
  std::uint32_t growth_of_row(std::size_t i, std::size_t n) const {
    const std::uint32_t room = packed_ ? length(i) : room_[i];
    return n <= room ? 0 : std::max({std::uint32_t{4}, 2 * room, static_cast<std::uint32_t>(n)});
  }
  /// Sets the length of row i, whose values the caller then writes. A row that becomes too long moves behind the others.
  void resize_row(std::size_t i, std::size_t n) {
    make_editable();
    if (const std::uint32_t room = growth_of_row(i, n)) move_row(i, room);
    loose_last_[i] = loose_first_[i] + static_cast<std::uint32_t>(n);
  }
  /// Where the values of a row are, for undoing. Only for rows that can be edited; restore_size() also takes the number of all values in memory.
  struct place {
    std::uint32_t first, last, room;
  };
  place place_of(std::size_t i) const { return {first_[i], last_[i], packed_ ? length(i) : room_[i]}; }
  void restore_place(std::size_t i, const place& x) {
    if (!packed_) loose_first_[i] = x.first, loose_last_[i] = x.last, room_[i] = x.room;
  }
  void restore_size(std::size_t rows, std::size_t values) {
    if (packed_) return;
    loose_first_.resize(rows), loose_last_.resize(rows), room_.resize(rows);
    data_.resize(values);
    size_ = rows;
    update_pointers();
  }
};

/// Rows with uninitialised values; lengths[i + 1] is the length of row i, lengths[0] is 0.
template<class T>
jagged_array<T, 0> make_jagged_array(offsets lengths) {
  prefix_sum(lengths);
  auto where = std::make_shared<const offsets>(std::move(lengths));
  core::flat_array<T> data(where->back());
  return {std::move(where), std::move(data)};
}

}  // namespace concino::detail
