// Reads the cells of one slice of a binary .vtu file.
#pragma once

#include <concino/io/detail/file_slice/file_slice.hpp>
#include <concino/io/detail/file_slice/vtu_ranges.hpp>
#include <concino/io/detail/vtk/vtk_grid.hpp>

#include <algorithm>
#include <cstdint>
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
  std::vector<std::int64_t> connectivity_, ends_, faces_, face_ends_;
  std::string types_;

  vtu_slice_cells(const read_context& in, file_slice& out) : vtu_ranges(in), out_(out) {}
  ~vtu_slice_cells() = default;

  void read(slice_choice choice) {
    vtk_xml_tags(in_, index_).read();
    encoding_ = index_.encoding;
    require_one_piece();
    choose_polys(choice);
    read_cells();
    out_.verts.reserve(connectivity_.size());
    for (const std::int64_t v : connectivity_) out_.verts.push_back(static_cast<std::uint64_t>(v));
    out_.sort_verts();
    add_faces();
    for (const std::uint64_t v : out_.verts) add(points_, v, 4096);
    for (std::int64_t& v : connectivity_) v = number_of(v);
    renumber_polyhedra();
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

  /// Appends the verts of the cells of a run, and where the list of each ends. `last` is where the lists of the run
  /// before end in the file: runs that overlap would have more verts than the file.
  void append_lists(const run& r, std::vector<std::int64_t>& lists, std::vector<std::int64_t>& ends,
                    std::int64_t& last) {
    const vtk_xml_array &offsets = need("offsets"), &verts = need("connectivity");
    const std::vector<std::int64_t> all = ends_of(offsets, r);
    check_ends(offsets, all, count_numbers(verts), last);
    const auto before = static_cast<std::int64_t>(lists.size()), begin = all.front();
    append_integers(verts, static_cast<std::uint64_t>(begin), static_cast<std::uint64_t>(all.back() - begin), lists);
    for (std::size_t i = 1; i < all.size(); ++i) ends.push_back(before + all[i] - begin);
    for (auto i = static_cast<std::size_t>(before); i < lists.size(); ++i) check_vert(verts, lists[i]);
  }
  void check_vert(const vtk_xml_array& a, std::int64_t v) const {
    if (v < 0 || static_cast<std::uint64_t>(v) >= piece_->points)
      fail_array(a, {"point indices below ", piece_->points}, {v});
  }

  /// Where the list of the last polyhedron before a cell ends; cells that are no polyhedra have -1.
  std::int64_t end_before(const vtk_xml_array& offsets, std::uint64_t cell) {
    std::vector<std::int64_t> some;
    for (std::uint64_t c = cell; c > 0; c -= some.size()) {
      const std::uint64_t count = std::min<std::uint64_t>(c, 1 << 13);
      some.clear();
      append_integers(offsets, c - count, count, some);
      for (auto end = some.rbegin(); end != some.rend(); ++end)
        if (*end >= 0) return *end;
    }
    return 0;
  }

  void read_cells() {
    std::int64_t last_vert = 0, last_face = 0;
    for (const run& r : cells_) append_lists(r, connectivity_, ends_, last_vert);
    if (types_.find(static_cast<char>(vtk_polyhedron)) == types_.npos) return;
    const vtk_xml_array &faces = need("faces"), &offsets = need("faceoffsets");
    require_numbers(offsets, piece_->cells);
    const std::uint64_t bound = count_numbers(faces);
    for (const run& r : cells_) {
      std::vector<std::int64_t> all = ends_of(offsets, r);
      all[0] = end_before(offsets, r.first);
      std::vector<std::int64_t> lists = all;
      for (std::size_t i = 1; i < lists.size(); ++i)
        if (lists[i] < 0) lists[i] = lists[i - 1];
      check_ends(offsets, lists, bound, last_face);
      const auto before = static_cast<std::int64_t>(faces_.size());
      append_integers(faces, static_cast<std::uint64_t>(lists.front()),
                      static_cast<std::uint64_t>(lists.back() - lists.front()), faces_);
      for (std::size_t i = 1; i < all.size(); ++i)
        face_ends_.push_back(all[i] < 0 ? -1 : before + all[i] - lists.front());
    }
  }

  /// Adds the faces of the file whose verts the slice has.
  void add_faces() {
    if (!has_faces_) return;
    runs faces;
    for_each_type([&](std::uint64_t c, unsigned type) {
      if (kind_of_vtk_cell(type) == vtk_kind::polygon) add(faces, c, 0);
    });
    std::vector<std::int64_t> verts, ends;
    std::int64_t last = 0;
    for (const run& all : faces)
      for (run r{all.first, 0}; r.first < all.first + all.count; r.first += r.count) {
        r.count = std::min<std::uint64_t>(1 << 14, all.first + all.count - r.first);
        verts.clear(), ends.clear();
        append_lists(r, verts, ends, last);
        for (std::size_t i = 0, begin = 0; i < ends.size(); begin = static_cast<std::size_t>(ends[i++]))
          add_face(r.first + i, {verts.begin() + static_cast<std::ptrdiff_t>(begin), verts.begin() + ends[i]});
      }
  }
  void add_face(std::uint64_t cell, const std::vector<std::int64_t>& verts) {
    for (const std::int64_t v : verts)
      if (!out_.has(static_cast<std::uint64_t>(v))) return;
    if (num_cells_++ == max_ids) fail_to_count("cells");
    if (cells_.size() == first_face_) cells_.push_back({cell, 1});
    else add(cells_, cell, 0);
    types_ += 7;  // a polygon of any size
    connectivity_.insert(connectivity_.end(), verts.begin(), verts.end());
    ends_.push_back(static_cast<std::int64_t>(connectivity_.size()));
    if (!face_ends_.empty()) face_ends_.push_back(-1);
  }

  std::int64_t number_of(std::int64_t v) const {
    return static_cast<std::int64_t>(out_.number_of(static_cast<std::uint64_t>(v)));
  }

  /// The list of a polyhedron has the number of its faces, and for each the number of its verts and these. Wrong lengths
  /// are left to the reader.
  void renumber_polyhedra() {
    std::int64_t begin = 0;
    for (const std::int64_t end : face_ends_) {
      if (end < 0) continue;
      for (std::int64_t i = begin + 1; i < end;) {
        const std::int64_t n = faces_[static_cast<std::size_t>(i++)];
        for (std::int64_t k = 0; k < n && i < end; ++k, ++i) {
          std::int64_t& v = faces_[static_cast<std::size_t>(i)];
          check_vert(need("faces"), v);
          if (!out_.has(static_cast<std::uint64_t>(v)))
            fail_array(need("faces"), {"points of the polyhedron, which the array \"connectivity\" lists"}, {v});
          v = number_of(v);
        }
        if (n < 0) break;
      }
      begin = end;
    }
  }
};

}  // namespace concino::detail
