// cell_builder: collects the cells of a volume, of any shapes in any order, for the readers of file formats.
#pragma once

#include <concino/io/detail/contents.hpp>
#include <concino/io/detail/polyhedra_builder.hpp>

#include <concepts>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace concino {

/// Collects cells in the order of the file: standard cells by their verts, polyhedra by their faces. Cells of negative volume are put into the
/// standard order, polyhedra are turned outward, and equal faces become one; the report has the numbers of cells that were changed.
///
///   cell_builder cells(in, points, 1);                                      // verts of the file are numbered from 1
///   if (!cells.add_cell(cell_shape::hex, verts)) cursor.fail(position, {cells.expected}, {cells.found});
///   cells.add_face(verts, 5); ...; if (!cells.end_polyhedron()) ...         // the same with a polyhedron
///   cells.finish(out);
///
/// Needs:  the points of all verts, before the first cell; verts below their number.
/// Result: finish() fills the contents: tets or hexes alone become cells, if the wanted mesh can hold cells; all others become polyhedra.
/// Cost:   O(corners of the cells), of the polyhedra O(n log n) in the worst case.
/// Errors: unsupported for more corners than there are ids. What else is wrong with a cell is returned, so that the reader can say where it stands.
/// A template only so that programs without volumes need not compile it: cell_builder.
template<std::same_as<volume_contents> Contents>
class basic_cell_builder {
  const read_context& in_;
  std::vector<vec3>& points_;
  std::size_t first_number_;           // of verts, in messages
  std::vector<vert_id> verts_;         // of the cells before the first polyhedron, or those that were taken over; of a polyhedron its list
  std::vector<cell_shape> shapes_;     // of each cell, once they differ
  cell_shape only_ = cell_shape::tet;  // of all cells so far
  std::size_t cells_ = 0, num_general_ = 0, num_negative_ = 0, num_turned_ = 0;
  std::uint64_t corners_ = 0;          // of the faces of all cells
  std::size_t numbers_ = 0;            // of the lists of all cells
  std::size_t expected_ = 0;           // the same when all cells are added, if known
  std::size_t first_ = 0, faces_ = 0;  // of the polyhedron that is being added
  std::vector<std::uint64_t> scratch_;
  detail::repeated_polys repeated_;
  std::optional<detail::polyhedra_builder<vert_id>> polyhedra_;  // all cells, once one is a polyhedron

 public:
  std::string expected, found;  // the reason why a function below returned false

  /// `first_number` is the number of the first vert in messages.
  basic_cell_builder(const read_context& in, std::vector<vec3>& points, std::size_t first_number)
      : in_(in), points_(points), first_number_(first_number) {}

  /// How many cells were added, with those that options.repeated_verts has dropped.
  std::size_t size() const { return cells_ + repeated_.dropped.size(); }
  /// The number of verts of the first cell. Needs: a cell that is no polyhedron.
  std::uint32_t arity() const { return standard_cell_of(only_).num_verts; }
  /// Makes room for n more cells of a shape. Needs: n was compared with the size of the file.
  void reserve(cell_shape s, std::size_t n) { reserve_numbers(n * standard_cell_of(s).num_verts); }
  /// Makes room for more cells, whose lists have so many numbers. Needs: as above.
  void reserve_numbers(std::size_t n) {
    expect_numbers(numbers_ + n);
    if (!polyhedra_) core::reserve_large(verts_, verts_.size() + n);
  }

  /// Whether the wanted mesh can hold a cell of this shape.
  bool can_hold(cell_shape s) const {
    if (!in_.wanted.cells || in_.wanted.polyhedra) return true;
    const std::uint32_t n = standard_cell_of(s).num_verts;
    return n == wanted_arity(n) && (n == 4 || n == 8);
  }

  /// Adds a cell with its verts in the standard order, that of MEDIT. Returns false if a vert is there twice, or if the wanted mesh cannot hold the cell.
  bool add_cell(cell_shape s, const vert_id* v) {
    const std::size_t first = verts_.size(), n = standard_cell_of(s).num_verts;
    if (takes_repeated() && detail::first_repeated(v, n, scratch_) != n) return add_mended(faces_of(s, v).data());
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

  /// Ends a polyhedron. Returns false if it has no face, a face of fewer than three verts, a face or a vert of a face twice, or if the wanted mesh
  /// cannot hold it.
  bool end_polyhedron() {
    if (faces_ == 0) return reject_with({"a polyhedron of at least one face"}, {"one without faces"});
    verts_[first_] = vert_id{std::exchange(faces_, 0)};
    if (takes_repeated() && detail::has_repeated_vert(verts_.data() + first_, scratch_)) {
      const std::vector<vert_id> list(verts_.begin() + static_cast<std::ptrdiff_t>(first_), verts_.end());
      verts_.resize(first_);
      return add_mended(list.data());
    }
    const bool is_recognised = in_.wanted.cells && !in_.wanted.polyhedra;
    const bool is_valid = is_recognised ? add_recognised() : check_polyhedron(verts_.data() + first_, verts_.size() - first_);
    if (!is_valid || polyhedra_) verts_.resize(first_);
    return is_valid;
  }

  /// The same with a list: the number of the faces, and for each the number of its verts and these.
  /// Needs:  the wanted mesh can hold polyhedra. So many numbers, which are right.
  bool add_polyhedron(const vert_id* list, std::size_t numbers) {
    return takes_repeated() && detail::has_repeated_vert(list, scratch_) ? add_mended(list) : check_polyhedron(list, numbers);
  }
  /// Says how many numbers the lists of all cells have. Needs: as above.
  void expect_numbers(std::size_t n) { expected_ = n; }

  /// Takes over a list of all cells, which is not copied: the verts of standard cells in their order; of a polyhedron the number of its faces, and for
  /// each the number of its verts and these. add_taken then adds each of its cells.
  /// Needs:  no cell was added before. The wanted mesh can hold polyhedra, if there are any. options.repeated_verts is refuse.
  void take(std::vector<vert_id>&& list) {
    verts_ = std::move(list);
    expected_ = verts_.size();
  }
  /// Adds the next n numbers of the list as a cell. Returns false as add_cell and end_polyhedron. Needs: n is right for the shape.
  bool add_taken(cell_shape s, std::size_t n) {
    vert_id* const v = verts_.data() + numbers_;
    return s == cell_shape::general ? check_polyhedron(v, n) : check_cell(s, v);
  }

  /// Adds all cells of a volume that has cells of one shape only. Needs: no cell was added before.
  /// Result: the number of cells; less if one is not valid, as for add_cell: then its position.
  std::size_t add_all_cells(cell_shape s, std::vector<vert_id>&& list) {
    const standard_cell& cell = standard_cell_of(s);
    if (takes_repeated()) {
      for (std::size_t c = 0; c * cell.num_verts < list.size(); ++c)
        if (!add_cell(s, list.data() + c * cell.num_verts)) return c;
      return size();
    }
    verts_ = std::move(list);
    const std::size_t n = verts_.size() / cell.num_verts;
    const bool fits = can_hold(s), are_tets = s == cell_shape::tet && fits && have_moderate_coordinates();
    for (std::size_t c = 0; c < n; ++c) {
      vert_id* const v = verts_.data() + c * cell.num_verts;
      if (are_tets && is_plain_tet(v)) continue;
      const std::size_t k = detail::first_repeated(v, cell.num_verts, scratch_);
      if (k != cell.num_verts ? !reject_repeated(v[k], "a cell") : !fits && !reject(cell.name, cell.num_faces)) return c;
      num_negative_ += make_volume_positive(s, v, points_);
    }
    for (unsigned f = 0; f < cell.num_faces; ++f) corners_ += n * cell.face_size[f];
    if (verts_.size() > detail::max_ids || corners_ > detail::max_ids) core::throw_joined<unsupported>({in_.name, ": more than ", detail::max_ids, " corners of faces"});
    only_ = s;
    cells_ = n;
    expected_ = verts_.size();
    return n;
  }

  /// Moves the points and the cells into the contents.
  void finish(Contents& out) {
    const std::size_t arity = cells_ && only_ != cell_shape::general ? standard_cell_of(only_).num_verts : 0;
    const bool fits = in_.wanted.cells && shapes_.empty() && (cells_ == 0 || arity == 4 || arity == 8);
    out.filled = fits ? arrays_kind::cells : arrays_kind::polyhedra;
    if (fits) out.cells = cell_arrays{std::move(points_), std::move(verts_), arity ? static_cast<std::uint32_t>(arity) : in_.wanted.arity ? in_.wanted.arity : 4};
    else out.polyhedra = polyhedra();
    report_reoriented();
    repeated_.policy = in_.repeated_verts;
    out.repeated = std::move(repeated_);
  }

 private:
  bool takes_repeated() const { return in_.repeated_verts != repeated_verts::refuse; }

  /// The faces of a standard cell, as a list.
  static std::vector<vert_id> faces_of(cell_shape s, const vert_id* v) {
    const standard_cell& cell = standard_cell_of(s);
    std::vector<vert_id> list{vert_id{std::size_t{cell.num_faces}}};
    for (unsigned f = 0; f < cell.num_faces; ++f) {
      list.push_back(vert_id{std::size_t{cell.face_size[f]}});
      for (unsigned i = 0; i < cell.face_size[f]; ++i) list.push_back(v[cell.face_vert[f][i]]);
    }
    return list;
  }
  /// Adds what options.repeated_verts makes of a polyhedron with a vert twice.
  [[gnu::noinline, gnu::cold]] bool add_mended(const vert_id* listed) {
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

  bool have_moderate_coordinates() const {
    bool all = true;
    for (const vec3& p : points_) all &= concino::has_moderate_coordinates(p);
    return all;
  }
  /// Whether a tet has four different verts and a positive volume without doubt, as nearly all tets. Needs: have_moderate_coordinates().
  bool is_plain_tet(const vert_id* v) const {
    const vec3* const p = points_.data();
    const vec3 &a = p[v[0].raw()], &b = p[v[1].raw()], &c = p[v[2].raw()], &d = p[v[3].raw()];
    const double volume = dot(b - a, cross(c - a, d - a));
    return volume > 1e-100 && volume < 1e100 && v[0] != v[1] && v[0] != v[2] && v[0] != v[3] && v[1] != v[2] && v[1] != v[3] && v[2] != v[3];
  }

  /// The number of verts that every cell must have: that of the wanted mesh, else that of the cells so far, else the one given.
  std::uint32_t wanted_arity(std::uint32_t otherwise) const {
    return in_.wanted.arity ? in_.wanted.arity : cells_ ? standard_cell_of(only_).num_verts : otherwise;
  }

  void end_cell(cell_shape s, std::size_t numbers) {
    if (verts_.size() > detail::max_ids || corners_ > detail::max_ids) core::throw_joined<unsupported>({in_.name, ": more than ", detail::max_ids, " corners of faces"});
    if (cells_ == 0) only_ = s;
    if (s != only_ && shapes_.empty()) shapes_.assign(cells_, only_);
    if (!shapes_.empty()) shapes_.push_back(s);
    ++cells_;
    numbers_ += numbers;
    if (polyhedra_) expect_polyhedra();
  }

  /// Ends a cell whose verts are in the list, if it is valid.
  bool check_cell(cell_shape s, vert_id* v) {
    const standard_cell& cell = standard_cell_of(s);
    if (const std::size_t k = detail::first_repeated(v, cell.num_verts, scratch_); k != cell.num_verts) return reject_repeated(v[k], "a cell");
    if (!can_hold(s)) return reject(cell.name, cell.num_faces);
    num_negative_ += make_volume_positive(s, v, points_);
    for (unsigned f = 0; f < cell.num_faces; ++f) corners_ += cell.face_size[f];
    if (polyhedra_) polyhedra_->add_cell(s, v);
    end_cell(s, cell.num_verts);
    return true;
  }

  /// The same with the list of a polyhedron, which has so many numbers.
  bool check_polyhedron(const vert_id* list, std::size_t numbers) {
    if (!polyhedra_) begin_polyhedra();
    if (const detail::face_fault fault = polyhedra_->add(list, numbers); fault != detail::face_fault::none) {
      const std::uint32_t number = polyhedra_->checked().number;
      if (num_general_ == 0) polyhedra_.reset();
      return reject_faces(fault, number);
    }
    ++num_general_;
    corners_ += numbers - 1 - list->raw();
    end_cell(cell_shape::general, numbers);
    return true;
  }

  /// Makes polyhedra of all cells that there are.
  [[gnu::noinline, gnu::cold]] void begin_polyhedra() {
    polyhedra_.emplace(points_);
    const vert_id* v = verts_.data();
    for (std::size_t c = 0; c < cells_; ++c) {
      const cell_shape s = shapes_.empty() ? only_ : shapes_[c];
      polyhedra_->add_cell(s, v);
      v += standard_cell_of(s).num_verts;
      if (c == 1023) polyhedra_->reserve_times(static_cast<double>(expected_) / static_cast<double>(v - verts_.data()));
    }
  }
  /// Makes room for the expected polyhedra, as soon as there are enough of them to know how large they are.
  void expect_polyhedra() {
    if (cells_ == 1024 && expected_ > numbers_) polyhedra_->reserve_times(static_cast<double>(expected_) / static_cast<double>(numbers_));
  }
  [[gnu::noinline, gnu::cold]] bool reject_with(core::message what, core::message instead) {
    expected = core::joined(what);
    found = core::joined(instead);
    return false;
  }
  [[gnu::noinline, gnu::cold]] bool reject_faces(detail::face_fault fault, std::uint32_t number) {
    if (fault == detail::face_fault::too_few_verts) return reject_with({"a face of at least three verts"}, {"one of ", number});
    if (fault == detail::face_fault::repeated_vert) return reject_repeated(vert_id{number}, "a face");
    return reject_with({"different faces in a polyhedron"}, {"two with the same verts"});
  }
  [[gnu::noinline, gnu::cold]] bool reject_repeated(vert_id v, const char* where) {
    return reject_with({"different verts in ", where, detail::repeated_verts_hint}, {"vert ", v.raw() + first_number_, " twice"});
  }
  [[gnu::noinline, gnu::cold]] bool reject(const char* shape, std::size_t faces_of_it) {
    return reject_with({detail::name_of_poly(true, wanted_arity(4)), " (polyhedralmesh and load_any take any cell)"}, {"a ", shape, " of ", faces_of_it, " faces"});
  }

  /// Replaces the polyhedron at the end of the list by a tet or a hex.
  [[gnu::noinline, gnu::cold]] bool add_recognised() {
    detail::faces_check<vert_id> check;
    detail::face_list_decoder<vert_id> decode;
    const vert_id* const list = verts_.data() + first_;
    if (const detail::face_fault fault = check(list); fault != detail::face_fault::none) return reject_faces(fault, check.number);
    const detail::oriented_faces listed = decode(list);
    const bool turned = detail::poly_orienter<vert_id>(points_)(listed);
    cell_recogniser known;
    for (std::uint32_t f = 0; f < listed.size; ++f) {
      known.begin_face();
      for (std::uint32_t k = listed.offsets[f]; k < listed.offsets[f + 1]; ++k) known.push(listed.verts[k]);
      if (!listed.outward[f]) known.reverse_face();
    }
    const cell_shape s = known.recognise();
    if (s == cell_shape::general || !can_hold(s)) return reject(s == cell_shape::general ? "polyhedron" : standard_cell_of(s).name, listed.size);
    const std::uint32_t n = standard_cell_of(s).num_verts;
    num_turned_ += turned;
    corners_ += check.num_corners;
    verts_.resize(first_);
    verts_.insert(verts_.end(), known.cell, known.cell + n);
    end_cell(s, n);
    return true;
  }

  [[gnu::noinline, gnu::cold]] void report_reoriented() {
    load_report& r = *in_.report;
    r.reoriented_polys += num_negative_ + num_turned_;
    if (num_negative_) r.notes.push_back(core::joined({num_negative_, " of ", cells_, " cells had a negative volume: their verts were put into the standard order"}));
    if (num_turned_) r.notes.push_back(core::joined({num_turned_, " of ", cells_, " polyhedra were wound inconsistently or inside out: their faces were turned outward"}));
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
