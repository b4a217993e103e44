// The reader of MEDIT files, text and binary: surfaces, or volumes of tets, hexes, prisms and pyramids, with references
// and marks of all elements.
#pragma once

#include <concino/io/cell_builder.hpp>
#include <concino/io/detail/formats/contents.hpp>
#include <concino/io/detail/medit/medit_binary.hpp>
#include <concino/io/detail/medit/medit_format.hpp>
#include <concino/io/detail/medit/medit_listed_reader.hpp>
#include <concino/io/detail/medit/medit_text.hpp>

namespace concino::detail {

/// Reads a MEDIT file. Programs that read only surfaces need not compile the code for volumes. Cursor is medit_text or
/// medit_binary.
template<bool Volumes, class Cursor>
class medit_reader : medit_listed_reader<Cursor> {
  using base = medit_listed_reader<Cursor>;
  using base::at, base::end, base::fail, base::position, base::reference;
  using base::edges_, base::marks_, base::nodes_, base::points_, base::scratch_;
  using base::list, base::mark, base::next_element, base::next_reference, base::next_vector, base::numbers_of,
      base::takes_repeated;

  const wanted_mesh& wanted_;
  load_report& report_;
  contents_of<Volumes>& out_;
  bool has_verts_ = false;
  std::vector<int> vert_labels_, poly_labels_;
  medit_polygons surface_;
  std::size_t polys_ = 0;
  std::vector<medit_section_header> deferred_;  // all sections but cells after the verts: their meaning depends on
                                                // whether there are cells
  bool corners_only_;

  struct no_cells {
    no_cells(const read_context&, std::vector<vec3>&, std::size_t) {}
  };
  std::conditional_t<Volumes, cell_builder, no_cells> cells_;

 public:
  medit_reader(const read_context& c, contents_of<Volumes>& out)
      : base(c, out), wanted_(c.wanted), report_(*c.report), out_(out), corners_only_(c.corners_only),
        cells_(c, points_, 1) {}

  void read() {
    this->begin_file();
    for (medit_section_header header; this->next_section(header);) {
      if (!header.section) {
        vertices(header);
      } else if (header.section->nodes && !corners_only_) {
        reject_nodes(header);
        this->skip_rows();
      } else if (Volumes && header.section->is_volume() && has_verts_) {
        elements(header);
      } else {
        deferred_.push_back(header);
        this->skip_rows();
      }
    }
    this->end_file();
    if (!has_verts_) fail(end(), {"a section Vertices"});
    finish();
  }

 private:
  void report_skipped(const medit_section_header& header) {
    if (header.count > 0)
      report_.skipped.push_back(core::joined({"section ", header.section->keyword, ", ", header.count, " rows"}));
  }

  /// Errors: unsupported for elements of second or higher order, but for edges, which are skipped.
  void reject_nodes(const medit_section_header& header) {
    const medit_section& s = *header.section;
    if (header.count == 0 || s.rows == medit_rows::edges) return report_skipped(header);
    core::throw_joined<unsupported>({this->name(), ": section ", s.keyword, " has ", header.count,
                                     s.keyword.back() == '2' ? " second-order" : " higher-order",
                                     " elements, with nodes on edges; ", read_corners_instead});
  }

  /// Adds the label of element n. Labels are stored only if one of them is not zero.
  static void add_label(std::vector<int>& labels, std::size_t n, int label) {
    if (label == 0 && labels.empty()) return;
    labels.resize(n);
    labels.push_back(label);
  }

  void vertices(const medit_section_header& header) {
    if (has_verts_) fail(header.at, {"one section Vertices"}, {"another"});
    points_.reserve(this->room_for(header, static_cast<std::uint64_t>(this->dimension_) + 1));
    for (std::uint64_t i = 0; i < header.count; ++i) {
      points_.push_back(next_vector("the x of a vertex", "the y of a vertex", "the z of a vertex"));
      add_label(vert_labels_, i, reference("the reference of a vertex, an integer"));
      this->report_progress();
    }
    has_verts_ = true;
  }

  /// Reads polys.
  void elements(const medit_section_header& header) {
    const medit_section& s = *header.section;
    if (header.count == 0) return;
    position();
    const std::size_t room = this->room_for(header, s.num_indices() + 1);
    if constexpr (Volumes)
      if (s.is_volume()) {
        if (!cells_.can_hold(s.shape) && !takes_repeated())
          throw_wrong_arity_of(s, wanted_.arity ? wanted_.arity : polys_ ? cells_.arity() : s.arity);
        cells_.reserve(s.shape, room);
      }
    if (!s.is_volume()) {
      if (wanted_.surface && wanted_.arity && s.arity != wanted_.arity && !takes_repeated())
        throw_wrong_arity_of(s, wanted_.arity);
      surface_.reserve(room * s.arity);
      numbers_of(s).add(header.count, polys_);
    }
    for (std::uint64_t i = 0; i < header.count; ++i) {
      vert_id corners[8];
      const char* const from = next_element(s, corners);
      if constexpr (Volumes)
        if (s.is_volume() && !cells_.add_cell(s.shape, corners)) fail(from, {cells_.expected}, {cells_.found});
      if (!s.is_volume()) add_polygon(from, corners, s.arity, polys_ + i);
      add_label(poly_labels_, polys_ + i, next_reference());
      this->report_progress();
    }
    polys_ += header.count;
  }

  void add_polygon(const char* from, const vert_id* corners, std::uint32_t n, std::size_t poly) {
    check_read_polygon(
        out_, wanted_, corners, n, {.different = "different verts in an element", .first = 1}, scratch_,
        [&](core::message expected, core::message found) { fail(from, expected, found); }, [&] { return poly; },
        [&] { return this->describe_position(from); });
    surface_.add(corners, n);
    if (surface_.size_of_lists() > max_ids) this->fail_to_count("corners");
  }

  [[noreturn, gnu::noinline, gnu::cold]] void throw_wrong_arity_of(const medit_section& s, std::uint32_t arity) const {
    fail(at,
         {name_of_poly(s.is_volume(), arity), s.is_volume() ? " (polyhedralmesh and load_any take any cell)"
                                                            : " (polygonmesh and load_any take any polygon)"},
         {"an element of section ", s.keyword});
  }

  /// Whether a section of this kind waits that is not empty.
  bool has_deferred(medit_rows rows) const {
    return std::any_of(deferred_.begin(), deferred_.end(),
                       [&](const medit_section_header& p) { return p.section->rows == rows && p.count > 0; });
  }

  /// Reads the sections that waited until the verts were read and it was known whether there are cells.
  void read_deferred(bool has_cells) {
    // If the file has the wrong kind of mesh, the error that load() throws is clearer than the line of one element.
    const bool is_wanted = has_cells ? Volumes : wanted_.surface || !has_deferred(medit_rows::polygons);
    for (const medit_section_header& p : deferred_) {
      const medit_rows rows = p.section->rows;
      at = p.at;
      if (rows == medit_rows::cells || (rows == medit_rows::polygons && !has_cells)) {
        if (is_wanted) elements(p);
        else polys_ += p.count;
      } else if (!is_wanted) {
        continue;
      } else if (rows == medit_rows::polygons) {
        list(p, element_kind::face, out_.faces, numbers_of(*p.section));
      } else if (rows == medit_rows::edges) {
        list(p, element_kind::edge, out_.edges, edges_);
      } else if (rows == medit_rows::normals) {
        this->read_normals(p);
      }
    }
    bool uses_normals = false;
    for (const medit_section_header& p : deferred_) {
      if (!is_wanted) continue;
      at = p.at;
      if (p.section->rows == medit_rows::normals_at_verts) {
        uses_normals = true;
        this->read_normals_at_verts(p);
      } else if (p.section->mark) {
        mark(p, has_cells);
      }
    }
    for (const medit_section_header& p : deferred_)
      if (p.section->rows == medit_rows::normals && !uses_normals) report_skipped(p);
  }

  void finish() {
    const bool has_cells = polys_ > 0 || has_deferred(medit_rows::cells);
    read_deferred(has_cells);
    this->report_rounded();
    if (has_cells && !Volumes) throw_wrong_dimension(this->name(), true, polys_);
    if (!has_cells && !wanted_.surface && polys_ > 0) throw_wrong_dimension(this->name(), false, polys_);

    if (!vert_labels_.empty()) vert_labels_.resize(points_.size());
    if (!poly_labels_.empty()) poly_labels_.resize(polys_);
    out_.vert_labels = std::move(vert_labels_);
    out_.poly_labels = std::move(poly_labels_);
    marks_.store(element_kind::vert, points_.size(), false, out_);
    marks_.store(element_kind::poly, polys_, false, out_);
    marks_.store(element_kind::edge, out_.edges.size(), true, out_);
    marks_.store(element_kind::face, out_.faces.size(), true, out_);
    const bool volume = has_cells || !wanted_.surface;
    if (!volume) out_.surface = std::move(surface_).finish(std::move(points_), wanted_.arity);
    if constexpr (Volumes)
      if (volume) cells_.finish(out_);
    if (nodes_.any() && this->has_ordering_)
      core::throw_joined<unsupported>({this->name(),
                                       ": has elements of second or higher order, and "
                                       "a section that lists the order of their nodes: corners need not come first"});
    nodes_.remove(out_, report_);
  }
};

}  // namespace concino::detail

namespace concino {

/// Needs:  a MEDIT file. As text: keywords, counts and rows in any layout, sections in any order, `#` comments. Binary:
///         versions 1 to 4 in either byte order. Dimension 2 (z is 0) or 3.
/// Result: a volume if there is any cell, else a surface. Elements keep their order. The verts of cells of negative
///         volume are put into the standard order, and these cells are counted. References become "label" of verts,
///         polys, edges, and faces of a volume, unless all are zero; those that are not integers are rounded and
///         counted. Marks become properties (int) of verts ("corner", "required"), edges ("ridge", "required") and
///         triangles and quads ("required"). If the file lists edges or faces without any of these, they and the others
///         listed have the property "entity". Normals at vertices become "normal" of verts. Elements of second or
///         higher order are read by their corners, if load_options::corners_only is set; points that are only their
///         other nodes are reported as skipped. Other sections are reported as skipped, as are edges and faces that the
///         mesh does not have.
/// Cost:   O(size of the text)
/// Errors: parse_error naming the line (of binary files the byte) of a wrong number, an index out of range, an element
///         with a vertex twice, an element that the wanted mesh cannot hold, or the end of a file that is cut off;
///         unsupported if the file holds a volume and a surface was wanted, or the reverse, or if it has polys of
///         second or higher order.
template<std::derived_from<file_contents> Contents>
void medit_format::read(const read_context& in, Contents& out) {
  constexpr bool volumes = std::is_same_v<Contents, volume_contents>;
  if (detail::is_binary_medit(in.text)) detail::medit_reader<volumes, detail::medit_binary>(in, out).read();
  else detail::medit_reader<volumes, detail::medit_text>(in, out).read();
}

}  // namespace concino
