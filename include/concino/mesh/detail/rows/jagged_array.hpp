// jagged_array: rows of values in one flat array. `jagged_array<T, N>` has N values per row, `jagged_array<T, 0>` has
// rows of any lengths. All connectivity of the native meshes is stored in these.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/concepts/ranges.hpp>
#include <concino/core/error.hpp>
#include <concino/core/flat_array.hpp>
#include <concino/mesh/detail/rows/equal_rows.hpp>
#include <concino/mesh/detail/rows/row_places.hpp>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace concino::detail {

/// Rows of any lengths, packed before the first edit and editable afterwards (row_places.hpp). A row that exceeds its
/// capacity moves to the end.
template<class T>
class jagged_array<T, 0> {
  row_places<> places_;
  core::flat_array<T> data_;

  void check_index_range(std::size_t more) const {
    if (data_.size() + more > std::numeric_limits<std::uint32_t>::max())
      throw unsupported("jagged_array: the mesh has more than 2^32 adjacencies of one kind");
  }

  void move_row(std::size_t i, std::uint32_t room) {
    check_index_range(room);
    const std::size_t from = places_.first(i), to = data_.size();
    data_.reserve_back(room);
    data_.resize(to + room);
    const std::uint32_t n = places_.length(i);
    std::copy_n(data_.data() + from, n, data_.data() + to);
    std::fill_n(data_.data() + to + n, room - n, T{});
    places_.move_row(i, to, room);
  }
  void add_spare_capacity() {
    row_places<> growable = places_.with_spare_capacity();
    core::flat_array<T> data;
    growable.copy_rows(places_, data_, data);
    places_.swap(growable);
    data_.swap(data);
  }
  void enlarge_row(std::size_t i, std::uint32_t n) {
    make_editable();
    if (!places_.has_room(i, n)) move_row(i, places_.larger_room(i, length(i) + n));
  }

 public:
  jagged_array() = default;
  jagged_array(std::shared_ptr<const offsets> where, std::vector<T> data)
      : jagged_array(std::move(where), core::flat_array<T>(std::move(data))) {}
  jagged_array(std::shared_ptr<const offsets> where, core::flat_array<T> data)
      : places_(std::move(where)), data_(std::move(data)) {
    assert(places_.shared_offsets()->back() == data_.size());
  }

  std::size_t size() const { return places_.size(); }
  /// The position of the first value of row i among all values. It does not change while only commit_row() adds values.
  std::size_t first(std::size_t i) const { return places_.first(i); }
  const T* begin(std::size_t i) const { return data_.data() + places_.first(i); }
  const T* end(std::size_t i) const { return data_.data() + places_.last(i); }
  T* begin(std::size_t i) { return data_.data() + places_.first(i); }
  id_span<T> operator[](std::size_t i) const { return {begin(i), end(i)}; }
  std::uint32_t length(std::size_t i) const { return places_.length(i); }
  /// All values, to be moved elsewhere.
  core::flat_array<T>&& values() && { return std::move(data_); }
  /// The number of values in memory, including those that edits left unused.
  std::size_t num_values() const { return data_.size(); }

  /// The first place of a value in row i, or the length of the row if it has none.
  std::uint32_t find_in_row(std::size_t i, const T& value) const {
    return static_cast<std::uint32_t>(std::find(begin(i), end(i), value) - begin(i));
  }

  /// The offsets, which other tables with rows of the same lengths can share; null after an edit.
  const std::shared_ptr<const offsets>& shared_offsets() const { return places_.shared_offsets(); }
  /// Shares the equal offsets of another table, so that they are stored once.
  template<class Rows>
  void share_offsets(const Rows& o) { places_.share_offsets(o.shared_offsets()); }

  // Edits allocate their memory first, which changes no row, and cannot fail afterwards.

  /// After this call remove() and clear_row() cannot fail. Rows stay where they are.
  void make_editable() { places_.make_editable(); }
  /// The same, but most rows get room for more values, so that they need not move soon.
  void make_growable() {
    if (places_.is_packed()) add_spare_capacity();
  }
  /// After this call, n calls of add_row() with that many values in all cannot fail.
  void reserve_rows(std::size_t n, std::size_t values) {
    places_.reserve(n);
    check_index_range(values);
    data_.reserve_back(values);
  }
  /// After this call, n calls of push(i) cannot fail. It uses memory that reserve_rows() reserved, so it must come
  /// before that.
  void reserve_in_row(std::size_t i, std::uint32_t n) {
    if (!places_.has_room(i, n)) enlarge_row(i, n);
  }
  /// Writes a row behind the last one; commit_row(), which cannot fail, adds it. The values may be in these rows; if
  /// `first` is null, the caller writes them.
  T* stage_row(const T* first, std::size_t n, std::size_t room = 0) {
    places_.reserve(1);
    check_index_range(std::max(n, room));
    return data_.stage(first, n, std::max(n, room));
  }
  /// Adds the row that was staged with the same arguments.
  void commit_row(std::size_t n, std::size_t room = 0) {
    room = std::max(n, room);
    const std::size_t at = data_.size();
    places_.add(at, n, room);
    data_.resize(at + room);
    std::fill_n(data_.data() + at + n, room - n, T{});
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
    push_reserved(i, kept);
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
    if (const std::uint32_t k = find_in_row(i, value); k < length(i)) close_gap(i, k);
  }
  /// Removes the k-th value of row i, after make_editable(); the others keep their order.
  void close_gap(std::size_t i, std::uint32_t k) {
    std::copy(begin(i) + k + 1, begin(i) + length(i), begin(i) + k);
    places_.shorten(i);
  }
  // After reserve_in_row() these are faster than the functions above.

  /// Adds a value to row i, which has room for it.
  void push_reserved(std::size_t i, const T& value) { data_[places_.extend(i)] = value; }
  /// Removes the k-th value of row i; the last one takes its place.
  void remove_at(std::size_t i, std::size_t k) {
    assert(k < length(i));
    const T last = data_[places_.shorten(i)];
    begin(i)[k] = last;
  }
  void clear_row(std::size_t i) {
    make_editable();
    places_.set_length(i, 0);
  }
  /// The number of values that resize_row(i, n) needs behind the last row; reserve_rows() reserves them.
  std::uint32_t growth_of_row(std::size_t i, std::size_t n) const {
    return n <= places_.room(i) ? 0 : places_.larger_room(i, n);
  }
  /// Sets the length of row i, whose values the caller then writes. A row that becomes too long moves behind the
  /// others.
  void resize_row(std::size_t i, std::size_t n) {
    make_editable();
    if (const std::uint32_t room = growth_of_row(i, n)) move_row(i, room);
    places_.set_length(i, n);
  }

  /// For undoing: where row i is, and the numbers of rows and of values in memory, which is `any_number` of packed
  /// rows.
  static constexpr std::size_t any_number = static_cast<std::size_t>(-1);
  row_places<>::row_extent extent_of(std::size_t i) const { return places_.extent_of(i); }
  template<class F>
  void for_each_array_at(std::size_t i, const F& f) const { f(begin(i), end(i)); }
  template<class F>
  void for_each_array_at(std::size_t i, const F& f) { f(begin(i), begin(i) + length(i)); }
  void restore_extent(std::size_t i, const row_places<>::row_extent& x) { places_.restore_extent(i, x); }
  std::size_t values_to_restore() const { return places_.is_packed() ? any_number : data_.size(); }
  void restore_size(std::size_t rows, std::size_t values) {
    if (places_.is_packed()) return;
    places_.restore_size(rows);
    if (values != any_number) data_.resize(values);
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
