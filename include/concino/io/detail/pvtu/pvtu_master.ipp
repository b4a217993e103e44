// Bodies of pvtu_master.hpp: writes .pvtu files, which name the pieces of a mesh and the arrays that they have.
#pragma once

#include <concino/io/atomic_file.hpp>
#include <concino/io/detail/files/paths.hpp>
#include <concino/io/detail/pvtu/pvtu_master.hpp>
#include <concino/io/detail/pvtu/pvtu_tags.hpp>
#include <concino/io/file_text.hpp>

#include <algorithm>
#include <bit>

namespace concino::detail {

CONCINO_INLINE void write_pvtu(text_sink& out, const piece_arrays& arrays, std::span<const std::string> pieces) {
  const auto write = [&](const char* tag, const std::string& active, const std::vector<piece_arrays::array>& all) {
    out << '<' << tag << active << ">\n";
    for (const piece_arrays::array& a : all) {
      out << "<PDataArray type=\"" << vtk_names_of(a.type).xml << "\" Name=\"" << xml_text(a.name) << '"';
      if (a.components > 1) out << " NumberOfComponents=\"" << a.components << '"';
      out << "/>\n";
    }
    out << "</" << tag << ">\n";
  };
  const bool has_ghosts = std::any_of(arrays.of_cells.begin(), arrays.of_cells.end(),
                                      [](const piece_arrays::array& a) { return a.name == "vtkGhostType"; });
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" byte_order=\""
      << (std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian")
      << "\" header_type=\"UInt32\">\n<PUnstructuredGrid GhostLevel=\"" << (has_ghosts ? 1 : 0) << "\">\n";
  write("PPointData", arrays.active_of_points, arrays.of_points);
  write("PCellData", arrays.active_of_cells, arrays.of_cells);
  write("PPoints", {}, {{"Points", arrays.coordinates, 3}});
  for (const std::string& p : pieces) out << "<Piece Source=\"" << xml_text(p) << "\"/>\n";
  out << "</PUnstructuredGrid>\n</VTKFile>\n";
}

/// The arrays of a .vtu file. Empty pieces need not have any: is_empty then says so.
inline piece_arrays arrays_of_piece(const std::string& path, bool& is_empty) {
  const file_text file(path, {.map = true});
  load_report unused;
  const read_context in{file.text(), path, {}, &unused};
  vtk_xml_index index;
  vtk_xml_tags(in, index).read();
  if (index.is_polydata) core::throw_joined<unsupported>({path, ": the pieces of a .pvtu file are .vtu files"});
  piece_arrays r;
  is_empty = true;
  for (const vtk_xml_piece& p : index.pieces) is_empty = is_empty && p.points == 0 && p.cells == 0;
  for (const vtk_xml_entry& e : index.entries) {
    if (e.piece != 0) continue;
    if (e.part == vtk_xml_part::points) r.coordinates = e.array.type;
    if (e.part == vtk_xml_part::of_points) r.of_points.push_back({e.array.name, e.array.type, e.array.components});
    if (e.part == vtk_xml_part::of_cells) r.of_cells.push_back({e.array.name, e.array.type, e.array.components});
  }
  const auto add = [](std::string& active, const char* attribute, const std::string& array) {
    if (!array.empty()) active = core::joined({active, " ", attribute, "=\"", xml_text(array), "\""});
  };
  add(r.active_of_points, "Normals", index.normals);
  add(r.active_of_points, "TCoords", index.textures);
  add(r.active_of_points, "GlobalIds", index.global_point_ids);
  add(r.active_of_cells, "GlobalIds", index.global_cell_ids);
  return r;
}

/// Errors: invalid_argument if two pieces have different arrays.
inline void require_same_arrays(const std::vector<piece_arrays::array>& a, const std::string& path_of_a,
                                const std::vector<piece_arrays::array>& b, const std::string& path_of_b) {
  const auto check = [](const auto& all, const std::string& path, const auto& others, const std::string& other_path) {
    for (const piece_arrays::array& x : all)
      if (std::find(others.begin(), others.end(), x) == others.end())
        core::throw_joined<invalid_argument>({"save_pvtu: the pieces need the same arrays: ", path, " has \"", x.name,
                                              "\", ", other_path, " has not, or has it with another type"});
  };
  check(a, path_of_a, b, path_of_b);
  check(b, path_of_b, a, path_of_a);
}

CONCINO_INLINE void save_pvtu_of_pieces(std::span<const std::string> pieces, const std::string& path,
                                        const file_options& options) {
  check_path(path);
  const std::string target = resolve_links(path), folder = target.substr(0, target.rfind('/') + 1);
  piece_arrays all;
  std::string first;  // the piece that has them
  bool any = false;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (!stays_in_folder(pieces[k]))
      core::throw_joined<invalid_argument>({"save_pvtu: '", pieces[k],
                                            "' is not the path of a piece from the folder of the .pvtu file"});
    if (std::find(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(k), pieces[k]) !=
        pieces.begin() + static_cast<std::ptrdiff_t>(k))
      core::throw_joined<invalid_argument>({"save_pvtu: the piece '", pieces[k], "' is named twice"});
    const std::string file = core::joined({folder, pieces[k]});
    bool is_empty = false;
    piece_arrays arrays = arrays_of_piece(file, is_empty);
    if (is_empty && any) continue;
    if (any) {
      require_same_arrays(all.of_points, first, arrays.of_points, file);
      require_same_arrays(all.of_cells, first, arrays.of_cells, file);
      continue;
    }
    if (!is_empty || k == 0) all = std::move(arrays), first = file;
    any = !is_empty;
  }
  atomic_file file(path, {.sync = options.sync});
  text_sink out(file.descriptor(), path);
  write_pvtu(out, all, pieces);
  out.flush();
  file.finish();
  file.commit();
}

}  // namespace concino::detail
