// Helper functions for the readers of all formats.
#pragma once

#include <concino/core/large_pages.hpp>
#include <concino/core/message.hpp>
#include <concino/io/detail/corners.hpp>
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

/// Ends the poly whose corners begin at `first`. As long as all polys have `arity` corners (0: there are no polys yet), there are no offsets.
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

/// Throws because the file holds a volume and a surface is wanted, or the reverse. The message has the number of polys, if known.
[[noreturn, gnu::noinline, gnu::cold]] inline void throw_wrong_dimension(std::string_view name, bool holds_volume, std::size_t polys = 0) {
  const std::string of = polys ? core::joined({" of ", polys, holds_volume ? " polyhedra" : " polygons"}) : std::string();
  core::throw_joined<unsupported>({name, ": holds a ", holds_volume ? "volume" : "surface", of, ", but a ", holds_volume ? "surface" : "volume",
                             " mesh was requested; load it as ", holds_volume ? "polyhedralmesh" : "polygonmesh", " or with load_any"});
}

}  // namespace concino::detail
