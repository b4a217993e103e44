// Reads a mesh of a chosen type from a file.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/io/detail/formats/load_standard.hpp>
#include <concino/io/formats.hpp>

#ifndef CONCINO_COMPILED
#include <concino/io/detail/abaqus/read_abaqus.hpp>
#include <concino/io/detail/gmsh/read_gmsh.hpp>
#include <concino/io/detail/hedra/read_hedra.hpp>
#include <concino/io/detail/hybrid/read_hybrid.hpp>
#include <concino/io/detail/iv/read_iv.hpp>
#include <concino/io/detail/medit/read_medit.hpp>
#include <concino/io/detail/obj/read_obj.hpp>
#include <concino/io/detail/off/read_off.hpp>
#include <concino/io/detail/openfoam/read_openfoam.hpp>
#include <concino/io/detail/ovm/read_ovm.hpp>
#include <concino/io/detail/ply/read_ply.hpp>
#include <concino/io/detail/pvtu/read_pvtu.hpp>
#include <concino/io/detail/stl/read_stl.hpp>
#include <concino/io/detail/tet/read_tet.hpp>
#include <concino/io/detail/tetgen/read_ele.hpp>
#include <concino/io/detail/tetgen/read_smesh.hpp>
#include <concino/io/detail/vtk/read_vtk.hpp>
#include <concino/io/detail/vtk_xml/read_vtp.hpp>
#include <concino/io/detail/vtk_xml/read_vtu.hpp>
#endif

namespace concino {

/// Reads a mesh from a file. The extension, in upper or lower case, determines which of standard_formats it is in:
/// .obj, .off, .mesh, .meshb, .hedra, .hybrid, .tet, .iv, .vtk, .vtu, .vtp, .ply, .stl or .ovm. Others are .pvtu of
/// VTK, with its pieces, .msh of Gmsh, .ele, .node, .smesh and .poly of TetGen, and .inp of Abaqus. A file that begins
/// like a file of another of these formats is read as what it is, and the report has a note. A polyMesh folder of
/// OpenFOAM is read by the path of the folder, or of a case with constant/polyMesh.
/// Needs:  Loadable M.
/// Result: the mesh, with its elements in the order of the file. A polyhedralmesh can hold any volume and a polygonmesh
///         any surface; the other kinds accept only what they can hold. Values in the file become properties of the
///         mesh; it has no others. From every format: "label" (int) and "color" (rgba) of verts and polys. From .off:
///         "normal" (vec3) and "texture" (std::array<double, 2>) of verts. From .obj: "object", "group" and "material"
///         (std::string) of polys, with colours from the .mtl files in the same folder; the mesh property "materials"
///         (material_table) has all their lines. Also "texture" (std::array<double, 2>) and "normal" (vec3) of corners;
///         a corner without one has not-a-number. From .mesh and .meshb: "label" of edges and faces too, "corner",
///         "required", "ridge" and "entity" (int, 0 or 1; "entity" is 1 where the file lists an edge or face) of verts,
///         edges, faces and polys, "normal" of verts. From .vtk, .vtu, .pvtu and .vtp: every array of numbers, by its
///         name and type, for verts, polys, the mesh, and the faces of a volume that the file lists. An array of cells
///         with default values at all polys, or at all these faces, belongs to the others only. From .ply: every number
///         and list of verts, edges and polys, "normal" and "texture" of verts, "texture" of corners, as
///         ply_format::read says. From .stl: "object" of polys, "attribute" (std::uint16_t) of polys. From .msh and
///         polyMesh: "label" (int) of elements, and the mesh property "label_names" (label_names), which has their
///         names; of polyMesh the number of the patch of a face from 1, and of the cellZone of a poly. From .ovm: every
///         property of verts, edges, faces, polys and the mesh. From .ele and .node, which are read together, and from
///         .smesh and .poly: "attribute_1", ... (double) of verts, and of the polys of .ele. If .face and .edge are
///         beside .ele: "label" of faces and edges. From .inp: each set (int, 0 or 1) of verts or polys, by its name.
///         The read() of each format says more. options.report lists what was skipped, reoriented or worth a remark.
/// Cost:   one pass over the file, which is read into memory as a whole (or mapped: options.map); the arrays are moved
///         into the mesh.
/// Errors: io_error if the file cannot be read, or shrinks or grows meanwhile. parse_error with the line if it breaks
///         its format or holds a poly that M cannot hold, or one with a vert twice unless options.repeated_verts takes
///         such polys. unsupported if neither extension nor first words are known, if the file holds a volume and M is
///         a surface or the reverse, or if faces of more than 16 verts belong to very many polyhedra. unsupported for
///         elements of second or higher order, unless options.corners_only, and for formats that are only written, such
///         as .glb. cancelled.
template<Loadable M>
M load(const std::string& path, const load_options& options = {}) {
  return detail::load_standard<M>(path, options);
}
/// `formats` is one format, which is used whatever the extension, as by load_obj and its siblings; or a list from which
/// the extension chooses: standard_formats + my_format{}. No other format is compiled. See <concino/io/format.hpp>.
template<Loadable M, Formats F>
M load(const std::string& path, F formats, const load_options& options = {}) {
  return detail::load_with<M>(path, formats, options);
}

/// Reads a mesh from a string in memory, without material libraries. Messages call the text `name`.
/// Needs:  Loadable M; the format, as there is no extension.
/// Result: as load, without the colours and the "materials" of material libraries.
/// Cost:   one pass over the text.
/// Errors: as load, except io_error; invalid_argument if no format is passed.
template<Loadable M, Formats F>
M load_text(std::string_view text, F format, const load_options& options = {}, std::string_view name = "text") {
  if constexpr (detail::is_format_list<F>)
    if (options.format == format_id())
      core::throw_joined<invalid_argument>({"load_text: name the format; text has no file extension"});
  return detail::load_text_with<M>(text, name, format, options);
}
/// One of standard_formats, chosen when the program runs.
template<Loadable M>
M load_text(std::string_view text, format_id format, const load_options& options = {}, std::string_view name = "text") {
  load_options with_format = options;
  with_format.format = format;
  if (format == format_id())
    core::throw_joined<invalid_argument>({"load_text: name the format; text has no file extension"});
  return detail::load_standard_text<M>(text, name, with_format);
}

// What to write instead of calls that cannot compile.
template<
    class M,
    class R = mistake::remedy<
        "load returns native meshes only: auto m = load<polygonmesh>(path); convert<To>(m) converts it to other types">>
  requires(!Loadable<M>)
M load(...) = delete;  // load<trimesh>(path), load<polygonmesh>(path) ..., then convert<To>(m)
template<
    class M,
    class R = mistake::remedy<
        "load_text returns native meshes only: auto m = load_text<polygonmesh>(text, format); convert<To>(m) converts it to other types">>
  requires(!Loadable<M>)
M load_text(...) = delete;  // load_text<trimesh>(text, format) ..., then convert<To>(m)
template<Loadable M, class F, class R = mistake::remedy<mistake::complete_the_format>>
  requires mistake::is_no_format<F>
M load(const std::string&, const F&, ...) = delete;  // explain_format<F>() names what is missing
template<Loadable M, class F, class R = mistake::remedy<mistake::complete_the_format>>
  requires mistake::is_no_format<F>
M load_text(std::string_view, const F&, ...) = delete;  // explain_format<F>() names what is missing

}  // namespace concino
