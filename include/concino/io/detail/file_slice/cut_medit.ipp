// Bodies of file_slice.hpp: cuts slices out of binary MEDIT files.
#pragma once

#include <concino/io/detail/file_slice/file_slice.hpp>
#include <concino/io/detail/medit/medit_binary.hpp>
#include <concino/io/detail/medit/medit_output.hpp>
#include <concino/io/text_sink.hpp>

#include <algorithm>
#include <utility>

namespace concino::detail {

/// Writes one slice of a MEDIT file: the rows of its sections that are in the slice, with the numbers of its verts.
class medit_cutter : medit_binary {
  struct row_range {
    std::uint64_t first, end;
  };
  struct part {  // of a section
    medit_section_header header;
    std::uint64_t first_row = 0;          // of the section among those of the same elements
    std::vector<std::uint64_t> rows;      // of the slice, if they are not a range
    row_range range{0, 0};                // of the slice, for polys
    bool is_range = false;
  };

  file_slice& out_;
  medit_section_header verts_;
  bool has_verts_ = false, is_volume_ = false;
  bool marks_polygons_ = false;                   // of a surface
  std::vector<part> parts_;                       // of all sections but Vertices, in the order in which polys are read
  std::vector<std::uint64_t> kept_[3], normals_;  // rows of triangles, quads and edges, and normals, of the slice

  std::uint64_t row_size(const medit_section& s) const {
    return s.rows == medit_rows::normals ? std::uint64_t(dimension_) * real_size()
                                         : (s.num_indices() + s.has_reference()) * integer_size();
  }
  bool is_poly(const medit_section& s) const {
    return s.rows == (is_volume_ ? medit_rows::cells : medit_rows::polygons);
  }
  /// The elements that the rows of a section list or mark: triangles, quads, edges.
  static std::size_t elements_of(const medit_section& s) {
    if (s.rows == medit_rows::edges || s.rows == medit_rows::marked_edges) return 2;
    return s.arity == 3 || s.code == 17 ? 0 : 1;
  }

  void find_sections() {
    begin_file();
    std::vector<part> before;  // cells that stand before the verts are read after all others
    for (medit_section_header header; next_section(header);) {
      if (!header.section) {
        if (has_verts_) fail(header.at, {"one section Vertices"}, {"another"});
        verts_ = header;
        has_verts_ = true;
        continue;
      }
      const medit_section& s = *header.section;
      if (s.nodes && header.count > 0 && s.rows != medit_rows::edges)
        core::throw_joined<unsupported>({name(), ": section ", s.keyword,
                                         " has elements of second or higher order, of which slices cannot be read"});
      if (s.nodes && header.count > 0)
        out_.report.skipped.push_back(core::joined({"section ", s.keyword, ", ", header.count, " rows"}));
      if (s.nodes || header.count == 0) continue;
      is_volume_ = is_volume_ || s.is_volume();
      (s.is_volume() && !has_verts_ ? before : parts_).push_back({header, 0, {}, {0, 0}, false});
    }
    if (!has_verts_) fail(end(), {"a section Vertices"});
    parts_.insert(parts_.end(), before.begin(), before.end());
    out_.num_verts = verts_.count;
    std::uint64_t rows[3] = {};
    for (part& p : parts_)
      if (p.header.section->rows == medit_rows::edges || p.header.section->rows == medit_rows::polygons) {
        std::uint64_t& n = rows[elements_of(*p.header.section)];
        p.first_row = n;
        n += p.header.count;
      }
  }

  /// Calls use(row, verts) for some rows of a section of elements.
  template<class Use>
  void for_each_row(const medit_section_header& header, row_range range, const Use& use) {
    const medit_section& s = *header.section;
    std::uint64_t verts[8];
    for (std::uint64_t r = range.first; r < range.end; ++r) {
      at = header.at + r * row_size(s);
      for (std::uint32_t k = 0; k < s.arity; ++k) verts[k] = index(out_.num_verts, "a vertex index");
      use(r, verts);
    }
  }

  void choose_polys(slice_choice choice) {
    for (const part& p : parts_)
      if (is_poly(*p.header.section)) out_.num_polys += p.header.count;
    out_.first_poly = choice.first_of(choice.slice, out_.num_polys);
    const std::uint64_t last = choice.first_of(choice.slice + 1, out_.num_polys);
    std::uint64_t before = 0;
    for (const part& p : parts_)
      marks_polygons_ = marks_polygons_ || (!is_volume_ && p.header.section->rows == medit_rows::marked_polygons);
    for (part& p : parts_) {
      const medit_section& s = *p.header.section;
      if (!is_poly(s)) continue;
      const auto row = [&](std::uint64_t poly) {
        return poly < before ? 0 : std::min(poly - before, p.header.count);
      };
      p.is_range = true;
      p.range = {row(out_.first_poly), row(last)};
      before += p.header.count;
      for_each_row(p.header, p.range, [&](std::uint64_t r, const std::uint64_t* v) {
        for (std::uint32_t k = 0; k < s.arity; ++k) out_.add_vert(v[k]);
        if (marks_polygons_) kept_[elements_of(s)].push_back(p.first_row + r);
      });
    }
    out_.sort_verts();
  }

  /// Finds the edges, and the faces of volumes, whose verts the slice has.
  void choose_listed() {
    for (part& p : parts_) {
      const medit_section& s = *p.header.section;
      if (s.rows != medit_rows::edges && (s.rows != medit_rows::polygons || !is_volume_)) continue;
      for_each_row(p.header, {0, p.header.count}, [&](std::uint64_t r, const std::uint64_t* v) {
        if (!std::all_of(v, v + s.arity, [&](std::uint64_t x) { return out_.has(x); })) return;
        p.rows.push_back(r);
        kept_[elements_of(s)].push_back(p.first_row + r);
      });
    }
  }
  /// Finds the marks of what the slice has, and its normals.
  void choose_marks() {
    const auto has = [](const std::vector<std::uint64_t>& all, std::uint64_t x) {
      return std::binary_search(all.begin(), all.end(), x);
    };
    std::uint64_t rows[3] = {}, num_normals = 0;
    for (const part& p : parts_) {
      const medit_section& s = *p.header.section;
      if (s.rows == medit_rows::edges || s.rows == medit_rows::polygons) rows[elements_of(s)] += p.header.count;
      if (s.rows == medit_rows::normals) num_normals += p.header.count;
    }
    for (part& p : parts_) {
      const medit_section& s = *p.header.section;
      const bool of_verts = s.rows == medit_rows::marked_verts || s.rows == medit_rows::normals_at_verts;
      if (!of_verts && s.rows != medit_rows::marked_edges && s.rows != medit_rows::marked_polygons) continue;
      at = p.header.at;
      for (std::uint64_t r = 0; r < p.header.count; ++r) {
        const std::uint64_t x = of_verts ? index(out_.num_verts, "a vertex index")
                                         : index(rows[elements_of(s)], "the index of an element");
        const bool is_kept = of_verts ? out_.has(x) : has(kept_[elements_of(s)], x);
        if (is_kept) p.rows.push_back(r);
        if (s.rows != medit_rows::normals_at_verts) continue;
        const std::uint64_t normal = index(num_normals, "the index of a normal");
        if (is_kept) normals_.push_back(normal);
      }
    }
    std::sort(normals_.begin(), normals_.end());
    normals_.erase(std::unique(normals_.begin(), normals_.end()), normals_.end());
    std::uint64_t before = 0;
    for (part& p : parts_)
      if (p.header.section->rows == medit_rows::normals) {
        for (std::uint64_t r = 0; r < p.header.count; ++r)
          if (has(normals_, before + r)) p.rows.push_back(r);
        before += p.header.count;
      }
  }

  static std::uint64_t place_in(const std::vector<std::uint64_t>& sorted, std::uint64_t x) {
    return static_cast<std::uint64_t>(std::lower_bound(sorted.begin(), sorted.end(), x) - sorted.begin());
  }

  void write_vertices(medit_output& out) {
    const std::uint64_t row = static_cast<std::uint64_t>(dimension_) * real_size() + integer_size();
    for (const std::uint64_t v : out_.verts) {
      at = verts_.at + v * row;
      write_vector(out, "a coordinate of a vertex");
      out.integer(reference("the reference of a vertex, an integer"));
      out.end_row();
    }
  }
  void write_vector(medit_output& out, const char* what) {
    for (int k = 0; k < 3; ++k) out.real(k < dimension_ ? coordinate(what) : 0);
  }
  void write_row(medit_output& out, const part& p, std::uint64_t row) {
    const medit_section& s = *p.header.section;
    at = p.header.at + row * row_size(s);
    const bool marks_rows = s.rows == medit_rows::marked_edges || s.rows == medit_rows::marked_polygons;
    if (s.rows == medit_rows::normals) write_vector(out, "a coordinate of a normal");
    else if (marks_rows) out.index(place_in(kept_[elements_of(s)], index(max_ids, "the index of an element")));
    else if (s.rows == medit_rows::normals_at_verts) {
      out.index(out_.number_of(index(out_.num_verts, "a vertex index")));
      out.index(place_in(normals_, index(max_ids, "the index of a normal")));
    } else {
      for (std::uint32_t k = 0; k < s.arity; ++k) out.index(out_.number_of(index(out_.num_verts, "a vertex index")));
      if (s.has_reference()) out.integer(reference("the reference of an element, an integer"));
    }
    out.end_row();
  }

 public:
  medit_cutter(const read_context& in, file_slice& out) : medit_binary(in), out_(out) {}

  void cut(slice_choice choice) {
    find_sections();
    choose_polys(choice);
    if (choice.only_verts) out_.verts = choice.checked_verts(out_.num_verts);
    else choose_listed();
    choose_marks();
    text_sink sink;
    medit_output out(sink, true);
    out.add_section(nullptr, out_.verts.size());
    std::vector<const part*> planned;
    std::size_t bytes = 1000 + 28 * out_.verts.size();
    for (const part& p : parts_) {
      const std::uint64_t n = p.is_range ? p.range.end - p.range.first : p.rows.size();
      if (n == 0) continue;
      out.add_section(p.header.section, n);
      planned.push_back(&p);
      bytes += n * 4 * (p.header.section->arity + 1);
    }
    sink.expect(bytes);
    out.begin_file();
    out.begin();
    write_vertices(out);
    for (const part* const p : planned) {
      out.begin();
      for (std::uint64_t r = p->range.first; r < p->range.end; ++r) write_row(out, *p, r);
      for (const std::uint64_t r : p->rows) write_row(out, *p, r);
    }
    if (ended_) out.end_file();
    out_.text = std::move(sink).release();
  }
};

CONCINO_INLINE void cut_medit(std::string_view text, const std::string& path, slice_choice choice, file_slice& out) {
  const concino::progress none;
  const read_context in{text, path, {}, &out.report, &none, true};
  medit_cutter(in, out).cut(choice);
}

}  // namespace concino::detail
