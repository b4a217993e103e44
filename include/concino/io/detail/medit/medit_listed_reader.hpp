// Reads the sections of MEDIT files that list edges, faces of volumes, marks and normals, and the verts of elements.
#pragma once

#include <concino/io/detail/cells/element_nodes.hpp>
#include <concino/io/detail/formats/contents.hpp>
#include <concino/io/detail/medit/medit_marks.hpp>
#include <concino/io/detail/medit/medit_sections.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Cursor is medit_text or medit_binary.
template<class Cursor>
class medit_listed_reader : protected Cursor {
  file_contents& contents_;
  std::vector<vec3> normals_;
  row_numbers triangles_, quads_;
  std::vector<vert_id> nodes_of_element_;

 protected:
  using Cursor::fail, Cursor::position, Cursor::index, Cursor::reference;

  std::vector<vec3> points_;
  row_numbers edges_;
  medit_marks marks_;
  element_nodes nodes_;
  std::vector<std::uint64_t> scratch_;

  medit_listed_reader(const read_context& c, file_contents& contents) : Cursor(c), contents_(contents) {}

  vec3 next_vector(const char* x, const char* y, const char* z) {
    vec3 p;
    p.x = this->coordinate(x);
    p.y = this->coordinate(y);
    if (this->dimension_ == 3) p.z = this->coordinate(z);
    return p;
  }

  /// Reads the verts of an element. Returns its position.
  const char* next_element(const medit_section& s, vert_id* corners) {
    const char* const from = position();
    for (std::uint32_t k = 0; k < s.arity; ++k) corners[k] = vert_id{index(points_.size(), "a vertex index")};
    if (s.nodes) read_nodes(s);
    return from;
  }
  void read_nodes(const medit_section& s) {
    nodes_of_element_.resize(s.nodes);
    for (vert_id& v : nodes_of_element_) v = vert_id{index(points_.size(), "a vertex index")};
    nodes_.add(nodes_of_element_.data(), s.nodes);
  }
  int next_reference() { return reference("the reference of an element, an integer"); }

  /// Of the rows of triangles or quads, which a section lists or marks.
  row_numbers& numbers_of(const medit_section& s) { return s.arity == 3 || s.code == 17 ? triangles_ : quads_; }

  /// Whether elements with a vert twice become others, or none, so that what the mesh can hold depends on each of them.
  bool takes_repeated() const { return contents_.repeated.policy != repeated_verts::refuse; }

  /// Reads edges, or faces of a volume: elements that the mesh has, and to which the file gives references.
  void list(const medit_section_header& header, element_kind kind, listed_elements& listed, row_numbers& numbers) {
    const medit_section& s = *header.section;
    numbers.add(header.count, listed.size());
    for (std::uint64_t i = 0; i < header.count; ++i) {
      vert_id corners[8];
      const std::uint32_t n = collapse_listed(next_element(s, corners), corners, s.arity);
      listed.verts.insert(listed.verts.end(), corners, corners + n);
      if (listed.verts.size() > max_ids) this->fail_to_count("corners of edges or faces");
      listed.end_element();
      marks_.set(kind, "label", listed.size() - 1, next_reference());
      this->report_progress();
    }
  }

  void read_normals(const medit_section_header& header) {
    for (std::uint64_t i = 0; i < header.count; ++i)
      normals_.push_back(next_vector("the x of a normal", "the y of a normal", "the z of a normal"));
  }

  void read_normals_at_verts(const medit_section_header& header) {
    contents_.vert_normals.resize(points_.size());
    for (std::uint64_t i = 0; i < header.count; ++i) {
      const std::uint32_t v = index(points_.size(), "a vertex index");
      contents_.vert_normals[v] = normals_[index(normals_.size(), "the index of a normal")];
    }
  }

  /// Reads the numbers of marked elements. Those of a section refer to the rows of others.
  void mark(const medit_section_header& header, bool is_volume) {
    const medit_section& s = *header.section;
    for (std::uint64_t i = 0; i < header.count; ++i) {
      if (s.rows == medit_rows::marked_verts) {
        marks_.set(element_kind::vert, s.mark, index(points_.size(), "a vertex index"), 1);
      } else if (s.rows == medit_rows::marked_edges) {
        marks_.set(element_kind::edge, s.mark, edges_[index(edges_.size(), "the index of an edge")], 1);
      } else {
        const row_numbers& numbers = numbers_of(s);
        marks_.set(is_volume ? element_kind::face : element_kind::poly, s.mark,
                   numbers[index(numbers.size(), "the index of a triangle or quad")], 1);
      }
    }
  }

 private:
  /// The number of verts of an edge or face that is listed. Without options.repeated_verts they have to be different;
  /// with it, equal neighbours become one.
  std::uint32_t collapse_listed(const char* from, vert_id* corners, std::uint32_t n) {
    const std::size_t k = first_repeated(corners, n, scratch_);
    if (k == n) return n;
    if (!takes_repeated())
      fail(from, {"different verts in an element", repeated_verts_hint}, {"vert ", corners[k].raw() + 1, " twice"});
    return collapse_verts(corners, n);
  }
};

}  // namespace concino::detail
