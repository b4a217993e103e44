// What the readers of formats of verts, faces and polyhedra have in common.
#pragma once

#include <concino/io/detail/cells/canonical_cells.hpp>
#include <concino/io/detail/cells/orient.hpp>
#include <concino/io/detail/cells/repeated_faces.hpp>
#include <concino/io/detail/formats/contents.hpp>
#include <concino/io/detail/text/text_sample.hpp>
#include <concino/io/text_cursor.hpp>
#include <concino/mesh/support/limits.hpp>

namespace concino::detail {

/// Reads lists of verts, faces and polyhedra whose indices count from First. Contents is volume_contents; a template
/// only so that programs that read no volumes need not compile it.
template<class Contents, std::uint32_t First>
class polyhedra_reader : protected token_cursor {
  const wanted_mesh& wanted_;
  const char* first_poly_ = nullptr;
  unsigned lists_per_poly_ = 1;
  std::vector<std::uint32_t> last_poly_;  // the last poly that had each face
  std::uint64_t poly_corners_ = 0;
  bool has_repeated_ = false;  // a face has a vert twice

  /// The expected number of entries of n lists, estimated from the first few; no more than the text can hold.
  std::size_t expected(std::size_t entries, std::uint64_t lists, std::uint64_t n) const {
    const double all = static_cast<double>(entries) / static_cast<double>(lists) * static_cast<double>(n);
    return entries + std::min(with_margin(all), static_cast<std::size_t>(end() - at) / 2 + 1);
  }

 protected:
  load_report& report_;
  polyhedra_arrays out_;
  polys_with_repeats repeated_;

  explicit polyhedra_reader(const read_context& c)
      : token_cursor(text_without_padding(c.text), c.name, c.progress, 0), wanted_(c.wanted), report_(*c.report) {
    repeated_.policy = c.repeated_verts;
  }

  void verts(std::uint64_t n) {
    out_.points.reserve(reservable(n, 6));
    for (std::uint64_t i = 0; i < n; ++i) {
      vec3 p;
      p.x = next_real("the x of a vert");
      p.y = next_real("the y of a vert");
      p.z = next_real("the z of a vert");
      out_.points.push_back(p);
      report_progress();
    }
  }

  void faces(std::uint64_t n) {
    faces(n, [&](std::uint64_t size) {
      for (std::uint64_t i = 0; i < size; ++i)
        out_.face_verts.push_back(vert_id{next_index(out_.points.size(), "a vert index", First)});
    });
  }
  /// The same with a function that reads the corners of a face, so many, and adds their verts.
  template<class ReadCorners>
  void faces(std::uint64_t n, const ReadCorners& read_corners) {
    std::vector<std::uint64_t> scratch;
    out_.face_offsets.reserve(reservable(n, 8) + 1);
    out_.face_offsets.push_back(0);
    for (std::uint64_t f = 0; f < n; ++f) {
      skip();
      const char* const from = at;
      const std::uint64_t size = next_count("the number of verts of a face", 2);
      if (size < 3) fail(from, {"a face of at least three verts"}, {"one of ", size});
      read_corners(size);
      const vert_id* const corners = out_.face_verts.data() + (out_.face_verts.size() - size);
      if (const std::size_t i = first_repeated(corners, size, scratch); i != size) {
        if (repeated_.policy == repeated_verts::refuse)
          fail(from, {"different verts at the corners of a face", repeated_verts_hint},
               {"vert ", corners[i].raw() + First, " twice"});
        has_repeated_ = true;
      }
      if (out_.face_verts.size() > max_ids) fail_to_count("corners");
      if (f == 4095) out_.face_verts.reserve(expected(out_.face_verts.size(), f + 1, n));
      out_.face_offsets.push_back(static_cast<std::uint32_t>(out_.face_verts.size()));
      report_progress();
    }
  }

  /// Begins the list of n polyhedra, each of which has so many lists of numbers.
  void begin_polys(std::uint64_t n, unsigned lists_per_poly) {
    skip();
    first_poly_ = at;
    lists_per_poly_ = lists_per_poly;
    last_poly_.assign(out_.num_faces(), ~0u);
    out_.poly_offsets.reserve(reservable(n, 4 * lists_per_poly) + 1);
    out_.poly_offsets.push_back(0);
  }
  /// Reads the number of faces of a polyhedron.
  std::uint64_t poly_size() {
    skip();
    const char* const from = at;
    const std::uint64_t size = next_count("the number of faces of a polyhedron", 2);
    if (size == 0) fail(from, {"a polyhedron of at least one face"}, {"one without faces"});
    return size;
  }
  /// Adds face k to the last polyhedron.
  void add_face(const char* position, std::size_t k) {
    const auto p = static_cast<std::uint32_t>(out_.poly_offsets.size() - 1);
    if (last_poly_[k] == p) fail(position, {"different faces in a polyhedron"}, {"face ", k + First, " twice"});
    last_poly_[k] = p;
    poly_corners_ += out_.face_offsets[k + 1] - out_.face_offsets[k];
    out_.poly_faces.push_back(face_id{k});
  }
  /// Ends a polyhedron of n.
  void end_poly(std::uint64_t n) {
    if (out_.poly_faces.size() > max_ids) fail_to_count("faces of polyhedra");
    if (const std::size_t p = out_.num_polys(); p == 4095) {
      out_.poly_faces.reserve(expected(out_.poly_faces.size(), p + 1, n));
      out_.outward.reserve(out_.poly_faces.capacity());
    }
    out_.poly_offsets.push_back(static_cast<std::uint32_t>(out_.poly_faces.size()));
    report_progress();
  }
  void end_polys() {
    std::vector<std::uint32_t>().swap(last_poly_);
    check_poly_corners(poly_corners_, out_.face_verts.size(), out_.poly_faces.size(), core::joined({name(), ": "}));
    if (has_repeated_) faces_mender<polyhedra_arrays>(out_, repeated_).mend();
  }

  void orient_polys() {
    report_.reoriented_polys = orient_polyhedra(out_);
    if (report_.reoriented_polys)
      report_.notes.push_back(
          core::joined({report_.reoriented_polys, " of ", out_.num_polys(),
                        " polyhedra were wound inconsistently or inside out: their faces were turned outward"}));
  }
  void finish(Contents& out) {
    out.filled = wanted_.polyhedra ? arrays_kind::polyhedra : arrays_kind::cells;
    if (wanted_.polyhedra) out.polyhedra = std::move(out_);
    else out.cells = cells();
    out.repeated = std::move(repeated_);
  }

 private:
  const char* position_of_poly(std::size_t p) {
    for (const std::uint32_t dropped : repeated_.dropped) p += dropped <= p;  // its number in the file
    at = first_poly_;
    const char* position = at;
    for (std::size_t q = 0; q <= p; ++q)
      for (unsigned list = 0; list < lists_per_poly_; ++list) {
        skip();
        if (list == 0) position = at;
        for (std::int64_t i = next_integer("a number"); i > 0; --i) next_integer("a number");
      }
    return position;
  }

  /// The polyhedra as cells in the standard order, for meshes of only tets or only hexes.
  cell_arrays cells() {
    cell_recogniser known;
    cell_arrays cells;
    cells.arity = wanted_.arity;
    for (std::size_t p = 0; p < out_.num_polys(); ++p) {
      const cell_shape s = recognise(out_, p, known);
      const std::uint32_t n = s == cell_shape::tet ? 4 : s == cell_shape::hex ? 8 : 0;
      if (cells.arity == 0) cells.arity = n;
      if (n == 0 || n != cells.arity) {
        fail(position_of_poly(p),
             {name_of_poly(true, cells.arity ? cells.arity : 4), " (polyhedralmesh and load_any take any polyhedron)"},
             {"a ", s == cell_shape::general ? "polyhedron" : standard_cell_of(s).name, " of ",
              out_.poly_offsets[p + 1] - out_.poly_offsets[p], " faces"});
      }
      match_face_order(s, known.cell, [&](std::size_t k, vert_id v) {
        const std::size_t f = out_.poly_faces[out_.poly_offsets[p] + k].raw();
        const vert_id *const first = out_.face_verts.data() + out_.face_offsets[f], *const last =
                                                                                        out_.face_verts.data() +
                                                                                        out_.face_offsets[f + 1];
        return std::find(first, last, v) != last;
      });
      for (std::uint32_t k = 0; k < n; ++k) cells.verts.push_back(known.cell[k]);
    }
    if (cells.arity == 0) cells.arity = 4;
    report_.skipped.push_back("the numbering of the faces");
    cells.points = std::move(out_.points);
    return cells;
  }
};

}  // namespace concino::detail
