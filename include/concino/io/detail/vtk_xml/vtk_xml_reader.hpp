// Reads .vtu and .vtp files into a grid.
#pragma once

#include <concino/io/detail/values/name_runs.hpp>
#include <concino/io/detail/vtk_xml/vtk_united_points.hpp>
#include <concino/io/detail/vtk_xml/vtk_xml_cells.hpp>

#include <algorithm>
#include <utility>

namespace concino::detail {

/// Reads the points and cells of all pieces, then their arrays. Points of different pieces at the same place with the
/// same values become one.
class vtk_xml_reader : public vtk_xml_cells, public vtk_places {
  load_report& report_;
  std::vector<std::uint32_t> kept_cells_;              // without ghosts; empty: all
  std::shared_ptr<detail::column> is_ghost_;                   // of each cell; null if the file does not say

 public:
  vtk_xml_reader(const read_context& in, vtk_grid& grid) : vtk_xml_cells(in, grid), report_(*in.report) {}

  void read() {
    vtk_xml_tags(in_, index_).read();
    encoding_ = index_.encoding;
    for (std::size_t p = 0; p < index_.pieces.size(); ++p) {
      first_point_.push_back(grid_.points.size());
      first_cell_.push_back(grid_.size());
      points(p);
      if (!index_.is_polydata) grid_cells(p);
      for (unsigned i = 0; index_.is_polydata && i < 4; ++i) polydata_cells(p, i);
    }
    first_point_.push_back(grid_.points.size());
    first_cell_.push_back(grid_.size());
    columns();
    if (index_.num_texts) report_.skipped.push_back(core::joined({index_.num_texts, " arrays of texts"}));
    for (const std::string& name : index_.bit_arrays)
      report_.skipped.push_back(core::joined({"array \"", name, "\" of bits"}));
    if (index_.pieces.size() > 1)
      unite_points_of_pieces(grid_, vtk_point_merger(grid_, first_point_), has_faces_, index_.pieces.size(), report_);
    drop_ghosts();
    // all verts were compared with it
    if (!grid_.points.empty()) grid_.largest = static_cast<std::uint32_t>(grid_.points.size() - 1);
  }

  /// What the tags of the file say.
  const vtk_xml_index& index() const { return index_; }
  /// The line of the tag of the first piece; 1 if there is none.
  std::size_t line_of_piece() const { return index_.pieces.empty() ? 1 : line_of(index_.pieces[0].at); }

  [[noreturn, gnu::noinline, gnu::cold]] void fail_at_cell(std::size_t cell, core::message expected,
                                                           core::message found) override {
    const place_in_piece x = piece_of(cell);
    fail(index_.pieces[x.piece].at, expected, {core::joined(found), " in cell ", x.cell, " of the piece"});
  }
  std::string place_of_cell(std::size_t cell) override {
    const place_in_piece x = piece_of(cell);
    return core::joined({"position ", x.cell, " of the piece on line ", line_of(index_.pieces[x.piece].at)});
  }

 private:
  struct place_in_piece {
    std::size_t piece, cell;
  };
  place_in_piece piece_of(std::size_t cell) const {
    if (!kept_cells_.empty()) cell = kept_cells_[cell];
    std::size_t p = 0;
    while (p + 1 < index_.pieces.size() && cell >= first_cell_[p + 1]) ++p;
    return {p, cell - first_cell_[p]};
  }

  /// Reads the arrays that all pieces have. The arrays of one name become a list.
  void columns() {
    name_table names;
    std::vector<std::uint32_t> first, last;
    for (std::size_t i = 0; i < index_.entries.size(); ++i) {
      vtk_xml_entry& e = index_.entries[i];
      if (e.part != vtk_xml_part::of_points && e.part != vtk_xml_part::of_cells && e.part != vtk_xml_part::of_mesh)
        continue;
      if (e.part == vtk_xml_part::of_mesh) e.piece = 0;
      const std::size_t k = number_of_name(names, e, [&](std::size_t known) {
        return known < last.size() && index_.entries[last[known]].piece == e.piece;
      });
      const auto here = static_cast<std::uint32_t>(i);
      if (k == first.size()) {
        first.push_back(here), last.push_back(here);
      } else if (index_.entries[last[k]].piece != e.piece) {
        index_.entries[last[k]].next = here;
        last[k] = here;
      }
    }
    for (const std::uint32_t i : first) column(index_.entries[i]);
  }
  /// The number of the name of an array. If the piece has an array of that name already, this one gets another name.
  template<class IsTaken>
  std::size_t number_of_name(name_table& names, vtk_xml_entry& e, const IsTaken& is_taken) {
    const std::string given = e.array.name;
    for (unsigned n = 2;; ++n) {
      const std::size_t k = names.add(core::joined({static_cast<char>('0' + static_cast<int>(e.part)), e.array.name}));
      if (!is_taken(k)) {
        if (n > 2)
          report_.notes.push_back(
              core::joined({"another array \"", given, "\" is the property \"", e.array.name, "\""}));
        return k;
      }
      e.array.name = core::joined({given, "_", n});
    }
  }
  const vtk_xml_entry* next(const vtk_xml_entry* e) const {
    return e->next == ~0u ? nullptr : &index_.entries[e->next];
  }

  void skip_column(const std::string& array_name, std::uint64_t components) {
    report_.skipped.push_back(core::joined(
        {"array \"", array_name,
         "\": properties have one value for each element, in all pieces, of 1, 2, 3, 4, 6 or 9 numbers, and it has ",
         components}));
  }

  void column(const vtk_xml_entry& start) {
    const vtk_xml_part part = start.part;
    const std::string& array_name = start.array.name;
    const element_kind kind = part == vtk_xml_part::of_points  ? element_kind::vert
                              : part == vtk_xml_part::of_cells ? element_kind::poly
                                                               : element_kind::mesh;
    const std::vector<std::size_t>& first = kind == element_kind::vert ? first_point_ : first_cell_;
    const auto count = [&](std::size_t p) {
      return kind == element_kind::mesh ? std::size_t{1} : first[p + 1] - first[p];
    };
    const vtk_xml_array& one = start.array;
    std::string property = array_name;
    if (kind == element_kind::vert && array_name == index_.normals && one.components == 3) property = "normal";
    if (kind == element_kind::vert && array_name == index_.textures && one.components == 2) property = "texture";
    const bool as_doubles = property != array_name || property == index_.normals || property == index_.textures;
    const value_type* const type =
        property_type_of(as_doubles ? vtk_number::float64 : one.type, one.components, property);
    bool fits = type && (kind != element_kind::mesh || one.tuples == 1);
    std::size_t num_values = 0;
    for (const vtk_xml_entry* e = &start; e; e = next(e)) {
      const std::size_t n = count(e->piece);
      fits = fits && (n == 0 || (e->array.type == one.type && e->array.components == one.components));
      num_values += n;
    }
    const std::size_t total = kind == element_kind::mesh ? 1 : first.back();
    if (!fits || num_values != total) return skip_column(array_name, one.components);
    for (const vtk_xml_entry* e = &start; e; e = next(e))
      if (!has_numbers(e->array, kind, count(e->piece))) return;
    if (property != array_name)
      report_.notes.push_back(core::joined({"the array \"", array_name, "\" is the property \"", property, "\""}));
    const std::shared_ptr<detail::column> values = make_column(*type, total);
    auto* to = static_cast<unsigned char*>(values->data());
    for (const vtk_xml_entry* e = &start; e; e = next(e)) {
      read_column(e->array, count(e->piece) * one.components, as_doubles, to);
      to += count(e->piece) * type->size;
    }
    const bool is_ghost_array = array_name == "vtkGhostType" && one.type == vtk_number::uint8 && one.components == 1;
    if (!is_ghost_array) grid_.columns.push_back({kind, property, values});
    else if (kind == element_kind::poly) is_ghost_ = values;
  }
  /// Whether an array has a value for each of n elements. Reports it as skipped if not.
  bool has_numbers(const vtk_xml_array& a, element_kind kind, std::uint64_t n) {
    const std::uint64_t found = count_numbers(a), needed = n * a.components;
    if (found == needed || n == 0) return true;
    const std::string elements = kind == element_kind::mesh
                                     ? "the mesh needs"
                                     : core::joined({n, kind == element_kind::vert ? " points" : " cells", " need"});
    report_.skipped.push_back(
        core::joined({"array \"", a.name, "\" of ", found, " numbers, where ", elements, " ", needed}));
    return false;
  }
  void read_column(const vtk_xml_array& a, std::uint64_t n, bool as_doubles, unsigned char* to) {
    if (!as_doubles || a.type == vtk_number::float64) return read_array(a, n, to);
    for_each_part<double>(a, n, [&](const double* values, std::size_t k) {
      std::memcpy(to, values, k * sizeof(double));
      to += k * sizeof(double);
    });
  }

  /// Drops cells that another piece has too, and hidden ones.
  void drop_ghosts() {
    constexpr unsigned duplicate = 1, hidden = 32;
    std::size_t verts = 0;
    std::vector<std::uint32_t> kept;
    if (!is_ghost_) return;
    const auto* const is_ghost = static_cast<const std::uint8_t*>(is_ghost_->data());
    for (std::size_t c = 0; c < is_ghost_->size(); ++c)
      if ((is_ghost[c] & (duplicate | hidden)) == 0) kept.push_back(static_cast<std::uint32_t>(c));
    if (kept.size() == grid_.size()) return;
    grid_.num_ghosts = grid_.size() - kept.size();
    std::size_t first = 0;
    for (std::size_t c = 0, k = 0; c < is_ghost_->size(); ++c) {
      const std::size_t end = grid_.cell_ends[c];
      if (k < kept.size() && kept[k] == c) {
        for (std::size_t i = first; i < end; ++i) grid_.verts[verts++] = grid_.verts[i];
        grid_.types[k] = grid_.types[c];
        grid_.cell_ends[k++] = static_cast<std::uint32_t>(verts);
      }
      first = end;
    }
    grid_.verts.resize(verts);
    grid_.types.resize(kept.size());
    grid_.cell_ends.resize(kept.size());
    keep_grid_values(grid_, element_kind::poly, kept);
    kept_cells_ = std::move(kept);
  }
};

}  // namespace concino::detail
