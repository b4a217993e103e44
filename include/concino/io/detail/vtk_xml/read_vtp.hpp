// The reader of .vtp files, the XML format of VTK for polygons.
#pragma once

#include <concino/io/detail/vtk/vtk_mesh.hpp>
#include <concino/io/detail/vtk_xml/vtk_xml_reader.hpp>
#include <concino/io/detail/vtk_xml/vtp_format.hpp>

namespace concino {

/// Needs:  text of a .vtp file, or of a .vtu file with a surface; see vtu_format::read.
/// Result: the surface of its polygons and strips. Verts and lines are reported as skipped.
/// Cost:   as vtu_format::read.
/// Errors: as vtu_format::read.
inline void vtp_format::read(const read_context& in, file_contents& out) {
  detail::vtk_grid grid;
  detail::vtk_xml_reader reader(in, grid);
  reader.read();
  detail::vtk_mesh<file_contents>(grid, in, reader, out).make();
}

}  // namespace concino
