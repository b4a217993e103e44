// The reader of .pvtu files: reads the .vtu files of all pieces, and joins them.
#pragma once

#include <concino/io/detail/files/system_files.hpp>
#include <concino/io/detail/pvtu/joined_grid.hpp>
#include <concino/io/detail/pvtu/pvtu_format.hpp>
#include <concino/io/detail/vtk/vtk_mesh.hpp>
#include <concino/io/detail/vtk_xml/vtk_xml_polyhedra.hpp>
#include <concino/io/file_text.hpp>

#include <algorithm>
#include <type_traits>
#include <utility>

namespace concino::detail {

template<class Contents>
class pvtu_reader {
  static constexpr bool volumes = std::is_same_v<Contents, volume_contents>;
  using piece_reader = std::conditional_t<volumes, vtk_xml_volume_reader<Contents>, vtk_xml_reader>;

  const read_context& in_;
  Contents& out_;
  pvtu_index index_;
  pvtu_tags tags_;
  joined_grid all_;

 public:
  pvtu_reader(const read_context& in, Contents& out)
      : in_(in), out_(out), tags_(in, index_), all_(volumes, *in.report) {}

  void read() {
    tags_.read();
    if (!in_.is_file && !index_.pieces.empty())
      core::throw_joined<unsupported>(
          {in_.name, ": a mesh in the format pvtu has other files as pieces; load it by its path"});
    for (std::size_t k = 0; k < index_.pieces.size(); ++k) read_piece(k);
    const auto name_or = [](const std::string& name) { return name.empty() ? std::string("global_id") : name; };
    all_.finish(name_or(index_.global_point_ids), name_or(index_.global_cell_ids));
    vtk_mesh<Contents>(all_.grid, in_, all_, out_).make();
  }

 private:
  /// The path of a piece, in the folder of the file or, if that is a link, of the file that it refers to.
  std::string path_of(const pvtu_piece& p) const {
    const auto beside = [&](std::string_view file) {
      return core::joined({file.substr(0, file.rfind('/') + 1), p.source});
    };
    const std::string file = with_slashes(std::string(in_.name));
    std::string path = beside(file);
    if (status_of(path).kind == file_kind::none)
      if (const std::string real = real_path(file); !real.empty() && status_of(beside(real)).kind != file_kind::none)
        path = beside(real);
    return path;
  }

  void read_piece(std::size_t k) {
    const pvtu_piece& p = index_.pieces[k];
    const std::string path = path_of(p);
    file_text file;
    try {
      file = file_text(path);
    } catch (const io_error& e) {
      core::throw_joined<io_error>({e.what(), "; it is the piece that ", in_.name, " names on line ",
                                    tags_.line_of(p.at)});
    }
    load_report report;
    read_context in = in_;
    in.text = file.text();
    in.name = path;
    in.report = &report;
    const auto done = static_cast<double>(k), pieces = static_cast<double>(index_.pieces.size());
    double most = 0;  // arrays are not read in the order of the file
    const auto of_all = [&](double fraction, const char* label) {
      most = std::max(most, fraction);
      return (*in_.progress)((done + most) / pieces, label);
    };
    const concino::progress progress =
        in_.progress && *in_.progress ? concino::progress(of_all) : concino::progress();
    in.progress = &progress;
    vtk_grid grid;
    piece_reader reader(in, grid);
    reader.read();
    check_arrays(reader, path);
    all_.add(std::move(grid), path, reader.line_of_piece());
    take_report(report);
  }

  /// Errors: parse_error if a piece lacks an array that the file names, or has it with another type.
  void check_arrays(const piece_reader& reader, const std::string& path) const {
    const vtk_xml_index& index = reader.index();
    for (const pvtu_array& a : index_.arrays) {
      for (std::size_t p = 0; p < index.pieces.size(); ++p) {
        const bool of_points = a.part == vtk_xml_part::of_points;
        if ((of_points ? index.pieces[p].points : index.pieces[p].cells) == 0) continue;
        const auto found = std::find_if(index.entries.begin(), index.entries.end(), [&](const vtk_xml_entry& e) {
          return e.piece == p && e.part == a.part && e.array.name == a.name;
        });
        const bool is_there = found != index.entries.end();
        if (is_there && found->array.type == a.type && found->array.components == a.components) continue;
        tags_.fail(a.at,
                   {"an array that all pieces have", of_points ? " for their points" : " for their cells"},
                   {"\"", a.name, "\", which ", path, is_there ? " has with another type" : " lacks"});
      }
    }
  }

  /// Adds what a piece reports, unless an earlier piece has reported the same.
  void take_report(load_report& report) {
    const auto add = [](std::vector<std::string>& all, std::vector<std::string>& more) {
      for (std::string& s : more)
        if (std::find(all.begin(), all.end(), s) == all.end()) all.push_back(std::move(s));
    };
    add(in_.report->skipped, report.skipped);
    add(in_.report->notes, report.notes);
  }
};

}  // namespace concino::detail

namespace concino {

/// Needs:  text of a .pvtu file, whose pieces are .vtu files in its folder or below it.
/// Result: the pieces as one mesh. Points of different pieces become one where the array that GlobalIds names, or else
///         "global_id", has the same number for them; without such an array, where they are at the same place and have
///         the same values, as in a .vtu file of several pieces. Verts and polys are in the order of these numbers, or
///         of the pieces. Ghost cells are dropped. Arrays that some pieces lack, and that the file does not name, are
///         reported as skipped. Values of the mesh are those of the first piece.
/// Cost:   O(size of all files), and O(n log n) in the points; the memory of the mesh and of one piece.
/// Errors: as vtu_format::read, for each piece. parse_error with the line of a piece whose path leaves the folder, of
///         an array that a piece lacks, and if pieces contradict each other. io_error for a piece that cannot be read.
///         unsupported if the text is no file, as its pieces are files.
template<std::derived_from<file_contents> Contents>
void pvtu_format::read(const read_context& in, Contents& out) { detail::pvtu_reader<Contents>(in, out).read(); }

}  // namespace concino
