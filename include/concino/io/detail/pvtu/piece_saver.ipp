// Bodies of piece_saver.hpp: saves one piece of a mesh, and with the first piece the .pvtu file.
#pragma once

#include <concino/io/detail/files/paths.hpp>
#include <concino/io/detail/formats/part_flat_mesh.hpp>
#include <concino/io/detail/pvtu/pvtu_master.hpp>
#include <concino/io/detail/pvtu/save_parts.hpp>
#include <concino/io/support/piece_saver.hpp>

#include <algorithm>
#include <vector>

namespace concino::core {

/// The name without its extension, and the number of the piece.
inline std::string name_of_piece(const std::string& file_name, std::size_t k) {
  return joined({file_name.substr(0, file_name.rfind('.')), "_", k, ".vtu"});
}

/// The path without links, after a check.
inline std::string path_to_write(const std::string& path) {
  detail::check_path(path);
  return detail::resolve_links(path);
}

CONCINO_INLINE piece_saver::piece_saver(const std::string& path, std::size_t k, std::size_t n, bool sync)
    : path_(path_to_write(path)), folder_(path_.substr(0, path_.rfind('/') + 1)),
      file_name_(path_.substr(folder_.size())), piece_(k), num_pieces_(n),
      files_(folder_.empty() ? "." : folder_, sync) {}

CONCINO_INLINE void piece_saver::write_flat(detail::flat_mesh_source mesh, std::span<const std::uint32_t> polys,
                                            std::span<const std::uint32_t> more_verts, const property_set& properties,
                                            const save_options& input_options) {
  const profiled_options profiled(input_options, "save_pvtu");
  const save_options& options = *profiled;
  detail::check_parts_are_wanted(path_, options);
  save_report unused_report, &report = options.report ? *options.report : unused_report;
  report = {};
  mesh([&](flat_mesh& m) {
    detail::check_savable_points(path_, m);
    if (m.dimension == 3) detail::report_lost_faces(report, m, ".pvtu");
    if (options.strict && !report.lost.empty()) detail::throw_lossy(path_, report);
    if (m.dimension == 3 && m.arity == 0) m.polyhedra();
    detail::part_flat_mesh part(m, polys, more_verts, properties);
    const std::string name = name_of_piece(file_name_, piece_);
    const detail::piece_arrays arrays = detail::save_part(part, files_.file(name), joined({folder_, name}), options);
    if (piece_ == 0) {
      std::vector<std::string> names;
      for (std::size_t k = 0; k < num_pieces_; ++k) names.push_back(name_of_piece(file_name_, k));
      detail::write_pvtu(files_.file(file_name_), arrays, names);
    }
    files_.finish();
    if (options.progress) detail::report_progress(options.progress, 1.0, "writing");
  });
}

}  // namespace concino::core
