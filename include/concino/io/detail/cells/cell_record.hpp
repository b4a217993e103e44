// What is known of the cells that a reader has added: their number and shapes, and why one was rejected.
#pragma once

#include <concino/io/detail/cells/cell_lists.hpp>
#include <concino/io/detail/formats/contents.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace concino::detail {

class cell_record {
 public:
  std::string expected, found;  // the reason why a cell was rejected

  /// Whether the wanted mesh can hold a cell of this shape.
  bool can_hold(cell_shape s) const {
    if (!in_.wanted.cells || in_.wanted.polyhedra) return true;
    const std::uint32_t n = standard_cell_of(s).num_verts;
    return n == wanted_arity(n) && (n == 4 || n == 8);
  }
  /// The number of verts of the first cell. Needs: a cell that is no polyhedron.
  std::uint32_t arity() const { return standard_cell_of(only_).num_verts; }

 protected:
  const read_context& in_;
  std::size_t first_number_;           // of verts, in messages
  std::vector<cell_shape> shapes_;     // of each cell, once they differ
  cell_shape only_ = cell_shape::tet;  // of all cells so far
  std::size_t cells_ = 0, num_negative_ = 0, num_turned_ = 0;
  std::uint64_t corners_ = 0;          // of the faces of all cells

  cell_record(const read_context& in, std::size_t first_number) : in_(in), first_number_(first_number) {}
  ~cell_record() = default;

  cell_shape shape(std::size_t c) const { return shapes_.empty() ? only_ : shapes_[c]; }

  /// Adds a cell whose faces have so many corners. Errors: unsupported for more corners than there are ids.
  void count_cell(cell_shape s, std::uint64_t corners) {
    corners_ += corners;
    if (corners_ > max_ids) core::throw_joined<unsupported>({in_.name, ": more than ", max_ids, " corners of faces"});
    if (cells_ == 0) only_ = s;
    if (s != only_ && shapes_.empty()) shapes_.assign(cells_, only_);
    if (!shapes_.empty()) shapes_.push_back(s);
    ++cells_;
  }

  bool reject_with(core::message what, core::message instead) {
    expected = core::joined(what);
    found = core::joined(instead);
    return false;
  }
  bool reject_shape(const char* shape, std::size_t faces_of_it) {
    return reject_with({name_of_poly(true, wanted_arity(4)), " (polyhedralmesh and load_any take any cell)"},
                       {"a ", shape, " of ", faces_of_it, " faces"});
  }
  bool reject_repeated(vert_id v, const char* where) {
    return reject_with({"different verts in ", where, repeated_verts_hint},
                       {"vert ", v.raw() + first_number_, " twice"});
  }
  /// `number`: of faces_check.
  bool reject_faces(face_fault fault, std::uint32_t number) {
    if (fault == face_fault::too_few_verts) return reject_with({"a face of at least three verts"}, {"one of ", number});
    if (fault == face_fault::repeated_vert) return reject_repeated(vert_id{number}, "a face");
    return reject_with({"different faces in a polyhedron"}, {"two with the same verts"});
  }

  void report_reoriented() const {
    load_report& r = *in_.report;
    r.reoriented_polys += num_negative_ + num_turned_;
    if (num_negative_)
      r.notes.push_back(core::joined({num_negative_, " of ", cells_,
                                      " cells had a negative volume: their verts were put into the standard order"}));
    if (num_turned_)
      r.notes.push_back(
          core::joined({num_turned_, " of ", cells_,
                        " polyhedra were wound inconsistently or inside out: their faces were turned outward"}));
  }

 private:
  /// The number of verts that every cell must have: that of the wanted mesh, else that of the cells so far, else the
  /// one given.
  std::uint32_t wanted_arity(std::uint32_t otherwise) const {
    return in_.wanted.arity ? in_.wanted.arity : cells_ ? arity() : otherwise;
  }
};

}  // namespace concino::detail
