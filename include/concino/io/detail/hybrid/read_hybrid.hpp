// The reader of .hybrid, the format of hex-dominant meshes: verts, faces, and polyhedra with a mark for each hex.
#pragma once

#include <concino/io/detail/cells/polyhedra_reader.hpp>
#include <concino/io/detail/hybrid/hybrid_format.hpp>

namespace concino::detail {

/// Reads a .hybrid file. Contents is volume_contents; a template only so that programs that read no volumes need not
/// compile it.
template<class Contents>
class hybrid_reader : polyhedra_reader<Contents, 0> {
  using base = polyhedra_reader<Contents, 0>;
  using base::at, base::skip, base::at_end, base::end, base::fail, base::next_count, base::next_integer, base::out_,
      base::report_, base::repeated_;

  std::vector<std::uint8_t> is_hex_;  // the marks of the polyhedra; empty if the file has none

 public:
  explicit hybrid_reader(const read_context& c) : base(c) {}

  void read(Contents& out) {
    skip();
    if (at_end()) fail(end(), "the numbers of verts and faces, and three times the number of polyhedra");
    const std::uint64_t nv = next_count("the number of verts", 6), nf = next_count("the number of faces", 8);
    skip();
    const char* const from = at;
    const std::uint64_t lines = next_count("three times the number of polyhedra", 2);
    if (lines % 3 != 0) fail(from, "three times the number of polyhedra");
    this->verts(nv);
    this->faces(nf);
    polys(lines / 3);
    skip();
    if (at_end() && lines > 0) report_.notes.push_back("the file does not mark its hexes: it may be cut off");
    else marks(lines / 3);
    skip();
    if (!at_end()) fail(at, "the end of the file after the last mark of a hex");
    this->orient_polys();
    report_marks();
    this->finish(out);
  }

 private:
  bool next_flag(const char* expected) {
    skip();
    const char* const here = at;
    const std::int64_t flag = next_integer(expected);
    if (flag != 0 && flag != 1) fail(here, expected);
    return flag == 1;
  }

  void polys(std::uint64_t n) {
    this->begin_polys(n, 2);
    for (std::uint64_t p = 0; p < n; ++p) {
      const std::uint64_t size = this->poly_size();
      for (std::uint64_t i = 0; i < size; ++i) {
        skip();
        const char* const here = at;
        this->add_face(here, this->next_index(out_.num_faces(), "a face index", 0));
      }
      skip();
      const char* const from = at;
      if (const std::uint64_t flags = next_count("the number of flags of a polyhedron", 2); flags != size)
        fail(from, {"one flag for each face of a polyhedron, ", size, " in number"}, {flags});
      for (std::uint64_t i = 0; i < size; ++i)
        out_.outward.push_back(next_flag("the flag of a face, 1 (outward) or 0"));
      this->end_poly(n);
    }
    this->end_polys();
  }

  void marks(std::uint64_t n) {
    for (std::uint64_t p = 0; p < n; ++p) is_hex_.push_back(next_flag("the mark of a polyhedron, 1 (a hex) or 0"));
  }

  /// The marks follow from the faces. If some do not, they are lost.
  void report_marks() {
    cell_recogniser known;
    std::size_t wrong = 0, kept = 0;
    for (std::size_t p = 0; p < is_hex_.size(); ++p)
      if (!std::binary_search(repeated_.dropped.begin(), repeated_.dropped.end(), static_cast<std::uint32_t>(p)))
        is_hex_[kept++] = is_hex_[p];
    is_hex_.resize(kept);
    for (std::size_t p = 0; p < is_hex_.size(); ++p) {
      const bool six = out_.poly_offsets[p + 1] - out_.poly_offsets[p] == 6;
      wrong += (is_hex_[p] != 0) != (six && recognise(out_, p, known) == cell_shape::hex);
    }
    if (wrong)
      report_.skipped.push_back(core::joined(
          {"the marks of ", wrong, " polyhedra that are hexes without a mark, or marked without being hexes"}));
  }
};

}  // namespace concino::detail

namespace concino {

/// Needs:  text of a .hybrid file: numbers in any layout; the marks of hexes at its end may be missing.
/// Result: its verts, faces and polyhedra in order. Polyhedra whose faces are not oriented consistently and outward are
///         corrected and counted. The marks of hexes are compared with the faces, and reported where they differ.
/// Cost:   O(size of the text), and sorting the edges of each polyhedron.
/// Errors: parse_error naming the line of a wrong number, an index out of range, a face of fewer than three verts or
///         with one twice, a polyhedron that the wanted mesh cannot hold, or text after the last mark; unsupported if
///         faces of more than 16 verts belong to very many polyhedra.
template<std::same_as<volume_contents> Contents>
void hybrid_format::read(const read_context& in, Contents& out) {
  detail::hybrid_reader<Contents>(in).read(out);
}

}  // namespace concino
