// cell_builder: collects the cells of a volume, of any shapes in any order, for the readers of file formats.
#pragma once

#include <concino/io/detail/cells/cell_record.hpp>
#include <concino/io/detail/cells/polyhedra_builder.hpp>

#include <concepts>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace concino {

/// Collects cells in the order of the file: standard cells by their verts, polyhedra by their faces. Cells of negative
/// volume are put into the standard order, polyhedra are turned outward, and equal faces become one; the report has the
/// numbers of cells that were changed.
///
///   cell_builder cells(in, points, 1);                                      // verts of the file are numbered from 1
///   if (!cells.add_cell(cell_shape::hex, verts)) cursor.fail(position, {cells.expected}, {cells.found});
///   cells.add_face(verts, 5); ...; if (!cells.end_polyhedron()) ...         // the same with a polyhedron
///   cells.finish(out);
///
/// Needs:  the points of all verts, before the first cell; verts below their number.
/// Result: finish() fills the contents: tets or hexes alone become cells, if the wanted mesh can hold cells; all others
///         become polyhedra.
/// Cost:   O(corners of the cells), of the polyhedra O(n log n) in the worst case.
/// Errors: unsupported for more corners than there are ids. What else is wrong with a cell is returned, so that the
///         reader can say where it stands.
/// A template only so that programs without volumes need not compile it: cell_builder.
template<std::same_as<volume_contents> Contents>
class basic_cell_builder : public detail::cell_record {
  std::vector<vec3>& points_;
  std::vector<vert_id> verts_;         // of the cells before the first polyhedron, and the list of the polyhedron that
                                       // is being added
  std::size_t num_general_ = 0;
  std::size_t first_ = 0, faces_ = 0;  // of the polyhedron that is being added
  std::vector<std::uint64_t> scratch_;
  detail::polys_with_repeats repeated_;
  std::optional<detail::polyhedra_builder<vert_id>> polyhedra_;  // all cells, once one is a polyhedron

 public:
  /// `first_number` is the number of the first vert in messages.
  basic_cell_builder(const read_context& in, std::vector<vec3>& points, std::size_t first_number)
      : cell_record(in, first_number), points_(points) {}

  /// How many cells were added, with those that options.repeated_verts has dropped.
  std::size_t size() const { return cells_ + repeated_.dropped.size(); }
  /// Makes room for n more cells of a shape. Needs: n was compared with the size of the file.
  void reserve(cell_shape s, std::size_t n) {
    if (!polyhedra_) verts_.reserve(verts_.size() + n * standard_cell_of(s).num_verts);
  }

  /// Adds a cell with its verts in the standard order, that of MEDIT. Returns false if a vert is there twice, or if the
  /// wanted mesh cannot hold the cell.
  bool add_cell(cell_shape s, const vert_id* v) {
    const std::size_t first = verts_.size(), n = standard_cell_of(s).num_verts;
    if (takes_repeated() && detail::first_repeated(v, n, scratch_) != n)
      return add_mended(detail::faces_of_cell(s, v).data());
    verts_.insert(verts_.end(), v, v + n);
    const bool is_valid = check_cell(s, verts_.data() + first);
    if (!is_valid || polyhedra_) verts_.resize(first);
    return is_valid;
  }

  /// Adds a face of the next polyhedron.
  void add_face(const vert_id* v, std::size_t n) {
    if (faces_++ == 0) {
      first_ = verts_.size();
      verts_.push_back({});
    }
    verts_.push_back(vert_id{n});
    verts_.insert(verts_.end(), v, v + n);
  }

  /// Ends a polyhedron. Returns false if it has no face, a face of fewer than three verts, a face or a vert of a face
  /// twice, or if the wanted mesh cannot hold it.
  bool end_polyhedron() {
    if (faces_ == 0) return reject_with({"a polyhedron of at least one face"}, {"one without faces"});
    verts_[first_] = vert_id{std::exchange(faces_, 0)};
    if (takes_repeated() && detail::has_repeated_vert(verts_.data() + first_, scratch_)) {
      const std::vector<vert_id> list(verts_.begin() + static_cast<std::ptrdiff_t>(first_), verts_.end());
      verts_.resize(first_);
      return add_mended(list.data());
    }
    const bool is_recognised = in_.wanted.cells && !in_.wanted.polyhedra;
    const bool is_valid = is_recognised ? add_recognised() : check_polyhedron(verts_.data() + first_);
    if (!is_valid || polyhedra_) verts_.resize(first_);
    return is_valid;
  }

  /// Moves the points and the cells into the contents.
  void finish(Contents& out) {
    const std::size_t arity = cells_ && only_ != cell_shape::general ? standard_cell_of(only_).num_verts : 0;
    const bool fits = in_.wanted.cells && shapes_.empty() && (cells_ == 0 || arity == 4 || arity == 8);
    out.filled = fits ? arrays_kind::cells : arrays_kind::polyhedra;
    if (fits)
      out.cells = cell_arrays{std::move(points_), std::move(verts_),
                              arity              ? static_cast<std::uint32_t>(arity)
                              : in_.wanted.arity ? in_.wanted.arity
                                                 : 4};
    else out.polyhedra = polyhedra();
    report_reoriented();
    repeated_.policy = in_.repeated_verts;
    out.repeated = std::move(repeated_);
  }

 private:
  bool takes_repeated() const { return in_.repeated_verts != repeated_verts::refuse; }

  /// Adds what options.repeated_verts makes of a polyhedron with a vert twice.
  bool add_mended(const vert_id* listed) {
    const auto number = static_cast<std::uint32_t>(size());
    repeated_.add(number, [] { return std::string(); });
    std::vector<vert_id> list;
    if (in_.repeated_verts == repeated_verts::collapse) list = detail::collapsed_faces(listed, points_);
    if (list.empty() || list[0].raw() == 0) {
      if (!list.empty()) repeated_.add_vanished();
      repeated_.dropped.push_back(number);
      return true;
    }
    cell_recogniser known;
    const vert_id* v = list.data();
    for (std::uint32_t left = v++->raw(); left > 0; --left) {
      known.begin_face();
      for (std::uint32_t n = v++->raw(); n > 0; --n) known.push(*v++);
    }
    if (const cell_shape s = known.recognise(); s != cell_shape::general) return add_cell(s, known.cell);
    v = list.data();
    for (std::uint32_t left = v++->raw(); left > 0; --left) {
      const std::uint32_t n = v++->raw();
      add_face(v, n);
      v += n;
    }
    return end_polyhedron();
  }

  /// Ends a cell whose verts are in the list, if it is valid.
  bool check_cell(cell_shape s, vert_id* v) {
    const standard_cell& cell = standard_cell_of(s);
    if (const std::size_t k = detail::first_repeated(v, cell.num_verts, scratch_); k != cell.num_verts)
      return reject_repeated(v[k], "a cell");
    if (!can_hold(s)) return reject_shape(cell.name, cell.num_faces);
    num_negative_ += make_volume_positive(s, v, points_);
    std::uint64_t corners = 0;
    for (unsigned f = 0; f < cell.num_faces; ++f) corners += cell.face_size[f];
    count_cell(s, corners);
    if (polyhedra_) polyhedra_->add_cell(s, v);
    return true;
  }

  /// The same with the list of a polyhedron.
  bool check_polyhedron(const vert_id* list) {
    if (!polyhedra_) begin_polyhedra();
    if (const detail::face_fault fault = polyhedra_->add(list); fault != detail::face_fault::none) {
      const std::uint32_t number = polyhedra_->checked().number;
      if (num_general_ == 0) polyhedra_.reset();
      return reject_faces(fault, number);
    }
    ++num_general_;
    count_cell(cell_shape::general, polyhedra_->checked().num_corners);
    return true;
  }

  /// Makes polyhedra of all cells that there are.
  void begin_polyhedra() {
    polyhedra_.emplace(points_);
    const vert_id* v = verts_.data();
    for (std::size_t c = 0; c < cells_; ++c) {
      const cell_shape s = shape(c);
      polyhedra_->add_cell(s, v);
      v += standard_cell_of(s).num_verts;
    }
  }
  /// Replaces the polyhedron at the end of the list by a tet or a hex.
  bool add_recognised() {
    detail::faces_check<vert_id> check;
    detail::face_list_decoder<vert_id> decode;
    const vert_id* const list = verts_.data() + first_;
    if (const detail::face_fault fault = check(list); fault != detail::face_fault::none)
      return reject_faces(fault, check.number);
    const detail::oriented_faces listed = decode(list);
    const bool turned = detail::poly_orienter<vert_id>(points_)(listed);
    cell_recogniser known;
    for (std::uint32_t f = 0; f < listed.size; ++f) {
      known.begin_face();
      for (std::uint32_t k = listed.offsets[f]; k < listed.offsets[f + 1]; ++k) known.push(listed.verts[k]);
      if (!listed.outward[f]) known.reverse_face();
    }
    const cell_shape s = known.recognise();
    if (s == cell_shape::general || !can_hold(s))
      return reject_shape(s == cell_shape::general ? "polyhedron" : standard_cell_of(s).name, listed.size);
    const std::uint32_t n = standard_cell_of(s).num_verts;
    num_turned_ += turned;
    verts_.resize(first_);
    verts_.insert(verts_.end(), known.cell, known.cell + n);
    count_cell(s, check.num_corners);
    return true;
  }

  polyhedra_arrays polyhedra() {
    if (!polyhedra_) begin_polyhedra();
    std::vector<vert_id>().swap(verts_);
    std::vector<cell_shape>().swap(shapes_);
    num_turned_ += polyhedra_->num_turned();
    return polyhedra_->finish(std::move(points_));
  }
};
using cell_builder = basic_cell_builder<volume_contents>;

}  // namespace concino
