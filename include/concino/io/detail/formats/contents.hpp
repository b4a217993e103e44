// Helper functions for the readers of all formats.
#pragma once

#include <concino/core/message.hpp>
#include <concino/io/detail/cells/corners.hpp>
#include <concino/io/file_contents.hpp>

#include <type_traits>

namespace concino::detail {

/// The contents that a reader fills. Programs that read only surfaces need not compile the arrays of volumes.
template<bool Volumes>
using contents_of = std::conditional_t<Volumes, volume_contents, file_contents>;

inline const char* name_of_poly(bool volume, std::uint32_t arity) {
  return volume ? (arity == 4   ? "a tet"
                   : arity == 8 ? "a hex"
                                : "a polyhedron")
                : (arity == 3   ? "a triangle"
                   : arity == 4 ? "a quad"
                                : "a polygon");
}

/// How a format calls the verts of a polygon.
struct polygon_words {
  const char* different;         // "different verts at the corners of a face"
  const char* vert = "vert ";
  std::uint32_t first = 0;       // the number of the first vert
};

/// Checks a polygon that was read: the wanted mesh can hold it, and if verts are there twice, options.repeated_verts
/// allows it. fail(expected, found) throws parse_error with its place, poly() is its number, place() says where it is.
template<class Fail, class Number, class Place>
void check_read_polygon(file_contents& out, const wanted_mesh& wanted, const vert_id* v, std::size_t n,
                        const polygon_words& words, std::vector<std::uint64_t>& scratch, const Fail& fail,
                        const Number& poly, const Place& place) {
  std::size_t size = n;
  if (const std::size_t k = first_repeated(v, n, scratch); k != n) {
    if (out.repeated.policy == repeated_verts::refuse)
      fail({words.different, repeated_verts_hint}, {words.vert, v[k].raw() + words.first, " twice"});
    out.repeated.add(poly(), place);
    size = out.repeated.size_after(v, n);
  }
  if (wanted.surface && wanted.arity && size != 0 && size != wanted.arity)
    fail({name_of_poly(false, wanted.arity), " (polygonmesh and load_any take any polygon)"},
         {"a polygon of ", size, " corners"});
}

/// Ends the poly whose corners begin at `first`. As long as all polys have `arity` corners (0: there are no polys yet),
/// there are no offsets.
inline void end_poly(surface_arrays& s, std::uint32_t& arity, std::size_t first) {
  const std::size_t size = s.verts.size() - first;
  if (s.offsets.empty()) {
    if (first == 0) arity = static_cast<std::uint32_t>(size);
    if (size == arity) return;
    // the first poly of another size: from here on every poly needs an offset
    for (std::size_t o = 0; o <= first; o += arity) s.offsets.push_back(static_cast<std::uint32_t>(o));
  }
  s.offsets.push_back(static_cast<std::uint32_t>(s.verts.size()));
}

/// Checks and ends the poly at `position`, whose corners begin at `first`. Errors: parse_error, as check_read_polygon.
inline void end_checked_poly(const text_cursor& in, const char* position, std::size_t first,
                             std::vector<std::uint64_t>& scratch, const wanted_mesh& wanted, file_contents& out,
                             std::uint32_t& arity, const polygon_words& words) {
  surface_arrays& s = out.surface;
  check_read_polygon(
      out, wanted, s.verts.data() + first, s.verts.size() - first, words, scratch,
      [&](core::message expected, core::message found) { in.fail(position, expected, found); },
      [&] { return s.offsets.empty() ? (arity ? first / arity : 0) : s.offsets.size() - 1; },
      [&] { return core::joined({"on line ", in.line_of(position)}); });
  if (s.verts.size() > max_ids) in.fail_to_count("corners");
  end_poly(s, arity, first);
}

/// Throws because the file holds a volume and a surface is wanted, or the reverse. The message has the number of polys,
/// if known.
[[noreturn, gnu::noinline, gnu::cold]] inline void throw_wrong_dimension(std::string_view name, bool holds_volume,
                                                                         std::size_t polys = 0) {
  const std::string of =
      polys ? core::joined({" of ", polys, holds_volume ? " polyhedra" : " polygons"}) : std::string();
  core::throw_joined<unsupported>({name, ": holds a ", holds_volume ? "volume" : "surface", of, ", but a ",
                                   holds_volume ? "surface" : "volume", " mesh was requested; load it as ",
                                   holds_volume ? "polyhedralmesh" : "polygonmesh", " or with load_any"});
}

}  // namespace concino::detail
