// The reader of the polyMesh folders of OpenFOAM: text and binary, volumes of any polyhedra.
#pragma once

#include <concino/io/detail/files/system_files.hpp>
#include <concino/io/detail/openfoam/openfoam_format.hpp>
#include <concino/io/detail/openfoam/openfoam_reader.hpp>
#include <concino/io/file_text.hpp>

namespace concino::detail {

/// Whether a file of zones lists any, or cannot be understood.
inline bool has_foam_zones(std::string_view text, std::string_view name) {
  try {
    foam_cursor in(text, name);
    read_foam_header(in);
    return in.next_count("the number of zones", in.file_size()) > 0;
  } catch (const error&) {  // what is not read cannot be wrong
    return true;
  }
}

/// Reads the files of a polyMesh folder. source(name, is_needed, use) calls use(text, name for messages) for the file
/// of that name; a file that is not needed may be missing.
template<class Source, class Contents>
void read_openfoam_files(const Source& source, const read_context& context, Contents& out) {
  openfoam_reader<Contents> reader(context);
  double begin = 0, end = 0;  // the fraction of the files that is read
  const auto report = [&](double fraction, const char* label) {
    return (*context.progress)(begin + fraction * (end - begin), label);
  };
  const concino::progress part =
      context.progress && *context.progress ? concino::progress(report) : concino::progress();
  std::string cells_name;
  const auto read = [&](std::string_view file, bool is_needed, double until, const auto& f) {
    begin = end;
    end = until;
    source(file, is_needed, [&](std::string_view text, std::string_view name) {
      foam_cursor in(text, name, &part);
      f(in);
      if (file == "owner") cells_name = name;
    });
  };
  read("points", true, 0.4, [&](foam_cursor& in) { reader.read_points(in); });
  read("faces", true, 0.8, [&](foam_cursor& in) { reader.read_faces(in); });
  read("owner", true, 0.9, [&](foam_cursor& in) { reader.read_owner(in); });
  read("neighbour", true, 0.95, [&](foam_cursor& in) { reader.read_neighbour(in); });
  read("boundary", true, 0.97, [&](foam_cursor& in) { reader.read_boundary(in); });
  read("cellZones", false, 0.99, [&](foam_cursor& in) { reader.read_cell_zones(in); });
  for (const std::string_view zones : {"faceZones", "pointZones"})
    source(zones, false, [&](std::string_view text, std::string_view name) {
      if (has_foam_zones(text, name)) context.report->skipped.push_back(core::joined({"the zones of ", zones}));
    });
  reader.finish(cells_name, out);
}

/// The files of a folder.
class openfoam_folder {
  std::string folder_;  // with a slash
  load_report& report_;

 public:
  openfoam_folder(std::string_view path, load_report& report) : folder_(core::joined({path, "/"})), report_(report) {}

  template<class Use>
  void operator()(std::string_view name, bool is_needed, const Use& use) const {
    const std::string path = core::joined({folder_, name});
    if (status_of(path).kind == file_kind::none) {
      if (const std::string packed = core::joined({path, ".gz"}); status_of(packed).kind != file_kind::none) {
        if (is_needed)
          core::throw_joined<unsupported>({packed, ": files compressed by gzip are not read; unpack them with gunzip"});
        report_.skipped.push_back(core::joined({name, ".gz, which is compressed by gzip"}));
      }
      if (!is_needed) return;
    }
    const file_text file(path);
    use(file.text(), std::string_view(path));
  }
};

}  // namespace concino::detail

namespace concino {

/// Needs:  a folder with the files points, faces, owner, neighbour and boundary of an OpenFOAM mesh, as text or binary,
///         with numbers of 32 or 64 bits in either byte order.
/// Result: a polyhedron for each cell, in order, with the faces in order; tets or hexes if all cells are, and the mesh
///         that is wanted holds them. Cells whose faces do not point from the owner to the neighbour are corrected and
///         counted. Faces of patch k, from 0, have the "label" k + 1, inner faces 0. Cells of cellZone k have the
///         "label" k + 1, others 0. "label_names" of the mesh has the names of patches and zones in order, with all
///         other entries of their dictionaries but nFaces, startFace and cellLabels, each on one line. faceZones and
///         pointZones are reported as skipped, and so is all but the first zone of a cell.
/// Cost:   O(size of the files) and sorting the edges of each cell, and for tets and hexes the faces. One file at a
///         time is in memory; options.map has no effect.
/// Errors: io_error if a file is missing. parse_error naming the file, and the line (in binary lists the byte) of what
///         breaks the format, of a face with fewer than three verts or with one twice, of a cell without faces, and of
///         patches that overlap or contain inner faces. unsupported for files compressed by gzip or of several
///         processors, for directives, for binary numbers in dictionaries, and if faces of more than 16 verts belong
///         to very many polyhedra.
template<std::same_as<volume_contents> Contents>
void openfoam_format::read(const read_context& in, Contents& out) {
  detail::read_openfoam_files(detail::openfoam_folder(in.name, *in.report), in, out);
}

}  // namespace concino
