// Reads the cells of legacy VTK files: rows of verts up to version 5.0, offsets and a list of verts from 5.1 on.
#pragma once

#include <concino/io/detail/cells/corners.hpp>
#include <concino/io/detail/vtk/vtk_grid.hpp>
#include <concino/io/detail/vtk/vtk_index_cursor.hpp>
#include <concino/io/file_contents.hpp>

namespace concino::detail {

class vtk_cells_reader : public vtk_index_cursor, public vtk_places {
  /// Cells that stand together in the file.
  struct cell_block {
    std::uint8_t type = 0;  // of polydata
    const char* at = nullptr;  // the first number; where errors begin to look for a cell
    bool rows = true;
    std::size_t value_size = 4;  // of binary numbers
    std::vector<vert_id> verts;
    std::vector<std::uint32_t> ends;
    std::uint32_t largest = vtk_grid::unknown;  // number in verts
  };
  static constexpr std::string_view polydata_sections[] = {"vertices", "lines", "polygons", "triangle_strips"};
  cell_block blocks_[4];  // of polydata, in VTK's order of cells; else the first one
  const char* types_at_ = nullptr;
  bool has_cells_ = false, finished_ = false;

 protected:
  vtk_grid& grid_;
  bool is_polydata_ = false;

 public:
  vtk_cells_reader(const read_context& c, vtk_grid& grid)
      : vtk_index_cursor(c.text, c.name, c.progress, 0), grid_(grid) {}

  [[noreturn, gnu::noinline, gnu::cold]] void fail_at_cell(std::size_t cell, core::message expected,
                                                           core::message found) override {
    reject(position_of(cell), expected, found);
  }
  std::string place_of_cell(std::size_t cell) override {
    const char* const p = position_of(cell);
    return binary_ ? core::joined({"byte ", static_cast<std::uint64_t>(p - begin())})
                   : core::joined({"line ", line_of(p)});
  }

 protected:
  /// Reads the section, if it has cells or their types. Returns false if it is another one.
  bool read_cells(std::string_view keyword, const char* from) {
    if (is_polydata_) {
      for (std::size_t i = 0; i < 4; ++i) {
        if (polydata_sections[i] != keyword) continue;
        if (blocks_[i].at || finished_) reject(from, {"one such section, before CELL_DATA"}, {"another"});
        constexpr std::uint8_t types[] = {2, 4, 7, 6};
        blocks_[i].type = types[i];
        lists(blocks_[i], from);
        return true;
      }
      return false;
    }
    if (keyword == "cells") {
      if (finished_) reject(from, {"one section CELLS, before CELL_DATA"});
      if (has_cells_) reject(from, {"one section CELLS"}, {"another"});
      has_cells_ = true;
      lists(blocks_[0], from);
      return true;
    }
    if (keyword != "cell_types") return false;
    if (!has_cells_ || types_at_) reject(from, {"CELLS, then one section CELL_TYPES"});
    const std::uint64_t n = next_number("the number of cells");
    if (n != blocks_[0].ends.size()) reject(from, {"the types of ", blocks_[0].ends.size(), " cells"}, {n});
    begin_numbers();
    require_room(from, n, vtk_number::int32);
    types_at_ = at;
    grid_.types.reserve(n);
    for (std::uint64_t i = 0; i < n; ++i) {
      skip_to_value();
      const char* const here = at;
      std::int32_t type = 0;
      read_values(&type, 1);
      if (type < 0 || type > 255) reject(here, {"a cell type from 0 to 255"}, {type});
      grid_.types.push_back(static_cast<std::uint8_t>(type));
    }
    return true;
  }

  /// Puts the cells of all sections into the grid.
  void finish_cells() {
    if (std::exchange(finished_, true)) return;
    if (has_cells_ && !types_at_) reject(end(), {"a section CELL_TYPES"});
    if (!is_polydata_) {
      grid_.verts = std::move(blocks_[0].verts);
      grid_.cell_ends = std::move(blocks_[0].ends);
      grid_.largest = blocks_[0].largest;
      return;
    }
    for (cell_block& p : blocks_) {
      const std::size_t before = grid_.verts.size();
      if (before + p.verts.size() > max_ids) fail_to_count("corners");
      if (before == 0) grid_.verts = std::move(p.verts);
      else grid_.verts.insert(grid_.verts.end(), p.verts.begin(), p.verts.end());
      for (const std::uint32_t e : p.ends) grid_.cell_ends.push_back(static_cast<std::uint32_t>(before + e));
      grid_.types.insert(grid_.types.end(), p.ends.size(), p.type);
      p.verts = {};
    }
  }

 private:
  void lists(cell_block& p, const char* from) {
    const std::uint64_t n = next_number("the number of cells"), size = next_number("the size of the list");
    if (size > max_count) fail_to_count("corners");
    const char* const back = at;
    if (next_keyword() == "offsets") return offsets(p, n, size, from);
    at = back;
    begin_numbers();
    if (n > size) reject(from, {"no more cells than numbers"}, {n, " cells of ", size, " numbers"});
    require_room(from, size, vtk_number::int32);
    p.at = at;
    p.ends.reserve(n);
    if (binary_) return binary_rows(p, n, size, from);
    p.verts.reserve(size - n);
    const char* last = from;
    std::uint64_t used = 0;
    for (std::uint64_t c = 0; c < n; ++c) {
      skip_to_value();
      last = at;
      if (used == size) reject(last, {"cells of ", size, " numbers"}, {n, " cells of more"});
      const auto k = next_index_value(last);
      if (k > size - used - 1)
        reject(last, {"cells of ", size, " numbers"}, {"a cell of ", k, " where ", size - used - 1, " are left"});
      used += k + 1;
      for (std::uint64_t i = 0; i < k; ++i) p.verts.push_back(vert_id{next_index_value(at)});
      p.ends.push_back(static_cast<std::uint32_t>(p.verts.size()));
    }
    if (used != size) reject(last, {"cells of ", size, " numbers"}, {n, " cells of ", used});
  }
  /// The same in binary files, in one pass over the file.
  void binary_rows(cell_block& p, std::uint64_t n, std::uint64_t size, const char* from) {
    constexpr std::size_t step = 4096;  // verts by which the list grows, which stay in the cache until they are
                                        // overwritten
    const std::uint64_t total = size - n;
    p.verts.reserve(total);
    const char* last = from;
    std::uint64_t left = size, num_verts = 0;
    p.largest = 0;
    for (std::uint64_t c = 0; c < n; ++c) {
      last = at;
      if (left == 0) reject(last, {"cells of ", size, " numbers"}, {n, " cells of more"});
      const auto k = value<std::uint32_t>();
      if (k > max_index) fail_index(last, 0);
      if (k >= left) reject(last, {"cells of ", size, " numbers"}, {"a cell of ", k, " where ", left - 1, " are left"});
      left -= std::uint64_t{k} + 1;
      if (p.verts.size() < num_verts + k) p.verts.resize(std::max(num_verts + k, std::min(total, num_verts + step)));
      p.largest = std::max(p.largest, read_ids(p.verts.data() + num_verts, k));
      if (p.largest > max_index) fail_index(last, k);
      p.ends.push_back(static_cast<std::uint32_t>(num_verts += k));
    }
    if (left > 0) reject(last, {"cells of ", size, " numbers"}, {n, " cells of ", size - left});
  }
  /// OFFSETS type, n numbers, the first 0; CONNECTIVITY type, `size` numbers.
  void offsets(cell_block& p, std::uint64_t n, std::uint64_t size, const char* from) {
    const auto type = [&] {
      const char* const here = at;
      const vtk_number t = vtk_number_of_legacy(next_keyword());
      if (t == vtk_number::none || t == vtk_number::bit || t == vtk_number::float32 || t == vtk_number::float64)
        reject(here, {"a type of integers, such as vtktypeint64"});
      begin_numbers();
      return t;
    };
    const vtk_number of_offsets = type();
    if (n > max_count) fail_to_count("cells");
    require_room(from, n, of_offsets);
    p.ends.reserve(n);
    std::uint64_t last = 0;
    for (std::uint64_t i = 0; i < n; ++i) {
      skip_to_value();
      const char* const here = at;
      const std::int64_t offset = integer_of(of_offsets);
      if (offset < static_cast<std::int64_t>(last) || static_cast<std::uint64_t>(offset) > size ||
          (i == 0 && offset != 0))
        reject(here, {i ? "offsets that increase to " : "offsets that begin with 0, and increase to ", size}, {offset});
      last = static_cast<std::uint64_t>(offset);
      if (i) p.ends.push_back(static_cast<std::uint32_t>(last));
    }
    if (last != size && n > 0) reject(from, {"offsets that end with ", size}, {last});
    const char* const here = at;
    if (next_keyword() != "connectivity") reject(here, {"CONNECTIVITY"});
    const vtk_number of_verts = type();
    require_room(from, size, of_verts);
    p.at = at;
    p.rows = false;
    p.value_size = vtk_names_of(of_verts).size;
    p.verts.reserve(size);
    for (std::uint64_t i = 0; i < size; ++i) {
      skip_to_value();
      const char* const position = at;
      const std::int64_t v = integer_of(of_verts);
      if (v < 0 || static_cast<std::uint64_t>(v) > max_count) reject(position, {"an index of a point"}, {v});
      p.verts.push_back(vert_id{static_cast<std::uint32_t>(v)});
    }
  }
  /// Where a cell stands in the file. Reads its section again.
  const char* position_of(std::size_t cell) {
    const cell_block* p = blocks_;
    std::size_t before = is_polydata_ ? 0 : grid_.first(cell);  // verts of the section before those of the cell
    for (; is_polydata_ && cell >= p->ends.size(); ++p) cell -= p->ends.size();
    if (is_polydata_ && cell > 0) before = p->ends[cell - 1];
    at = p->at;
    skip_values(vtk_number::uint8, (before + (p->rows ? cell : 0)) * (binary_ ? p->value_size : 1));
    skip_to_value();
    return at;
  }
};

}  // namespace concino::detail
