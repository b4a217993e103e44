// The reader of .vtu files, the XML format of VTK for unstructured grids.
#pragma once

#include <concino/io/detail/vtk/vtk_mesh.hpp>
#include <concino/io/detail/vtk_xml/vtk_xml_polyhedra.hpp>
#include <concino/io/detail/vtk_xml/vtu_format.hpp>

namespace concino {

/// Needs:  text of a .vtu file, or of a .vtp file: arrays as text, base64 or appended, in either byte order, compressed
///         by zlib or not, in pieces.
/// Result: as vtk_format::read. Points of different pieces at the same place with the same values become one, unless a
///         piece has several points there; ghost cells are dropped. Both are reported.
/// Cost:   O(size of the text), and of the data it was compressed from; for files in pieces O(n log n) in the points,
///         and more where many pieces have different values at one place.
/// Errors: parse_error naming the line of the tag of a wrong array, or of a wrong number in text; unsupported for
///         compressed files without load_options::inflate, other compressors, datasets and cell types, and if the file
///         holds a volume and a surface was wanted, or the reverse.
template<std::derived_from<file_contents> Contents>
void vtu_format::read(const read_context& in, Contents& out) {
  detail::vtk_grid grid;
  std::conditional_t<std::is_same_v<Contents, volume_contents>, detail::vtk_xml_volume_reader<Contents>,
                     detail::vtk_xml_reader>
      reader(in, grid);
  reader.read();
  detail::vtk_mesh<Contents>(grid, in, reader, out).make();
}

}  // namespace concino
