// Writes a mesh of any type to a file.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/io/detail/formats/save_standard.hpp>
#include <concino/io/formats.hpp>

#ifndef CONCINO_COMPILED
#include <concino/io/detail/gmsh/write_gmsh.hpp>
#include <concino/io/detail/hedra/write_hedra.hpp>
#include <concino/io/detail/hybrid/write_hybrid.hpp>
#include <concino/io/detail/medit/write_medit.hpp>
#include <concino/io/detail/obj/write_obj.hpp>
#include <concino/io/detail/off/write_off.hpp>
#include <concino/io/detail/ply/write_ply.hpp>
#include <concino/io/detail/stl/write_stl.hpp>
#include <concino/io/detail/tet/write_tet.hpp>
#include <concino/io/detail/vtk/write_vtk.hpp>
#include <concino/io/detail/vtk_xml/write_vtp.hpp>
#include <concino/io/detail/vtk_xml/write_vtu.hpp>
#endif

namespace concino {

/// Writes a mesh to a file. The extension determines which of standard_formats is used. For surfaces: .obj, .off, and
/// .mesh for triangles and quads. For volumes: .hedra and .hybrid for any, .mesh and .tet for tets, hexes, prisms and
/// pyramids, which are recognised by their faces. .meshb, the binary .mesh, for the same; .vtk and .vtu for any mesh,
/// .vtp and .ply for any surface, .stl for triangles. .msh of Gmsh, version 2.2, for what .mesh holds.
/// Needs:  a surface or volume mesh with points, of any type.
/// Result: the complete file, which replaces an existing one; coordinates read back as the same numbers. Verts (and
///         faces) are numbered in the order of verts(m) (and faces(m)). These properties are written:
///         - to .mesh and .meshb: "label" (int) of all elements, "normal" (vec3) of verts. Also marks (int, 0 or 1):
///           "corner" of verts; "ridge" of edges; "required" of verts, edges, triangles and quads; "entity" of edges
///           and faces to write although they have no other value;
///         - to .obj and .off: "color" (rgba) of verts, "color" and "label" of polys (.off can hold only one of the
///           two);
///         - to .off: "normal" (vec3) and "texture" (std::array<double, 2>) of verts;
///         - to .obj: "object", "group" and "material" (std::string) of polys, with all lines of the mesh property
///           "materials"; "texture" (std::array<double, 2>) and "normal" (vec3) of corners, each distinct value once,
///           and none for not-a-number;
///         - to .vtk, .vtu and .vtp: all of verts, polys, the mesh and the faces of a volume that consist of 1, 2, 3,
///           4, 6 or 9 numbers, such as double, int, vec3 or std::array<float, 4>. Faces are written if a value is not
///           the default one. std::array<double, 3> reads back as vec3, and an rgba that is not called "color" as
///           std::array<float, 4>.
///         - to .ply: all of verts, edges and polys that consist of 1, 2, 3, 4, 6 or 9 numbers of at most 32 bits, or
///           doubles, or of a std::vector of such numbers; "texture" (std::array<double, 2>) of corners. Edges are
///           written if a value is not the default one. Types read back as from .vtk;
///         - to .stl: "object" (std::string) of polys as text, "attribute" (std::uint16_t) of polys in binary files.
///           Verts are numbered anew, and those at one point become one;
///         - to .msh: "label" and "entity_tag" (int) of all elements, "entity" as to .mesh, and the mesh property
///           "label_names" (label_names). Also all of verts, edges, faces and polys that consist of 1, 3 or 9 doubles,
///           or of numbers of at most 32 bits, which become doubles. Edges and faces are written if a value is not 0.
///         An .obj uses the material libraries that the mesh's file named, if they are in the folder of the new file
///         and hold the same colours and materials. Otherwise a new library is written there, with the same name and
///         .mtl, or _1.mtl and so on. Existing libraries are not changed, but those that earlier saves created for this
///         file are removed. Both files change or neither does; even if the program is killed, the .obj on disk finds
///         its materials. options.report names whatever is lost, changed or renamed.
/// Cost:   O(size of the mesh) time. Memory: O(corners), or none for arrays that the mesh stores in the form of the
///         file, as native meshes do until something is removed. O(faces) for polyhedra in formats that list no faces.
///         O(corners) for .mesh and .msh, O(polys) for .obj with colours or materials.
/// Errors: unsupported if the extension is unknown or that of a format that is only read, or if the format cannot hold
///         the mesh: it names the first poly that does not fit, and formats that can hold it. With options.strict, also
///         if anything would be lost. invalid_mesh if a coordinate is not finite. io_error if a file cannot be written,
///         or if another program creates a library of that name meanwhile. cancelled. The target is then as it was, and
///         no other file has been created or changed. (With options.sync, io_error also if the new file is in place but
///         its folder cannot be synchronised with the disk.)
template<EmbeddedMesh M>
void save(const M& m, const std::string& path, const save_options& options = {}) {
  detail::save_standard<dimension_v<M>>(detail::visitable_mesh<M>{m}, path, options);
}
/// `formats` is one format, which is used whatever the extension, as by save_obj and its siblings; or a list from which
/// the extension chooses: standard_formats + my_format{}. No other format is compiled. See <concino/io/format.hpp>.
template<EmbeddedMesh M, Formats F>
void save(const M& m, const std::string& path, F formats, const save_options& options = {}) {
  detail::save_with(m, path, formats, options);
}

/// The text that save would write, as a string.
/// Needs:  as save; the format, as there is no extension.
/// Result: the bytes of the file. Material libraries are not written.
/// Cost:   as save, and the memory of the text.
/// Errors: as save, except io_error; invalid_argument if no format is passed.
template<EmbeddedMesh M, Formats F>
std::string save_text(const M& m, F format, const save_options& options = {}) {
  if constexpr (detail::is_format_list<F>)
    if (options.format == format_id())
      core::throw_joined<invalid_argument>({"save_text: name the format; text has no file extension"});
  return detail::save_text_with(m, format, options);
}
/// One of standard_formats, chosen at run time.
template<EmbeddedMesh M>
std::string save_text(const M& m, format_id format, const save_options& options = {}) {
  save_options with_format = options;
  with_format.format = format;
  if (format == format_id())
    core::throw_joined<invalid_argument>({"save_text: name the format; text has no file extension"});
  return detail::standard_text<dimension_v<M>>(detail::visitable_mesh<M>{m}, with_format);
}

// What to write instead of calls that cannot compile.
template<class... T> void save(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void save(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void save_text(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void save_text(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class M, class F, class R = mistake::remedy<mistake::complete_the_format>>
  requires(EmbeddedMesh<M> && mistake::is_no_format<F>)
void save(const M&, const std::string&, const F&, ...) = delete;  // explain_format<F>() names what is missing
template<class M, class F, class R = mistake::remedy<mistake::complete_the_format>>
  requires(EmbeddedMesh<M> && mistake::is_no_format<F>)
void save_text(const M&, const F&, ...) = delete;  // explain_format<F>() names what is missing

}  // namespace concino
