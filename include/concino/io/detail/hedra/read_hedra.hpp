// The reader of .hedra, Cinolib's format for volumes of any polyhedra.
#pragma once

#include <concino/io/detail/cells/polyhedra_reader.hpp>
#include <concino/io/detail/hedra/hedra_format.hpp>

namespace concino::detail {

/// Reads a .hedra file. Contents is volume_contents; a template only so that programs that read no volumes need not
/// compile it.
template<class Contents>
class hedra_reader : polyhedra_reader<Contents, 1> {
  using base = polyhedra_reader<Contents, 1>;
  using base::at, base::skip, base::at_end, base::end, base::fail, base::next_count, base::next_integer, base::out_;

 public:
  explicit hedra_reader(const read_context& c) : base(c) {}

  void read(Contents& out) {
    skip();
    if (at_end()) fail(end(), "the numbers of verts, faces and polyhedra");
    const std::uint64_t nv = next_count("the number of verts", 6), nf = next_count("the number of faces", 8),
                        np = next_count("the number of polyhedra", 4);
    this->verts(nv);
    this->faces(nf);
    polys(np);
    skip();
    if (!at_end()) fail(at, "the end of the file after the last polyhedron");
    this->orient_polys();
    this->finish(out);
  }

 private:
  void polys(std::uint64_t n) {
    this->begin_polys(n, 1);
    for (std::uint64_t p = 0; p < n; ++p) {
      for (std::uint64_t size = this->poly_size(); size > 0; --size) {
        skip();
        const char* const here = at;
        const std::int64_t f = next_integer("a face index");
        const auto k = static_cast<std::uint64_t>(f < 0 ? -f : f);
        if (k < 1 || k > out_.num_faces())
          fail(here, {"a face index from 1 to ", out_.num_faces(), ", or its negative"});
        this->add_face(here, k - 1);
        out_.outward.push_back(f > 0);
      }
      this->end_poly(n);
    }
    this->end_polys();
  }
};

}  // namespace concino::detail

namespace concino {

/// Needs:  text of a .hedra file: numbers in any layout.
/// Result: its verts, faces and polyhedra in order. Polyhedra whose faces are not oriented consistently and outward are
///         corrected and counted.
/// Cost:   O(size of the text), and sorting the edges of each polyhedron.
/// Errors: parse_error naming the line of a wrong number, an index out of range, a face of fewer than three verts or
///         with one twice, a polyhedron that the wanted mesh cannot hold, or text after the last one; unsupported if
///         faces of more than 16 verts belong to very many polyhedra.
template<std::same_as<volume_contents> Contents>
void hedra_format::read(const read_context& in, Contents& out) {
  detail::hedra_reader<Contents>(in).read(out);
}

}  // namespace concino
