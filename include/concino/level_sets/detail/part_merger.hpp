// Joins the parts of simple cells and those of difficult ones.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/large_pages.hpp>
#include <concino/level_sets/detail/simple_cells.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// Lists the parts of all cells as cell_parts would list them, where it has cut some of them: cells.cells_to_cut().
class part_merger {
  static constexpr std::uint32_t none = ~0u, of_mesh = part_lists::of_mesh;

  const simple_cells& cells_;
  bool both_;
  std::span<const std::uint32_t> cut_cells_;  // by cell of cut_
  const part_lists* cut_;
  std::span<const std::uint32_t> places_of_cut_;  // by place of cut_
  std::vector<std::uint32_t> numbers_;            // by face of cells_: the number of its first polygon
  std::vector<std::uint32_t> numbers_of_cut_;     // by face of cut_
  std::vector<std::uint32_t> caps_;               // by simple cell: the number of its cap
  std::vector<std::uint32_t> final_places_;       // by place
  std::uint32_t num_places_ = 0;

 public:
  part_lists lists;  // without places

  /// The parts above, or all, of simple cells alone.
  part_merger(const simple_cells& cells, bool both) : part_merger(cells, both, {}, nullptr, {}, 0) {}

  /// Places are numbers below num_places; places_of_cut has those of `cut`, or verts of the mesh.
  part_merger(const simple_cells& cells, bool both, std::span<const std::uint32_t> cut_cells, const part_lists* cut, std::span<const std::uint32_t> places_of_cut,
              std::size_t num_places)
      : cells_(cells), both_(both), cut_cells_(cut_cells), cut_(cut), places_of_cut_(places_of_cut), numbers_(core::large_vector(cells.faces_.size(), none)) {
    if (cut_) numbers_of_cut_.assign(cut_->faces.size(), none), final_places_.assign(num_places, none);
  }

  /// Returns false if a face of a difficult cell is also that of another one: all cells must then be cut by cell_parts.
  bool list();

  /// By place: its number in the order in which places come; none if it is not used. Empty if all have the numbers that they had.
  const std::vector<std::uint32_t>& final_places() const { return final_places_; }

 private:
  void reserve();
  void number_place(std::uint32_t place);
  void add_place(std::uint32_t place);
  void end_face(std::uint32_t origin, bool is_whole, bool is_cut);
  void list_simple(const simple_cells::face& f);
  void list_cut(std::uint32_t number);
  bool list_faces();
  void list_caps();
  void list_parts();
  void list_simple_part(std::uint32_t number, bool above);
  bool list_cut_part(const part_lists::part& p, std::uint32_t number);
  static bool is_beside_simple(const simple_cells::face& f);
  bool is_between_simple(std::uint32_t face) const;
  bool are_used_twice() const;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/part_merger.ipp>
#endif
