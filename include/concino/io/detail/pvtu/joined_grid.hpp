// Joins the grids of the pieces of a .pvtu file into one.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/pvtu/pvtu_tags.hpp>
#include <concino/io/detail/vtk/vtk_grid.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace concino::detail {

/// A grid that grows by that of one piece after another. Errors name the file of a piece and the line of its tag.
class joined_grid final : public vtk_places {
  struct piece {
    std::string path;
    std::size_t line, first_point, first_cell;
    bool has_ghosts;
  };
  bool has_faces_;
  load_report& report_;
  std::vector<piece> pieces_;
  std::vector<std::uint32_t> order_;  // where each cell was before the cells were sorted; empty: in its place
  name_table reported_;

  void add_columns(vtk_grid& part, element_kind kind, std::size_t before, std::size_t count);
  void skip(const std::string& array, const char* why);
  const piece& piece_of_cell(std::size_t cell) const;
  const piece& piece_of_point(std::size_t point) const;
  std::vector<std::int64_t> ids(element_kind kind, const std::string& array) const;
  void unite_by_ids(const std::vector<std::int64_t>& ids, const std::string& array);
  void sort_cells(const std::vector<std::int64_t>& ids, const std::string& array);

 public:
  vtk_grid grid;

  /// has_faces: the verts of polyhedra are the lists of their faces.
  joined_grid(bool has_faces, load_report& report) : has_faces_(has_faces), report_(report) {}

  /// Adds the grid of a piece, which was read from the file at that path.
  /// Errors: unsupported for more points, cells or corners than there are ids.
  void add(vtk_grid&& part, const std::string& path, std::size_t line);

  /// Unites the points of different pieces that are one: those of the same number in the array point_ids, or, if there
  /// is none, those at the same place. Sorts points and cells by their numbers.
  /// Errors: parse_error if points of one number are at different places, or two cells have one number.
  void finish(const std::string& point_ids, const std::string& cell_ids);

  [[noreturn, gnu::cold]] void fail_at_cell(std::size_t cell, core::message expected, core::message found) override;
  std::string place_of_cell(std::size_t cell) override;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/pvtu/joined_grid.ipp>
#endif
