// Reads the cells of one slice of a binary .vtu file.
#pragma once

#include <concino/io/detail/file_slice/file_slice.hpp>
#include <concino/io/detail/file_slice/vtu_ranges.hpp>
#include <concino/io/detail/vtk/vtk_grid.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

/// Reads the cells of one slice of a .vtu file, and numbers its points anew.
class vtu_slice_cells : protected vtu_ranges {
 protected:
  file_slice& out_;
  runs cells_, points_;          // of the slice: polys, then faces with values; points, and some between them
  std::uint64_t num_cells_ = 0;  // of the slice
  std::vector<std::uint32_t> connectivity_, ends_, faces_;  // with the numbers of verts in the slice
  std::vector<std::int64_t> face_ends_;                     // -1 for cells that are no polyhedra
  std::string types_;

  vtu_slice_cells(const read_context& in, file_slice& out) : vtu_ranges(in), out_(out) {}
  ~vtu_slice_cells() = default;

  void read(slice_choice choice) {
    vtk_xml_tags(in_, index_).read();
    encoding_ = index_.encoding;
    require_one_piece();
    choose_polys(choice);
    for_each_list(cells_, [&](std::uint64_t, std::span<const std::int64_t> list) {
      for (const std::int64_t v : list) out_.add_vert(static_cast<std::uint64_t>(v));
    });
    out_.sort_verts();
    if (choice.only_verts) out_.verts = choice.checked_verts(out_.num_verts);
    for_each_list(cells_, [&](std::uint64_t, std::span<const std::int64_t> list) { add_list(list); });
    if (types_.find(static_cast<char>(vtk_polyhedron)) != types_.npos) read_polyhedra();
    if (!choice.only_verts) add_faces();
    for (const std::uint64_t v : out_.verts) add(points_, v, 1024);
  }

 private:
  std::size_t first_face_ = 0;  // the run of cells of the first face
  bool has_faces_ = false;      // the file is a volume with polygons

  [[noreturn]] void fail_unsupported(core::message what) const {
    core::throw_joined<unsupported>({in_.name, ": slices cannot be read of a file ", core::joined(what),
                                     "; load it, and save it by save(m, path, {.binary = true})"});
  }

  void require_one_piece() {
    if (index_.pieces.size() != 1) fail_unsupported({"in ", index_.pieces.size(), " pieces"});
    piece_ = &index_.pieces[0];
    out_.num_verts = piece_->points;
    for (const vtk_xml_entry& e : index_.entries) {
      if (e.array.format != "appended" || encoding_.base64_appended)
        fail_unsupported({"whose array \"", e.array.name, "\" is text or base64"});
      if (e.part == vtk_xml_part::of_cells && e.array.name == "vtkGhostType") fail_unsupported({"with ghost cells"});
    }
    if (find("polyhedron_to_faces") || find("face_connectivity"))
      fail_unsupported({"with polyhedra in the layout of version 2.3"});
    if (index_.num_texts)
      out_.report.skipped.push_back(core::joined({index_.num_texts, " arrays of texts"}));
    for (const std::string& name : index_.bit_arrays)
      out_.report.skipped.push_back(core::joined({"array \"", name, "\" of bits"}));
  }

  /// Calls use(cell, type) for all cells.
  template<class Use>
  void for_each_type(const Use& use) {
    constexpr std::uint64_t part = 1 << 16;
    const vtk_xml_array& a = need("types");
    std::vector<std::int64_t> some;
    for (std::uint64_t c = 0; c < piece_->cells; c += part) {
      some.clear();
      append_integers(a, c, std::min(part, piece_->cells - c), some);
      for (std::size_t i = 0; i < some.size(); ++i) {
        if (some[i] < 0 || some[i] > 255) fail_array(a, {"cell types from 0 to 255"}, {some[i]});
        use(c + i, static_cast<unsigned>(some[i]));
      }
    }
  }

  /// Finds the cells of the slice: the polys are the polyhedra if there are any, else the polygons.
  void choose_polys(slice_choice choice) {
    if (piece_->cells == 0) return;
    require_numbers(need("types"), piece_->cells);
    require_numbers(need("offsets"), piece_->cells);
    std::uint64_t count[5] = {};
    for_each_type([&](std::uint64_t, unsigned type) {
      if (linear_vtk_type(type) != type) fail_unsupported({"with elements of second or higher order"});
      if (type == 6) fail_unsupported({"with triangle strips"});
      ++count[static_cast<unsigned>(kind_of_vtk_cell(type))];
    });
    const std::uint64_t volumes = count[static_cast<unsigned>(vtk_kind::cell)];
    const vtk_kind kind = volumes ? vtk_kind::cell : vtk_kind::polygon;
    out_.num_polys = count[static_cast<unsigned>(kind)];
    out_.first_poly = choice.first_of(choice.slice, out_.num_polys);
    const std::uint64_t end = choice.first_of(choice.slice + 1, out_.num_polys);
    std::uint64_t poly = 0;
    for_each_type([&](std::uint64_t c, unsigned type) {
      if (kind_of_vtk_cell(type) == vtk_kind::unknown) add_cell(c, type);  // the reader says what is wrong
      if (kind_of_vtk_cell(type) != kind) return;
      if (poly >= out_.first_poly && poly < end) add_cell(c, type);
      ++poly;
    });
    first_face_ = cells_.size();
    has_faces_ = volumes && count[static_cast<unsigned>(vtk_kind::polygon)];
  }
  void add_cell(std::uint64_t c, unsigned type) {
    if (num_cells_++ == max_ids) fail_to_count("cells");
    add(cells_, c, 0);
    types_ += static_cast<char>(type);
  }

  /// Calls use(cell, verts) for the cells of runs.
  template<class Use>
  void for_each_list(const runs& all, const Use& use) {
    if (all.empty()) return;
    const vtk_xml_array &ends_in_file = need("offsets"), &lists = need("connectivity");
    const std::uint64_t bound = count_numbers(lists);
    std::vector<std::int64_t> list;
    std::int64_t last = 0;
    for (const run& r : all) {
      const std::vector<std::int64_t> ends = ends_of(ends_in_file, r);
      check_ends(ends_in_file, ends, bound, last);
      list.clear();
      append_integers(lists, static_cast<std::uint64_t>(ends.front()),
                      static_cast<std::uint64_t>(ends.back() - ends.front()), list);
      for (const std::int64_t v : list) check_vert(lists, v);
      for (std::size_t i = 0; i < r.count; ++i)
        use(r.first + i, std::span<const std::int64_t>(list.data() + (ends[i] - ends[0]),
                                                       static_cast<std::size_t>(ends[i + 1] - ends[i])));
    }
  }
  /// Adds the verts of a cell.
  void add_list(std::span<const std::int64_t> list) {
    if (connectivity_.size() + list.size() > max_ids) fail_to_count("corners");
    for (const std::int64_t v : list) connectivity_.push_back(number_of(v));
    ends_.push_back(static_cast<std::uint32_t>(connectivity_.size()));
  }
  void check_vert(const vtk_xml_array& a, std::int64_t v) const {
    if (v < 0 || static_cast<std::uint64_t>(v) >= piece_->points)
      fail_array(a, {"point indices below ", piece_->points}, {v});
  }

  /// Where the list of the last polyhedron before a cell ends; cells that are no polyhedra have -1.
  std::int64_t end_before(const vtk_xml_array& face_ends, std::uint64_t cell) {
    std::vector<std::int64_t> some;
    for (std::uint64_t c = cell; c > 0; c -= some.size()) {
      const std::uint64_t count = std::min<std::uint64_t>(c, 1 << 13);
      some.clear();
      append_integers(face_ends, c - count, count, some);
      for (auto end = some.rbegin(); end != some.rend(); ++end)
        if (*end >= 0) return *end;
    }
    return 0;
  }

  void read_polyhedra() {
    const vtk_xml_array &faces = need("faces"), &face_ends = need("faceoffsets");
    require_numbers(face_ends, piece_->cells);
    const std::uint64_t bound = count_numbers(faces);
    std::int64_t last = 0;
    std::vector<std::int64_t> list;
    for (const run& r : cells_) {
      const std::vector<std::int64_t> given = ends_of(face_ends, r);
      std::vector<std::int64_t> ends = given;
      ends[0] = end_before(face_ends, r.first);
      for (std::size_t i = 1; i < ends.size(); ++i)
        if (ends[i] < 0) ends[i] = ends[i - 1];
      check_ends(face_ends, ends, bound, last);
      list.clear();
      append_integers(faces, static_cast<std::uint64_t>(ends.front()),
                      static_cast<std::uint64_t>(ends.back() - ends.front()), list);
      for (std::size_t i = 0; i < r.count; ++i) {
        const bool is_polyhedron = given[i + 1] >= 0;
        const std::int64_t* const first = list.data() + (ends[i] - ends[0]);
        if (is_polyhedron) add_polyhedron(faces, {first, static_cast<std::size_t>(ends[i + 1] - ends[i])});
        face_ends_.push_back(is_polyhedron ? static_cast<std::int64_t>(faces_.size()) : -1);
      }
    }
  }
  /// The list of a polyhedron has the number of its faces, and for each the number of its verts and these. Wrong
  /// lengths are left to the reader.
  void add_polyhedron(const vtk_xml_array& faces, std::span<const std::int64_t> list) {
    if (faces_.size() + list.size() > max_ids) fail_to_count("corners of faces");
    std::int64_t left = 0;  // verts of the face
    for (std::size_t i = 0; i < list.size(); ++i) {
      const std::int64_t x = list[i];
      const bool is_vert = left > 0;
      if (is_vert) {
        check_vert(faces, x);
        if (!out_.has(static_cast<std::uint64_t>(x)))
          fail_array(faces, {"points of the polyhedron, which the array \"connectivity\" lists"}, {x});
        --left;
      } else {
        if (x < 0 || x > static_cast<std::int64_t>(max_ids))
          fail_array(faces, {"numbers of faces and of their verts"}, {x});
        if (i > 0) left = x;
      }
      faces_.push_back(is_vert ? number_of(x) : static_cast<std::uint32_t>(x));
    }
  }

  /// Adds the faces of the file whose verts the slice has.
  void add_faces() {
    if (!has_faces_) return;
    runs faces;
    for_each_type([&](std::uint64_t c, unsigned type) {
      if (kind_of_vtk_cell(type) == vtk_kind::polygon) add(faces, c, 0);
    });
    for_each_list(faces, [&](std::uint64_t cell, std::span<const std::int64_t> list) {
      for (const std::int64_t v : list)
        if (!out_.has(static_cast<std::uint64_t>(v))) return;
      if (cells_.size() == first_face_) cells_.push_back({cell, 1});
      else add(cells_, cell, 0);
      if (num_cells_++ == max_ids) fail_to_count("cells");
      types_ += 7;  // a polygon of any size
      add_list(list);
      if (!face_ends_.empty()) face_ends_.push_back(-1);
    });
  }

  std::uint32_t number_of(std::int64_t v) const {
    return static_cast<std::uint32_t>(out_.number_of(static_cast<std::uint64_t>(v)));
  }
};

}  // namespace concino::detail
