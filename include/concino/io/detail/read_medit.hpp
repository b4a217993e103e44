// The reader of MEDIT .mesh, ASCII: triangles and quads, or tets, hexes, prisms and pyramids, with labels ("references").
#pragma once

#include <concino/io/detail/cell_builder.hpp>
#include <concino/io/detail/contents.hpp>
#include <concino/io/detail/medit_format.hpp>
#include <concino/io/detail/medit_sections.hpp>
#include <concino/io/text_cursor.hpp>

namespace concino::detail {

/// Reads a MEDIT file. Programs that read only surfaces need not compile the code for volumes.
template<bool Volumes>
class medit_reader : token_cursor {
  const wanted_mesh& wanted_;
  load_report& report_;
  int dimension_ = 0;
  bool has_verts_ = false, ended_ = false;
  std::vector<vec3> points_;
  std::vector<int> vert_labels_, poly_labels_;
  surface_arrays surface_;
  std::uint32_t arity_ = 0;  // of the polygons, as long as they have the same
  std::size_t polys_ = 0;
  std::uint64_t num_rounded_ = 0;          // references that are not integers
  const char* first_rounded_ = nullptr;

  struct part {
    const medit_section* section;
    const char* at;  // before the count
    std::uint64_t count;
  };
  std::vector<part> deferred_;  // sections of surfaces, until it is known that there are no cells; sections of cells before the verts

  struct no_cells {
    no_cells(const read_context&, std::vector<vec3>&, std::size_t) {}
  };
  std::conditional_t<Volumes, cell_builder<volume_contents>, no_cells> cells_;

 public:
  medit_reader(const read_context& c) : token_cursor(c.text, c.name, c.progress, '#'), wanted_(c.wanted), report_(*c.report), cells_(c, points_, 1) {}

  void read(contents_of<Volumes>& out) {
    skip();
    if (at_end()) fail(end(), "MeshVersionFormatted");
    const char* const from = at;
    if (word() != "MeshVersionFormatted") fail(from, "MeshVersionFormatted (MEDIT in ASCII)");
    next_integer("the version of the format, an integer");
    while (!ended_) {
      skip();
      if (at_end()) break;
      section();
    }
    if (!ended_) report_.notes.push_back("the file has no End: it may be cut off");
    if (!has_verts_) fail(end(), "a section Vertices");
    finish(out);
  }

 private:
  [[gnu::noinline, gnu::cold]] void section() {
    const char* const from = at;
    const std::string_view keyword = is_letter(*at) ? word() : std::string_view{};
    if (keyword == "End") {
      ended_ = true;
    } else if (keyword == "Dimension") {
      skip();
      const char* const number = at;
      dimension_ = static_cast<int>(std::clamp<std::int64_t>(next_integer("the dimension, 2 or 3"), 0, 4));
      if (dimension_ != 2 && dimension_ != 3) fail(number, "the dimension, 2 or 3");
    } else if (keyword == "Vertices") {
      if (dimension_ == 0) fail(from, "Dimension before Vertices");
      if (has_verts_) fail(from, {"one section Vertices"}, {"another"});
      vertices();
    } else if (keyword.empty()) {
      fail(from, "a keyword, such as Tetrahedra or End");
    } else {
      for (const medit_section& s : medit_sections)
        if (keyword == s.keyword) {
          const part here{&s, at, next_count("the number of elements", 2 * s.arity + 2)};
          if (Volumes && s.volume && has_verts_) {
            elements(here);
          } else {
            deferred_.push_back(here);
            skip_section();
          }
          return;
        }
      skip();
      std::int64_t n = 0;
      parse_integer(at, end(), n);  // most sections begin with the number of their rows
      report_skipped(keyword.substr(0, 40), n > 0 ? static_cast<std::uint64_t>(n) : 0);
      skip_section();
    }
  }

  /// Moves to the next word that begins with a letter.
  [[gnu::noinline]] void skip_section() {
    for (bool after_space = true; !at_end(); ++at) {
      if (*at == comment) {
        skip_line();
        if (at_end()) return;
        after_space = true;
      } else if (is_space(*at)) {
        after_space = true;
        report_progress();
      } else {
        if (after_space && is_letter(*at)) return;
        after_space = false;
      }
    }
  }

  [[gnu::noinline, gnu::cold]] void report_skipped(std::string_view keyword, std::uint64_t rows) {
    report_.skipped.push_back(rows ? core::joined({"section ", keyword, ", ", rows, " rows"}) : core::joined({"section ", keyword}));
  }

  int next_label(const char* what) {
    skip();
    const char* const from = at;
    std::int64_t label = 0;
    const char* const p = parse_integer(at, end(), label);
    if (p && ends_token(p, comment)) [[likely]] at = p;
    else label = real_label(what);
    if (label < std::numeric_limits<int>::min() || label > std::numeric_limits<int>::max()) fail(from, {what, " of 32 bits"});
    return static_cast<int>(label);
  }

  /// Reads a reference that is a real number, as some programs write them. If it exceeds 32 bits, the result does too.
  [[gnu::noinline, gnu::cold]] std::int64_t real_label(const char* what) {
    const char* const from = at;
    const double x = std::clamp(real(what, comment), -0x1p40, 0x1p40), rounded = std::round(x);
    if (x != rounded && num_rounded_++ == 0) first_rounded_ = from;
    return static_cast<std::int64_t>(rounded);
  }

  /// Adds the label of element n. Labels are stored only if one of them is not zero.
  static void add_label(std::vector<int>& labels, std::size_t n, int label) {
    if (label == 0 && labels.empty()) return;
    labels.resize(n);
    labels.push_back(label);
  }

  std::uint64_t min_bytes() const { return static_cast<std::uint64_t>(2 * dimension_ + 2); }  // of a vertex: its digits and blanks

  void vertices() {
    const std::uint64_t n = next_count("the number of vertices", min_bytes());
    core::reserve_large(points_, reservable(n, min_bytes()));
    for (std::uint64_t i = 0; i < n; ++i) {
      vec3 p;
      p.x = next_real("the x of a vertex");
      p.y = next_real("the y of a vertex");
      if (dimension_ == 3) p.z = next_real("the z of a vertex");
      points_.push_back(p);
      add_label(vert_labels_, i, next_label("the reference of a vertex, an integer"));
      report_progress();
    }
    has_verts_ = true;
  }

  void elements(const part& all) {
    const medit_section& s = *all.section;
    if (all.count == 0) return;
    skip();
    if constexpr (Volumes)
      if (s.volume && !cells_.can_hold(s.shape)) throw_wrong_arity_of(s, wanted_.arity ? wanted_.arity : polys_ ? cells_.arity() : s.arity);
    if (!s.volume && wanted_.surface && wanted_.arity && s.arity != wanted_.arity) throw_wrong_arity_of(s, wanted_.arity);
    if constexpr (Volumes) {
      if (s.volume) cells_.reserve(s.shape, reservable(all.count, 2 * s.arity + 2));
    }
    if (!s.volume) core::reserve_large(surface_.verts, surface_.verts.size() + reservable(all.count, 2 * s.arity + 2) * s.arity);
    for (std::uint64_t i = 0; i < all.count; ++i) {
      skip();
      const char* const from = at;
      vert_id corners[8];
      for (std::uint32_t k = 0; k < s.arity; ++k) corners[k] = vert_id{next_index(points_.size(), "a vertex index")};
      if constexpr (Volumes) {
        if (s.volume && !cells_.add_cell(s.shape, corners)) fail(from, {cells_.expected}, {cells_.found});
      }
      if (!s.volume) add_polygon(from, corners, s.arity);
      add_label(poly_labels_, polys_ + i, next_label("the reference of an element, an integer"));
      report_progress();
    }
    polys_ += all.count;
  }

  void add_polygon(const char* from, const vert_id* corners, std::uint32_t n) {
    std::vector<std::uint64_t> unused;
    if (const std::size_t k = first_repeated(corners, n, unused); k != n)
      fail(from, {"different verts in an element"}, {"vert ", corners[k].raw() + 1, " twice"});
    const std::size_t first = surface_.verts.size();
    surface_.verts.insert(surface_.verts.end(), corners, corners + n);
    end_poly(surface_, arity_, first);
    if (surface_.verts.size() > max_ids) fail_to_count("corners");
  }

  [[noreturn, gnu::noinline, gnu::cold]] void throw_wrong_arity_of(const medit_section& s, std::uint32_t arity) const {
    fail(at,
         {name_of_poly(s.volume, arity),
          s.volume ? " (polyhedralmesh and load_any take any cell)" : " (polygonmesh and load_any take any polygon)"},
         {"an element of section ", s.keyword});
  }

  [[gnu::noinline, gnu::cold]] void finish(contents_of<Volumes>& out) {
    bool has_cells = polys_ > 0;
    for (const part& p : deferred_) has_cells = has_cells || (p.section->volume && p.count > 0);
    for (const part& p : deferred_) {
      if (p.section->volume != has_cells) {
        if (p.count > 0) report_skipped(p.section->keyword, p.count);
        continue;
      }
      // If the file has the wrong kind of mesh, the error that load() throws is clearer than the line of one element.
      if (has_cells ? !Volumes : !wanted_.surface) {
        polys_ += p.count;
        continue;
      }
      at = p.at;
      next_count("the number of elements", 2 * p.section->arity + 2);
      elements(p);
    }
    if (num_rounded_)
      report_.notes.push_back(
          core::joined({num_rounded_, " references are not integers and were rounded, the first on line ", line_of(first_rounded_)}));
    if (has_cells && !Volumes) throw_wrong_dimension(name(), true, polys_);
    if (!has_cells && !wanted_.surface && polys_ > 0) throw_wrong_dimension(name(), false, polys_);

    if (!vert_labels_.empty()) vert_labels_.resize(points_.size());
    if (!poly_labels_.empty()) poly_labels_.resize(polys_);
    out.vert_labels = std::move(vert_labels_);
    out.poly_labels = std::move(poly_labels_);
    const bool volume = has_cells || !wanted_.surface;
    if (!volume) out.surface = surface();
    if constexpr (Volumes)
      if (volume) cells_.finish(out);
  }

  surface_arrays surface() {
    surface_.points = std::move(points_);
    if (surface_.offsets.empty()) surface_.arity = polys_ ? arity_ : wanted_.arity;
    if (surface_.offsets.empty() && surface_.arity == 0) surface_.offsets.push_back(0);
    return std::move(surface_);
  }
};

}  // namespace concino::detail

namespace concino {

/// Needs:  text of a MEDIT file: keywords, counts and rows in any layout, sections in any order, `#` comments, Dimension 2 (z is 0) or 3.
/// Result: a volume if there is any cell, else a surface. Elements keep their order. The verts of cells of negative volume are put into the
///         standard order, and these cells are counted. References become labels unless all are zero; those that are not integers are rounded
///         and counted. Surface elements of a volume, and sections that a mesh cannot store, are reported as skipped.
/// Cost:   O(size of the text)
/// Errors: parse_error naming the line of a wrong number, an index out of range, an element with a vertex twice, an element that the
///         wanted mesh cannot hold, or the end of a file that is cut off; unsupported if the file holds a volume and a surface was wanted,
///         or the reverse.
template<std::derived_from<file_contents> Contents>
void medit_format::read(const read_context& in, Contents& out) {
  detail::medit_reader<std::is_same_v<Contents, volume_contents>>(in).read(out);
}

}  // namespace concino
