// Collects the cells of a volume, of any shapes in any order, for the readers of all formats.
#pragma once

#include <concino/io/detail/contents.hpp>
#include <concino/io/detail/face_key.hpp>
#include <concino/io/detail/orient.hpp>
#include <concino/mesh/face_soup.hpp>

#include <string>
#include <utility>

namespace concino::detail {

/// Collects cells in the order of the file: standard cells by their verts, polyhedra by their faces. Cells of negative volume are put into the
/// standard order, and polyhedra are turned outward; the report has their numbers.
///
///   cell_builder<volume_contents> cells(in, points, 1);                     // verts of the file are numbered from 1
///   if (!cells.add_cell(cell_shape::hex, verts)) cursor.fail(position, {cells.expected}, {cells.found});
///   cells.add_face(verts, 5); ...; if (!cells.end_polyhedron()) ...         // the same with a polyhedron
///   cells.finish(out);
///
/// The points are read before the first cell. A template only so that programs without volumes need not compile it.
template<class Contents>
class cell_builder {
  const read_context& in_;
  std::vector<vec3>& points_;
  std::size_t first_number_;           // of verts, in messages
  std::vector<vert_id> verts_;         // of the cells; of a polyhedron: the number of its faces, then for each the number of its verts and these
  std::vector<std::uint8_t> shapes_;   // cell_shape of each cell, once they differ
  cell_shape only_ = cell_shape::tet;  // of all cells so far
  std::size_t cells_ = 0, num_general_ = 0, num_negative_ = 0, num_turned_ = 0;
  std::uint64_t corners_ = 0;       // of the faces of all cells
  std::size_t all_faces_ = 0;       // of all cells; a face of two cells twice
  std::vector<std::uint64_t> scratch_;
  // the polyhedron that is being added
  std::size_t first_ = 0, faces_ = 0;
  std::vector<std::uint64_t> face_keys_;
  bool failed_ = false;

 public:
  std::string expected, found;  // the reason why a function below returned false

  cell_builder(const read_context& in, std::vector<vec3>& points, std::size_t first_number) : in_(in), points_(points), first_number_(first_number) {}

  std::size_t size() const { return cells_; }
  /// The number of verts of the first cell. Needs: a cell that is no polyhedron.
  std::uint32_t arity() const { return standard_cell_of(only_).num_verts; }
  /// Makes room for n more cells of a shape. Needs: n was compared with the size of the file.
  void reserve(cell_shape s, std::size_t n) { core::reserve_large(verts_, verts_.size() + n * standard_cell_of(s).num_verts); }

  /// Makes room for more cells, whose lists have so many numbers. Needs: as above.
  void reserve_numbers(std::size_t n) { core::reserve_large(verts_, verts_.size() + n); }

  /// Whether the wanted mesh can hold a cell of this shape.
  bool can_hold(cell_shape s) const {
    if (!in_.wanted.cells || in_.wanted.polyhedra) return true;
    const std::uint32_t n = standard_cell_of(s).num_verts;
    return n == wanted_arity(n) && (n == 4 || n == 8);
  }

  /// Adds a cell with its verts in the order of VTK and MEDIT. Returns false if a vert is there twice, or if the wanted mesh cannot hold the cell.
  bool add_cell(cell_shape s, const vert_id* v) {
    const standard_cell& cell = standard_cell_of(s);
    if (const std::size_t k = first_repeated(v, cell.num_verts, scratch_); k != cell.num_verts) return reject_repeated(v[k], "a cell");
    if (!can_hold(s)) return reject(cell.name, cell.num_faces);
    const std::size_t first = verts_.size();
    verts_.insert(verts_.end(), v, v + cell.num_verts);
    num_negative_ += make_volume_positive(s, verts_.data() + first, points_);
    for (unsigned f = 0; f < cell.num_faces; ++f) corners_ += cell.face_size[f];
    all_faces_ += cell.num_faces;
    end_cell(s);
    return true;
  }

  /// Adds all cells of a volume that has cells of one shape only. Needs: no cell was added before.
  /// Result: the number of cells; less if one is not valid, as for add_cell: then its position.
  std::size_t add_all_cells(cell_shape s, std::vector<vert_id>&& verts) {
    const standard_cell& cell = standard_cell_of(s);
    verts_ = std::move(verts);
    const std::size_t n = verts_.size() / cell.num_verts;
    for (std::size_t c = 0; c < n; ++c) {
      vert_id* const v = verts_.data() + c * cell.num_verts;
      const std::size_t k = first_repeated(v, cell.num_verts, scratch_);
      if (k != cell.num_verts ? !reject_repeated(v[k], "a cell") : !can_hold(s) && !reject(cell.name, cell.num_faces)) return c;
      num_negative_ += make_volume_positive(s, v, points_);
    }
    for (unsigned f = 0; f < cell.num_faces; ++f) corners_ += n * cell.face_size[f];
    if (verts_.size() > max_ids || corners_ > max_ids) core::throw_joined<unsupported>({in_.name, ": more than ", max_ids, " corners of faces"});
    all_faces_ = n * cell.num_faces;
    only_ = s;
    cells_ = n;
    return n;
  }

  /// Adds a face of the next polyhedron.
  void add_face(const vert_id* v, std::size_t n) {
    if (faces_ == 0) {
      first_ = verts_.size();
      verts_.push_back({});
      failed_ = false;
    }
    if (failed_) return;
    if (n < 3) failed_ = !reject_with({"a face of at least three verts"}, {"one of ", n});
    else if (const std::size_t k = first_repeated(v, n, scratch_); k != n) failed_ = !reject_repeated(v[k], "a face");
    ++faces_;
    face_keys_.push_back(face_key(v, n));
    verts_.push_back(vert_id{n});
    verts_.insert(verts_.end(), v, v + n);
    corners_ += n;
  }

  /// Ends a polyhedron. Returns false if it has no face, a face of fewer than three verts, a face or a vert of a face twice, or if the wanted mesh
  /// cannot hold it.
  bool end_polyhedron() {
    if (faces_ == 0) return reject_with({"a polyhedron of at least one face"}, {"one without faces"});
    verts_[first_] = vert_id{faces_};
    const std::size_t faces = std::exchange(faces_, 0);
    core::sort_numbers(face_keys_.data(), face_keys_.data() + face_keys_.size());
    const bool has_twins = std::adjacent_find(face_keys_.begin(), face_keys_.end()) != face_keys_.end();
    face_keys_.clear();
    if (failed_ || has_twins) verts_.resize(first_);
    if (failed_) return false;
    if (has_twins) return reject_with({"different faces in a polyhedron"}, {"two with the same verts"});
    if (in_.wanted.cells && !in_.wanted.polyhedra) return add_recognised(faces);
    ++num_general_;
    all_faces_ += faces;
    end_cell(cell_shape::general);
    return true;
  }

  /// Moves the points and the cells into the contents.
  void finish(Contents& out) {
    const std::size_t arity = cells_ && only_ != cell_shape::general ? standard_cell_of(only_).num_verts : 0;
    const bool fits = in_.wanted.cells && shapes_.empty() && (cells_ == 0 || arity == 4 || arity == 8);
    out.filled = fits ? arrays_kind::cells : arrays_kind::polyhedra;
    if (fits) out.cells = cell_arrays{std::move(points_), std::move(verts_), arity ? static_cast<std::uint32_t>(arity) : in_.wanted.arity ? in_.wanted.arity : 4};
    else out.polyhedra = polyhedra();
    report_reoriented();
  }

 private:
  /// The number of verts that every cell must have: that of the wanted mesh, else that of the cells so far, else the one given.
  std::uint32_t wanted_arity(std::uint32_t otherwise) const {
    return in_.wanted.arity ? in_.wanted.arity : cells_ ? standard_cell_of(only_).num_verts : otherwise;
  }

  void end_cell(cell_shape s) {
    if (verts_.size() > max_ids || corners_ > max_ids) core::throw_joined<unsupported>({in_.name, ": more than ", max_ids, " corners of faces"});
    if (cells_ == 0) only_ = s;
    if (s != only_ && shapes_.empty()) shapes_.assign(cells_, static_cast<std::uint8_t>(only_));
    if (!shapes_.empty()) shapes_.push_back(static_cast<std::uint8_t>(s));
    ++cells_;
  }

  [[gnu::noinline, gnu::cold]] bool reject_with(core::message what, core::message instead) {
    expected = core::joined(what);
    found = core::joined(instead);
    return false;
  }
  [[gnu::noinline, gnu::cold]] bool reject_repeated(vert_id v, const char* where) {
    return reject_with({"different verts in ", where}, {"vert ", v.raw() + first_number_, " twice"});
  }
  [[gnu::noinline, gnu::cold]] bool reject(const char* shape, std::size_t faces) {
    return reject_with({name_of_poly(true, wanted_arity(4)), " (polyhedralmesh and load_any take any cell)"}, {"a ", shape, " of ", faces, " faces"});
  }

  /// Replaces the polyhedron at the end of the list by a tet or a hex.
  bool add_recognised(std::size_t faces) {
    face_soup soup;
    decode(soup, verts_.data() + first_);
    verts_.resize(first_);
    std::vector<vert_id> all = soup.face_verts;  // the verts of the polyhedron, which are numbered from 0 below
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    for (vert_id& v : soup.face_verts) v = vert_id{static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), v) - all.begin())};
    std::vector<vec3> local;
    for (const vert_id v : all) local.push_back(points_[v.raw()]);
    polyhedra_arrays one = std::move(soup).unite(std::move(local));
    const bool turned = orient_polyhedra(one) != 0;
    cell_recogniser known;
    const cell_shape s = recognise(one, 0, known);
    if (s == cell_shape::general || !can_hold(s)) return reject(s == cell_shape::general ? "polyhedron" : standard_cell_of(s).name, faces);
    num_turned_ += turned;
    for (unsigned i = 0; i < standard_cell_of(s).num_verts; ++i) verts_.push_back(all[known.cell[i].raw()]);
    end_cell(s);
    return true;
  }

  /// Adds a polyhedron to a soup of faces. Returns the end of its list.
  static const vert_id* decode(face_soup& soup, const vert_id* v) {
    const std::uint32_t faces = v++->raw();
    for (std::uint32_t f = 0; f < faces; ++f) {
      const std::uint32_t n = v++->raw();
      soup.face_verts.insert(soup.face_verts.end(), v, v + n);
      soup.face_offsets.push_back(static_cast<std::uint32_t>(soup.face_verts.size()));
      v += n;
    }
    soup.poly_offsets.push_back(static_cast<std::uint32_t>(soup.face_offsets.size() - 1));
    return v;
  }

  [[gnu::noinline, gnu::cold]] void report_reoriented() {
    load_report& r = *in_.report;
    r.reoriented_polys += num_negative_ + num_turned_;
    if (num_negative_) r.notes.push_back(core::joined({num_negative_, " of ", cells_, " cells had a negative volume: their verts were put into the standard order"}));
    if (num_turned_) r.notes.push_back(core::joined({num_turned_, " of ", cells_, " polyhedra were wound inconsistently or inside out: their faces were turned outward"}));
  }

  polyhedra_arrays polyhedra() {
    face_soup soup;
    soup.reserve(cells_, all_faces_, corners_);
    const vert_id* v = verts_.data();
    for (std::size_t p = 0; p < cells_; ++p) {
      const cell_shape shape = shapes_.empty() ? only_ : static_cast<cell_shape>(shapes_[p]);
      if (shape == cell_shape::general) {
        v = decode(soup, v);
      } else {
        soup.add_cell(shape, v);
        v += standard_cell_of(shape).num_verts;
      }
    }
    std::vector<vert_id>().swap(verts_);
    polyhedra_arrays m = std::move(soup).unite(std::move(points_));
    if (num_general_) num_turned_ += orient_polyhedra(m);
    return m;
  }
};

}  // namespace concino::detail
