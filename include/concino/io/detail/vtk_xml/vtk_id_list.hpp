// Integers of the list of the faces of polyhedra in a .vtu file, as ids.
#pragma once

#include <concino/mesh/arrays.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Describes a list of integers that became ids. Those that are too large or negative became "no id"; the first of them
/// is kept for errors.
template<class Vert>  // vert_id, as in face_merger
struct vtk_id_list {
  static constexpr std::int64_t max_index = 0xFFFFFFFE;

  std::size_t first_bad = ~std::size_t{0};
  std::int64_t bad = 0;
  std::uint32_t largest = 0;
  std::size_t size = 0;

  /// The integer at position k, which became `id`.
  std::int64_t number(std::size_t k, Vert id) const { return k == first_bad ? bad : std::int64_t{id.raw()}; }

  /// Appends integers to ids.
  void append(const std::int64_t* values, std::size_t count, std::vector<Vert>& ids) {
    std::uint64_t all = 0;
    std::uint32_t largest_of_part = 0;
    const std::size_t before = ids.size();
    ids.resize(before + count);
    Vert* const to = ids.data() + before;
    for (std::size_t i = 0; i < count; ++i) {
      const auto x = static_cast<std::uint64_t>(values[i]);
      const auto id = static_cast<std::uint32_t>(x);
      all |= x;
      largest_of_part = std::max(largest_of_part, id);
      to[i] = Vert{id};
    }
    for (std::size_t i = 0; all > max_index && i < count; ++i) {
      if (values[i] >= 0 && values[i] <= max_index) continue;
      to[i] = Vert{};
      largest_of_part = ~0u;
      if (first_bad == ~std::size_t{0}) first_bad = size + i, bad = values[i];
    }
    largest = std::max(largest, largest_of_part);
    size += count;
  }
};

/// Adds a number to the verts of a polyhedron: the list has the number of its faces, and for each the number of its
/// verts and these.
template<class Vert>
void add_to_listed_verts(Vert* list, std::uint32_t first) {
  if (first == 0) return;
  for (std::uint32_t left = list++->raw(); left > 0; --left)
    for (std::uint32_t i = list++->raw(); i > 0; --i, ++list) *list = Vert{first + list->raw()};
}

}  // namespace concino::detail
