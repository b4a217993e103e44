// Views of the user's arrays: numbers at a constant stride in memory, lists of verts in rows or with offsets.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/concepts/ranges.hpp>
#include <concino/mesh/detail/rows/jagged_array.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>

namespace concino::detail {

/// The stride between two numbers; 0 if it is known only at run time.
template<std::ptrdiff_t Step>
struct step_of {
  constexpr step_of(std::ptrdiff_t = Step) {}
  constexpr operator std::ptrdiff_t() const { return Step; }
};
template<>
struct step_of<0> {
  std::ptrdiff_t step;
  constexpr step_of(std::ptrdiff_t s = 1) : step(s) {}
  constexpr operator std::ptrdiff_t() const { return step; }
};

/// Numbers at a constant stride.
template<class T, std::ptrdiff_t Step = 1>
class strided {
  T* first_ = nullptr;
  [[no_unique_address]] step_of<Step> step_;

 public:
  using number = std::remove_const_t<T>;
  strided() = default;
  explicit strided(T* first, std::ptrdiff_t step = Step) : first_(first), step_(step) {}
  T& operator[](std::size_t k) const { return first_[static_cast<std::ptrdiff_t>(k) * step_]; }
  strided from(std::size_t k) const { return strided(first_ + static_cast<std::ptrdiff_t>(k) * step_, step_); }
};

/// One list of verts, with N entries, or with a number of entries set at run time (N = 0).
template<class Numbers, unsigned N>
class input_list {
  Numbers numbers_;
  std::uint32_t size_ = N;

 public:
  using value_type = vert_id;
  using iterator = index_iterator<input_list>;

  input_list() = default;
  explicit input_list(Numbers numbers, std::uint32_t size = N) : numbers_(numbers), size_(size) {}
  std::size_t size() const { return N ? N : size_; }
  bool empty() const { return size() == 0; }
  vert_id operator[](std::size_t k) const { return vert_id{numbers_[k]}; }
  iterator begin() const { return {*this, 0}; }
  iterator end() const { return {*this, size()}; }
};

/// Lists of N entries in the rows of an array: rows.row(i)[k] is a number.
template<class Rows, unsigned N>
class lists_in_rows {
  Rows rows_;

 public:
  using row = decltype(std::declval<const Rows&>().row(0));
  explicit lists_in_rows(Rows r) : rows_(std::move(r)) {}
  std::size_t size() const { return rows_.size(); }
  std::size_t num_values() const { return N * size(); }
  static constexpr std::uint32_t length(std::size_t) { return N; }
  row numbers(std::size_t i) const { return rows_.row(i); }
  input_list<row, N> operator[](std::size_t i) const { return input_list<row, N>(rows_.row(i)); }
};

/// Consecutive lists in an array: list i begins at number first[i] and ends where list i + 1 begins.
template<class Flat>
class lists_between {
  Flat flat_;
  std::shared_ptr<const offsets> first_;

 public:
  using row = decltype(std::declval<const Flat&>().numbers());
  lists_between(Flat flat, offsets first)
      : flat_(std::move(flat)), first_(std::make_shared<const offsets>(std::move(first))) {}
  std::size_t size() const { return first_->size() - 1; }
  std::size_t num_values() const { return first_->back(); }
  std::uint32_t length(std::size_t i) const { return (*first_)[i + 1] - (*first_)[i]; }
  row numbers(std::size_t i) const { return flat_.numbers().from((*first_)[i]); }
  input_list<row, 0> operator[](std::size_t i) const { return input_list<row, 0>(numbers(i), length(i)); }
  const std::shared_ptr<const offsets>& shared_offsets() const { return first_; }
  /// Shares equal offsets of another object, so that they are stored once.
  template<class T>
  void share_offsets(const jagged_array<T, 0>& o) { first_ = o.shared_offsets(); }
};

}  // namespace concino::detail
