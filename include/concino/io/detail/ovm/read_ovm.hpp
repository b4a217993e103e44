// The reader of .ovm, the text format of OpenVolumeMesh: edges of verts, faces of half-edges, polyhedra of half-faces.
#pragma once

#include <concino/io/detail/cells/polyhedra_reader.hpp>
#include <concino/io/detail/ovm/ovm_format.hpp>
#include <concino/io/detail/ovm/ovm_properties.hpp>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace concino::detail {

/// Reads an .ovm file. Contents is volume_contents; a template only so that programs that read no volumes need not
/// compile it.
template<class Contents>
class ovm_reader : polyhedra_reader<Contents, 0> {
  using base = polyhedra_reader<Contents, 0>;
  using base::at, base::skip, base::at_end, base::end, base::fail, base::next_count, base::next_index, base::out_,
      base::report_;

  const read_context& in_;
  std::vector<std::array<std::uint32_t, 2>> edges_;
  std::vector<bool> is_used_;  // by edge: whether a face has it

  /// Whether the next word is this one, in upper or lower case. Moves behind it.
  bool next_is(std::string_view lower) {
    skip();
    const char* const from = at;
    const std::string_view w = this->word();
    bool same = w.size() == lower.size();
    for (std::size_t i = 0; same && i < w.size(); ++i)
      same = (w[i] >= 'A' && w[i] <= 'Z' ? static_cast<char>(w[i] | 0x20) : w[i]) == lower[i];
    if (!same) at = from;
    return same;
  }
  std::uint64_t section(std::string_view lower, const char* word, const char* count, std::uint64_t bytes) {
    if (!next_is(lower)) fail(at, word);
    return next_count(count, bytes);
  }

  void header() {
    if (next_is("ovm")) {
      const char* const from = at;
      if (next_is("binary"))
        core::throw_joined<unsupported>(
            {this->name(), ":", this->line_of(from), ": OVM BINARY has never been defined; convert it to OVM ASCII"});
      if (!next_is("ascii")) report_.notes.push_back("the word ASCII is missing in the first line");
    } else if (next_is("vertices")) {
      report_.notes.push_back("the first line, OVM ASCII, is missing");
      at -= 8;
    } else {
      fail(at, "OVM ASCII");
    }
  }

  void read_edges(std::uint64_t n) {
    edges_.reserve(this->reservable(n, 4));
    for (std::uint64_t e = 0; e < n; ++e) {
      const std::uint32_t a = next_index(out_.points.size(), "a vert index", 0);
      edges_.push_back({a, next_index(out_.points.size(), "a vert index", 0)});
      this->report_progress();
    }
    is_used_.resize(edges_.size());
    require_countable(edges_.size(), "edges");
  }
  /// Errors: unsupported if halves of so many elements have no numbers of 32 bits.
  void require_countable(std::size_t n, const char* what) const {
    if (n > 0x7FFFFFFF)
      core::throw_joined<unsupported>({this->name(), ": more than 2147483647 ", what, ", whose halves are numbered"});
  }

  /// Reads the half-edges of a face, and adds the first vert of each. Each begins where the one before it ends.
  void read_half_edges(std::uint64_t n) {
    std::uint32_t first = 0, next = 0;
    for (std::uint64_t i = 0; i < n; ++i) {
      skip();
      const char* const from = at;
      const std::uint32_t h = next_index(2 * std::uint64_t{edges_.size()}, "the index of a half-edge", 0);
      const std::uint32_t a = edges_[h / 2][h % 2], b = edges_[h / 2][1 - h % 2];
      if (i == 0) first = a;
      else if (a != next)
        fail(from, {"a half-edge from vert ", next, ", where the one before it ends"}, {"one from vert ", a});
      if (i + 1 == n && b != first)
        fail(from, {"a half-edge to vert ", first, ", where the first one of the face begins"}, {"one to vert ", b});
      next = b;
      is_used_[h / 2] = true;
      out_.face_verts.push_back(vert_id{a});
    }
  }

  void polys(std::uint64_t n) {
    this->begin_polys(n, 1);
    for (std::uint64_t p = 0; p < n; ++p) {
      for (std::uint64_t size = this->poly_size(); size > 0; --size) {
        skip();
        const char* const from = at;
        const std::uint32_t h = next_index(2 * std::uint64_t{out_.num_faces()}, "the index of a half-face", 0);
        this->add_face(from, h / 2);
        out_.outward.push_back(h % 2 == 0);
      }
      this->end_poly(n);
    }
  }

  /// Lists the edges and faces, if they have values.
  void list_elements(Contents& out) const {
    bool of_edges = false, of_faces = false;
    for (const property_column& c : out.properties) {
      of_edges = of_edges || c.kind == element_kind::edge;
      of_faces = of_faces || c.kind == element_kind::face;
    }
    for (std::size_t e = 0; of_edges && e < edges_.size(); ++e) {
      for (const std::uint32_t v : edges_[e]) out.edges.verts.push_back(vert_id{v});
      out.edges.end_element();
    }
    if (!of_faces) return;
    out.faces.verts.assign(out_.face_verts.begin(), out_.face_verts.end());
    out.faces.offsets.assign(out_.face_offsets.begin(), out_.face_offsets.end());
  }

 public:
  explicit ovm_reader(const read_context& c) : base(c), in_(c) { this->comment = '#'; }

  void read(Contents& out) {
    header();
    ovm_counts n;
    n.verts = section("vertices", "Vertices", "the number of verts", 6);
    this->verts(n.verts);
    n.edges = section("edges", "Edges", "the number of edges", 4);
    read_edges(n.edges);
    n.faces = section("faces", "Faces", "the number of faces", 8);
    this->faces(n.faces, [&](std::uint64_t size) { read_half_edges(size); });
    require_countable(out_.num_faces(), "faces");
    n.polys = section("polyhedra", "Polyhedra", "the number of polyhedra", 4);
    polys(n.polys);
    if (const auto unused = std::count(is_used_.begin(), is_used_.end(), false))
      report_.skipped.push_back(core::joined({unused, " edges of no face"}));
    ovm_properties_reader(in_, at, n, out).read();
    list_elements(out);
    this->end_polys();
    this->orient_polys();
    this->finish(out);
  }
};

}  // namespace concino::detail

namespace concino {

/// Needs:  text of an .ovm file: numbers in any layout, # begins a comment.
/// Result: its verts, faces and polyhedra in order; half-face 2f is face f as it is listed, counter-clockwise seen from
///         outside, and half-face 2f + 1 is the reversed one. Polyhedra whose faces are not oriented consistently and
///         outward are corrected and counted: OpenVolumeMesh asks for neither, and writes both. Properties of verts,
///         edges, faces, polys and the mesh by their names and types; those of half-edges and half-faces, those of
///         other types and edges of no face are skipped and reported.
/// Cost:   O(size of the text), and sorting the edges of each polyhedron.
/// Errors: parse_error naming the line of a wrong word or number, an index out of range, half-edges of a face that are
///         no cycle, a face of fewer than three verts or with one twice, a polyhedron that the wanted mesh cannot hold,
///         or a property without a value for each element; unsupported for the word BINARY, or if faces of more than 16
///         verts belong to very many polyhedra.
template<std::same_as<volume_contents> Contents>
void ovm_format::read(const read_context& in, Contents& out) {
  detail::ovm_reader<Contents>(in).read(out);
}

}  // namespace concino
