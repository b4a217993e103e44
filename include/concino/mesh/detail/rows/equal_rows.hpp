// jagged_array<T, N>: rows of N values each.
#pragma once

#include <concino/concepts/ranges.hpp>
#include <concino/core/flat_array.hpp>

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace concino::detail {

template<class T, unsigned N>
class jagged_array {
  core::flat_array<T> data_;

 public:
  jagged_array() = default;
  explicit jagged_array(std::vector<T> data) : data_(std::move(data)) { assert(data_.size() % N == 0); }
  explicit jagged_array(core::flat_array<T> data) : data_(std::move(data)) { assert(data_.size() % N == 0); }
  /// n rows with uninitialised values.
  explicit jagged_array(std::size_t n) : data_(n * N) {}
  jagged_array(std::size_t n, const T& value) : data_(n * N, value) {}

  std::size_t size() const { return data_.size() / N; }
  /// The position of the first value of row i among all values.
  std::size_t first(std::size_t i) const { return i * N; }
  const T* begin(std::size_t i) const { return data_.data() + i * N; }
  const T* end(std::size_t i) const { return data_.data() + i * N + N; }
  T* begin(std::size_t i) { return data_.data() + i * N; }
  id_span<T> operator[](std::size_t i) const {
    const T* const first = begin(i);  // read once, so that compilers see N values and unroll loops over them
    return {first, first + N};
  }
  static constexpr std::uint32_t length(std::size_t) { return N; }
  std::size_t num_values() const { return data_.size(); }

  // Edits allocate their memory first, which changes no row, and cannot fail afterwards.

  /// After this call, n calls of add_row() cannot fail.
  void reserve_rows(std::size_t n) { data_.reserve_back(n * N); }
  /// Writes a row behind the last one; commit_row(), which cannot fail, adds it. The values may be in these rows; if
  /// `first` is null, the caller writes them.
  T* stage_row(const T* first, [[maybe_unused]] std::size_t n) {
    assert(n == N);
    return data_.stage(first, N, N);
  }
  void commit_row([[maybe_unused]] std::size_t n) {
    assert(n == N);
    data_.resize(data_.size() + N);
  }
  /// Adds n rows for which memory is reserved, with uninitialised values.
  void commit_rows(std::size_t n) { data_.resize(data_.size() + n * N); }
  template<class It>
  void add_row(It first, [[maybe_unused]] It last) {
    assert(last - first == N);
    data_.append(std::to_address(first), N);
  }
  /// After this call, n calls of add_row() cannot fail, and row i can get a length of N, which it has.
  void reserve_rows(std::size_t n, std::size_t) { reserve_rows(n); }
  std::uint32_t growth_of_row(std::size_t, std::size_t) const { return 0; }
  void resize_row(std::size_t, [[maybe_unused]] std::size_t n) { assert(n == N); }
  /// Removes the rows from `rows` on, or makes them part of the array again, for undoing.
  void restore_size(std::size_t rows) { data_.resize(rows * N); }
};

}  // namespace concino::detail
