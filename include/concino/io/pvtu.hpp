// Reads and writes .pvtu files of VTK: meshes in pieces, each a .vtu file. Parallel programs read and write them.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/io/detail/formats/load_with.hpp>
#include <concino/io/detail/pvtu/pvtu_format.hpp>
#include <concino/io/detail/pvtu/pvtu_master.hpp>
#include <concino/io/detail/pvtu/save_parts.hpp>

#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#ifndef CONCINO_COMPILED
#include <concino/io/detail/pvtu/read_pvtu.hpp>
#endif

namespace concino {

/// Reads a mesh from a .pvtu file and its pieces, whatever its extension; no other format is compiled.
/// Needs:  Loadable M.
/// Result: as load: all pieces as one mesh, as pvtu_format::read says.
/// Cost:   as load, and O(n log n) in the verts.
/// Errors: as load, except that any extension is accepted. parse_error with the line of a piece outside of the folder,
///         or of an array that a piece lacks, and for pieces that contradict each other; io_error for a piece that
///         cannot be read.
template<Loadable M>
M load_pvtu(const std::string& path, const load_options& options = {}) {
  return detail::load_with<M>(path, file_format::pvtu, options);
}

/// Writes the .pvtu file of pieces that save_vtu has written, as each process of a parallel program does for its part.
/// Needs:  the paths of the pieces, from the folder of the .pvtu file, in this folder or below it. To be joined by
///         numbers, the pieces have the property "global_id" (std::int64_t) of verts, whose values are the same in all
///         pieces, and may have one of polys. Polys that belong to another piece have the value 1 in the property
///         "vtkGhostType" (std::uint8_t); readers drop them.
/// Result: the file names the pieces and their arrays. An existing one is replaced, or stays as it was on failure.
/// Cost:   O(size of the tags of all pieces), which are opened; of text files, O(size of the pieces).
/// Errors: invalid_argument for a path outside of the folder or twice, and for pieces with different arrays; empty
///         pieces may lack some. io_error if a piece cannot be read or the file cannot be written; parse_error and
///         unsupported for pieces that are no .vtu files.
inline void save_pvtu(std::span<const std::string> pieces, const std::string& path, const file_options& options = {}) {
  detail::save_pvtu_of_pieces(pieces, path, options);
}

namespace requirement {

template<class L, class M>
concept gives_parts = ReadableMap<L, poly_t<M>> && requires(const L& part, const poly_t<M>& p) {
  requires std::integral<std::remove_cvref_t<decltype(part[p])>>;
};

}  // namespace requirement

namespace detail {

inline constexpr long long max_part = 65535;  // no process opens more files

[[noreturn, gnu::cold]] inline void throw_wrong_part(std::size_t poly, long long part) {
  core::throw_joined<invalid_argument>(
      {"save_pvtu: poly ", poly, " is in part ", part, "; parts are numbers from 0 to ", max_part});
}

}  // namespace detail

/// Writes the parts of a mesh as pieces, and the .pvtu file that names them.
/// Needs:  a mesh with points, of any type; part[p], an integer from 0 on, for each poly.
/// Result: for m.pvtu, the pieces m_0.vtu, m_1.vtu, ... in the same folder, one for each number up to the largest; a
///         part without polys is an empty piece. Verts of no poly are in the first one. They have the properties of
///         save_vtu, and "global_id" (std::int64_t) of verts and polys, by which load_pvtu restores the mesh in its
///         order: the property of that name, if m has one, else the number of the element. All files are replaced
///         together, or none is, unless the program is killed while they get their names. Other files stay, such as
///         more pieces of an earlier save.
/// Cost:   as save_vtu, and O(n log n); a copy of the properties.
/// Errors: as save_vtu. invalid_argument for a part below 0 or above 65535, for options.as_boundary, and if m has a
///         property "global_id" with a value twice or without integers. io_error also if the process cannot open a file
///         for each piece.
template<EmbeddedMesh M, class L>
  requires requirement::gives_parts<L, M>
void save_pvtu(const M& m, const std::string& path, const L& part, const save_options& options = {}) {
  std::vector<std::uint32_t> part_of_poly;
  for (const poly_t<M> p : polys(m)) {
    const auto x = static_cast<long long>(part[p]);
    if (x < 0 || x > detail::max_part) detail::throw_wrong_part(index_of(m, p), x);
    part_of_poly.push_back(static_cast<std::uint32_t>(x));
  }
  detail::save_parts(detail::visitable_mesh<M>{m}, part_of_poly, path, options);
}

// What to write instead of calls that cannot compile.
template<class... T> void save_pvtu(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void save_pvtu(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class M, class U, class R = mistake::remedy<mistake::give_labels_at_polys>>
  requires(EmbeddedMesh<M> && !requirement::gives_parts<U, M>)
void save_pvtu(const M&, const std::string&, const U&, ...) = delete;  // an int at each poly: make_poly_map<int>(m)

}  // namespace concino
