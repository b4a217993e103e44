// The reader of .tet: verts, then cells as lists of verts, as Cinolib and geogram write them.
#pragma once

#include <concino/io/cell_builder.hpp>
#include <concino/io/detail/cells/voxel_order.hpp>
#include <concino/io/detail/tet/tet_format.hpp>
#include <concino/io/text_cursor.hpp>

#include <array>
#include <string_view>
#include <vector>

namespace concino::detail {

/// Reads a .tet file. Contents is volume_contents; a template only so that programs that read no volumes need not
/// compile it.
template<class Contents>
class tet_reader : token_cursor {
  load_report& report_;
  std::vector<vec3> points_;
  basic_cell_builder<Contents> cells_;
  std::uint64_t num_connectors_ = 0;
  bool standard_hexes_ = false;  // else in the order of voxels

 public:
  explicit tet_reader(const read_context& c)
      : token_cursor(text_without_padding(c.text), c.name, c.progress, '#'), report_(*c.report), cells_(c, points_, 0) {
  }

  void read(Contents& out) {
    skip();
    if (at_end()) fail(end(), "the number of vertices and the word 'vertices'");
    const std::uint64_t nv = next_count("the number of vertices", 6);
    keyword("vertices", "vertices", "the word 'vertices'");
    const std::uint64_t nc = next_count("the number of cells", 10);
    const bool has_other_cells = keyword("tets", "cells", "the word 'tets' or 'cells'");
    verts(nv);
    if (has_other_cells) choose_order();
    cells(nc);
    if (num_connectors_) report_.skipped.push_back(core::joined({num_connectors_, " connectors between cells (# C)"}));
    cells_.finish(out);
  }

 private:
  /// Reads one of two words. Returns whether it is the second one.
  bool keyword(std::string_view one, std::string_view other, const char* expected) {
    skip();
    const char* const from = at;
    const std::string_view w = word();
    if (w != one && w != other) fail(from, expected);
    return w == other;
  }

  void verts(std::uint64_t n) {
    points_.reserve(reservable(n, 6));
    for (std::uint64_t i = 0; i < n; ++i) {
      vec3 p;
      p.x = next_real("the x of a vertex");
      p.y = next_real("the y of a vertex");
      p.z = next_real("the z of a vertex");
      points_.push_back(p);
      report_progress();
    }
  }

  /// Moves to the next cell. Counts connectors, and skips comments.
  void skip_to_cell() {
    for (skip_space(); !at_end() && *at == '#'; skip_space()) {
      ++at;
      while (!at_end() && is_blank(*at)) ++at;
      num_connectors_ += word() == "C";
      skip_line();
    }
  }

  struct row {
    const char* position;
    cell_shape shape;
    std::array<vert_id, 8> verts;
  };
  row next_row() {
    row r{at, cell_shape::general, {}};
    const std::int64_t n = integer("the number of vertices of a cell", comment);
    for (const cell_shape s : {cell_shape::tet, cell_shape::pyramid, cell_shape::prism, cell_shape::hex})
      if (n == standard_cell_of(s).num_verts) r.shape = s;
    if (r.shape == cell_shape::general) fail(r.position, "the number of vertices of a cell: 4, 5, 6 or 8");
    for (std::int64_t k = 0; k < n; ++k)
      r.verts[static_cast<std::size_t>(k)] = vert_id{next_index(points_.size(), "a vertex index", 0)};
    return r;
  }

  /// Finds out in which of two orders the file lists the verts of hexes: as a comment says, or from the volumes of the
  /// first thousand.
  void choose_order() {
    const char* const back = at;
    skip_space();
    const bool is_said = std::string_view(at, left()).starts_with(voxel_order_comment);
    hex_order_vote vote;
    for (skip_to_cell(); !is_said && !at_end() && !vote.is_complete(); skip_to_cell()) {
      const row r = next_row();
      report_progress();
      if (r.shape == cell_shape::hex) vote.add(r.verts.data(), points_);
    }
    standard_hexes_ = vote.is_standard();
    at = back;
    num_connectors_ = 0;
    if (standard_hexes_)
      report_.notes.push_back("the hexes list their verts around two opposite faces, not in geogram's order");
  }

  void cells(std::uint64_t n) {
    for (skip_to_cell(); !at_end(); skip_to_cell()) {
      if (cells_.size() == n) fail(at, "the end of the file after the last cell");
      row r = next_row();
      if (cells_.size() == 0) cells_.reserve(r.shape, 1 + reservable(n, 2 * standard_cell_of(r.shape).num_verts + 2));
      if (r.shape == cell_shape::hex && !standard_hexes_) r.verts = swap_voxel_order(r.verts.data());
      if (!cells_.add_cell(r.shape, r.verts.data())) fail(r.position, {cells_.expected}, {cells_.found});
      report_progress();
    }
    if (cells_.size() != n && cells_.size() + num_connectors_ != n)  // geogram counts connectors as cells
      fail(end(), {n, " cells"}, {cells_.size(), " cells and ", num_connectors_, " connectors"});
  }
};

}  // namespace concino::detail

namespace concino {

/// Needs:  text of a .tet file: the numbers of vertices and cells, on one line or two, then these. Lines that begin
///         with # are comments; those that begin with # C connect cells.
/// Result: its verts and cells in order. The verts of cells of negative volume are put into the standard order, and
///         these cells are counted. Hexes are in geogram's order (that of voxels), unless most of them have a larger
///         volume in the standard order, and the comment before the first cell does not say that they are in the order
///         of voxels. Connectors are reported as skipped.
/// Cost:   O(size of the text)
/// Errors: parse_error naming the line of a wrong number, an index out of range, a cell with a vertex twice, a cell
///         that the wanted mesh cannot hold, text after the last cell, or the end of a file that is cut off.
template<std::same_as<volume_contents> Contents>
void tet_format::read(const read_context& in, Contents& out) {
  detail::tet_reader<Contents>(in).read(out);
}

}  // namespace concino
