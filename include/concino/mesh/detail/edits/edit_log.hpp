// edit_log: what the arrays of a mesh held before its edits, so that these can be undone. Each step, which is one edit,
// saves the sizes of all arrays and the rows that it is about to change; undoing restores them in the opposite order,
// needs no memory and cannot fail.
//
// The arrays of a mesh are visited by a function of its tables, for_each_array(f), always in the same order; this order
// numbers them.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/mesh/detail/rows/alive_elements.hpp>
#include <concino/mesh/detail/rows/incident_lists.hpp>
#include <concino/mesh/property_set.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace concino::detail {

/// How the rows of an array are saved. `sizes` are two numbers from which the array gets its size again; `put` appends
/// the bytes of a row.
template<class T, unsigned N>
struct saved_array {
  using array = jagged_array<T, N>;
  static std::size_t num_rows(const array& a) { return a.size(); }
  static void sizes(const array& a, std::uint64_t* two) { two[0] = a.size(), two[1] = 0; }
  static void resize(array& a, const std::uint64_t* two) { a.restore_size(two[0]); }
  static void put(const array& a, std::size_t row, std::vector<unsigned char>& bytes) {
    const auto* const first = reinterpret_cast<const unsigned char*>(a.begin(row));
    bytes.insert(bytes.end(), first, first + N * sizeof(T));
  }
  static void restore(array& a, std::size_t row, const unsigned char* bytes, std::size_t) {
    std::memcpy(static_cast<void*>(a.begin(row)), bytes, N * sizeof(T));
  }
};

/// Rows of any lengths: the place of a row, then its values in each array.
template<class Array>
struct saved_rows {
  using array = Array;
  static std::size_t num_rows(const array& a) { return a.size(); }
  static void sizes(const array& a, std::uint64_t* two) { two[0] = a.size(), two[1] = a.values_to_restore(); }
  static void resize(array& a, const std::uint64_t* two) { a.restore_size(two[0], two[1]); }
  static void put(const array& a, std::size_t row, std::vector<unsigned char>& bytes) {
    const auto where = a.extent_of(row);
    const auto append = [&bytes](const void* first, const void* last) {
      bytes.insert(bytes.end(), static_cast<const unsigned char*>(first), static_cast<const unsigned char*>(last));
    };
    append(&where, &where + 1);
    a.for_each_array_at(row, append);
  }
  static void restore(array& a, std::size_t row, const unsigned char* bytes, std::size_t) {
    decltype(a.extent_of(row)) where;
    std::memcpy(&where, bytes, sizeof where);
    a.restore_extent(row, where);
    bytes += sizeof where;
    a.for_each_array_at(row, [&bytes](void* first, void* last) {
      const auto n = static_cast<std::size_t>(static_cast<unsigned char*>(last) - static_cast<unsigned char*>(first));
      if (n > 0) std::memcpy(first, bytes, n);
      bytes += n;
    });
  }
};
template<class T> struct saved_array<T, 0> : saved_rows<jagged_array<T, 0>> {};

template<class Array> struct saved;
template<class T, unsigned N> struct saved<jagged_array<T, N>> : saved_array<T, N> {};
template<bool WithPolys> struct saved<incident_lists<WithPolys>> : saved_rows<incident_lists<WithPolys>> {};

template<class Id>
struct saved<alive_elements<Id>> {
  using array = alive_elements<Id>;
  static std::size_t num_rows(const array& a) { return a.bound(); }
  static void sizes(const array& a, std::uint64_t* two) { two[0] = a.bound(), two[1] = a.size(); }
  static void resize(array& a, const std::uint64_t* two) { a.restore_size(two[0], two[1]); }
  static void put(const array& a, std::size_t row, std::vector<unsigned char>& bytes) {
    bytes.push_back(a.contains(Id{row}));
  }
  static void restore(array& a, std::size_t row, const unsigned char* bytes, std::size_t) {
    a.restore(Id{row}, *bytes);
  }
};

/// Arrays of plain values.
template<class Array, class T>
struct saved_values {
  static std::size_t num_rows(const Array& a) { return a.size(); }
  static void sizes(const Array& a, std::uint64_t* two) { two[0] = a.size(), two[1] = 0; }
  static void resize(Array& a, const std::uint64_t* two) { a.resize(two[0]); }
  static void put(const Array& a, std::size_t row, std::vector<unsigned char>& bytes) {
    const auto* const first = reinterpret_cast<const unsigned char*>(a.data() + row);
    bytes.insert(bytes.end(), first, first + sizeof(T));
  }
  static void restore(Array& a, std::size_t row, const unsigned char* bytes, std::size_t) {
    std::memcpy(static_cast<void*>(a.data() + row), bytes, sizeof(T));
  }
};
template<class T> struct saved<core::flat_array<T>> : saved_values<core::flat_array<T>, T> {};
template<class T> struct saved<std::vector<T>> : saved_values<std::vector<T>, T> {};

/// The values of a property, whose bytes can be copied.
template<>
struct saved<column> {
  static std::size_t num_rows(const column& a) { return a.size(); }
  static void sizes(const column& a, std::uint64_t* two) { two[0] = a.size(), two[1] = 0; }
  static void resize(column& a, const std::uint64_t* two) { a.resize(two[0]); }
  static void put(const column& a, std::size_t row, std::vector<unsigned char>& bytes) {
    const std::size_t n = a.operations().size;
    const auto* const first = static_cast<const unsigned char*>(a.data()) + row * n;
    bytes.insert(bytes.end(), first, first + n);
  }
  static void restore(column& a, std::size_t row, const unsigned char* bytes, std::size_t n) {
    std::memcpy(static_cast<unsigned char*>(a.data()) + row * n, bytes, n);
  }
};

class edit_log {
  struct row {
    std::uint32_t array, index;
    std::size_t first;  // of its bytes
  };
  struct step {
    std::size_t first_row, first_byte, first_size;
  };

  std::vector<unsigned char> bytes_;
  std::vector<row> rows_;
  std::vector<std::uint64_t> sizes_;  // of the arrays before each step, two each
  std::vector<step> steps_;

 public:
  std::size_t num_steps() const { return steps_.size(); }

  /// Begins a step. save() of the rows that will change must follow, before anything changes. If something fails, call
  /// drop_step().
  template<class Mesh>
  void begin_step(Mesh& m) {
    const step s{rows_.size(), bytes_.size(), sizes_.size()};
    reserve_more(steps_, 1);
    std::size_t count = 0;
    m.for_each_array([&](const auto&) { ++count; });
    reserve_more(sizes_, 2 * count);
    m.for_each_array([&](const auto& a) {
      std::uint64_t two[2];
      saved<std::remove_cvref_t<decltype(a)>>::sizes(a, two);
      sizes_.insert(sizes_.end(), two, two + 2);
    });
    steps_.push_back(s);
  }
  template<class Array>
  void save(std::uint32_t number, const Array& a, std::size_t index) {
    const std::size_t first = bytes_.size();
    reserve_more(rows_, 1);
    try {
      saved<Array>::put(a, index, bytes_);
    } catch (...) {
      bytes_.resize(first);
      throw;
    }
    rows_.push_back({number, static_cast<std::uint32_t>(index), first});
  }
  /// Forgets the last step.
  void drop_step() noexcept {
    const step& s = steps_.back();
    rows_.resize(s.first_row);
    bytes_.resize(s.first_byte);
    sizes_.resize(s.first_size);
    steps_.pop_back();
  }

  /// Undoes all steps from `step` on and forgets them.
  template<class Mesh>
  void roll_back(Mesh& m, std::size_t to_step) noexcept {
    if (to_step == steps_.size()) return;
    const step s = steps_[to_step];
    restore_rows(m, s.first_row);
    restore_sizes(m, s.first_size);
    while (steps_.size() > to_step) drop_step();
  }

  /// A log of one step that leads from the state that the first step of this log restores to that of m.
  template<class Mesh>
  edit_log of_changes(Mesh& m) const {
    edit_log after;
    after.begin_step(m);
    if (steps_.empty()) return after;
    for (const row& r : rows_) after.save_if(m, r.array, r.index, sizes_[2 * r.array]);
    std::uint32_t number = 0;
    m.for_each_array([&](const auto& a) {
      for (std::size_t i = sizes_[2 * number]; i < saved<std::remove_cvref_t<decltype(a)>>::num_rows(a); ++i)
        after.save(number, a, i);
      ++number;
    });
    return after;
  }
  /// Restores the state before the first step, and keeps the log.
  template<class Mesh>
  void restore_before(Mesh& m) const noexcept {
    if (steps_.empty()) return;
    restore_rows(m, 0);
    restore_sizes(m, 0);
  }
  /// Restores the state that a log of one step describes, and keeps the log.
  template<class Mesh>
  void restore(Mesh& m) const {
    restore_sizes(m, 0);
    restore_rows(m, 0);
  }

 private:
  std::size_t end_of(std::size_t r) const { return r + 1 < rows_.size() ? rows_[r + 1].first : bytes_.size(); }

  /// Saves a row that was there before.
  template<class Mesh>
  void save_if(Mesh& m, std::uint32_t wanted, std::uint32_t index, std::uint64_t rows_before) {
    if (index >= rows_before) return;
    std::uint32_t number = 0;
    m.for_each_array([&](const auto& a) {
      if (number++ == wanted) save(wanted, a, index);
    });
  }
  template<class Mesh>
  void restore_rows(Mesh& m, std::size_t first) const noexcept {
    for (std::size_t r = rows_.size(); r > first; --r) {
      const row& x = rows_[r - 1];
      std::uint32_t number = 0;
      m.for_each_array([&](auto& a) {
        if (number++ == x.array)
          saved<std::remove_cvref_t<decltype(a)>>::restore(a, x.index, bytes_.data() + x.first,
                                                           end_of(r - 1) - x.first);
      });
    }
  }
  template<class Mesh>
  void restore_sizes(Mesh& m, std::size_t first) const {
    const std::uint64_t* two = sizes_.data() + first;
    m.for_each_array([&](auto& a) {
      saved<std::remove_cvref_t<decltype(a)>>::resize(a, two);
      two += 2;
    });
  }
};

}  // namespace concino::detail
