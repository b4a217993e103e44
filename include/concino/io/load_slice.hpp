// Reads one of n slices of a binary mesh file, .vtu or .meshb, without the rest: for meshes that no one process holds.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/io/detail/file_slice/file_slice.hpp>
#include <concino/io/detail/formats/load_with.hpp>
#include <concino/io/detail/medit/medit_format.hpp>
#include <concino/io/detail/vtk_xml/vtu_format.hpp>

#ifndef CONCINO_COMPILED
#include <concino/io/detail/medit/read_medit.hpp>
#include <concino/io/detail/vtk_xml/read_vtu.hpp>
#endif

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace concino {

/// Some polys of a mesh in a file, in its order, and their verts.
template<class M>
struct mesh_slice {
  M mesh;
  std::uint64_t first_poly = 0;             // poly i of the mesh is poly first_poly + i of the file
  std::vector<std::uint64_t> global_vert;   // the number in the file of each vert of the mesh; they increase
  std::uint64_t num_polys = 0, num_verts = 0;  // of the whole file
};

namespace detail {

template<class M>
mesh_slice<M> load_chosen_slice(const std::string& path, slice_choice choice, const load_options& options) {
  const core::profiled_options profiled(options, "load_slice");
  constexpr format_list<vtu_format, medit_format> formats{};
  file_slice slice = slice_of_file(path, choice, *profiled);
  contents_for<M, std::remove_const_t<decltype(formats)>> contents;
  read_text<from_surface<M>, wants_volumes<M>>(slice.text, slice.name, formats, slice.is_medit ? 1 : 0, wanted_for<M>,
                                               *profiled, contents);
  std::string().swap(slice.text);
  if (load_report* const report = options.report)
    report->skipped.insert(report->skipped.end(), slice.report.skipped.begin(), slice.report.skipped.end());
  return {mesh_of<M>(contents, slice.name, options.report), slice.first_poly, std::move(slice.verts), slice.num_polys,
          slice.num_verts};
}

}  // namespace detail

/// Reads slice k of n equal slices of the polys of a file, with the verts of these polys. The n slices together have
/// each poly once, and a vert as often as slices have polys at it.
/// Needs:  Loadable M; k < n. A binary .meshb file, or a .vtu file with appended raw bytes, compressed or not, as
///         save(m, path, {.binary = true}) writes them; polyhedra in the layout of versions before 2.3.
/// Result: the slice, with the properties of load. A property with default values only may be missing in a slice. Verts
///         of no poly are in none. Of the edges and faces that a file lists, a slice has those whose verts it has.
/// Cost:   the memory of a slice. The file is mapped where the system is POSIX, else read as a whole. Of a .vtu file
///         the slice is read, and the types of all cells; of .meshb the slice, and all edges and faces of volumes.
/// Errors: as load; while the file is mapped, one that shrinks terminates the program by SIGBUS. invalid_argument
///         without such a k, or for options.repeated_verts and corners_only. unsupported for other formats, text and
///         base64, files in several pieces, with ghost cells, strips, or elements of second or higher order; save them
///         as one binary file before. cancelled.
template<Loadable M>
mesh_slice<M> load_slice(const std::string& path, std::size_t k, std::size_t n, const load_options& options = {}) {
  return detail::load_chosen_slice<M>(path, {k, n}, options);
}

// What to write instead of calls that cannot compile.
template<
    class M,
    class R = mistake::remedy<
        "load_slice returns native meshes only: auto s = load_slice<polygonmesh>(path, k, n); convert<To>(s.mesh) converts its mesh">>
  requires(!Loadable<M>)
M load_slice(...) = delete;  // load_slice<trimesh>(path, k, n), ..., then convert<To>(m)

}  // namespace concino
