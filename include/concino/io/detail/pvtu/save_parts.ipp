// Bodies of save_parts.hpp: writes the parts of a mesh as the pieces of a .pvtu file.
#pragma once

#include <concino/io/detail/files/folder_files.hpp>
#include <concino/io/detail/files/paths.hpp>
#include <concino/io/detail/formats/part_flat_mesh.hpp>
#include <concino/io/detail/pvtu/pvtu_master.hpp>
#include <concino/io/detail/pvtu/save_parts.hpp>
#include <concino/io/detail/vtk_xml/write_vtu.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace concino::detail {

/// The polys of each part, and the verts of no poly, which the first part gets.
struct mesh_parts {
  std::vector<std::vector<std::uint32_t>> polys;
  std::vector<std::uint32_t> loose_verts;

  mesh_parts(flat_mesh& m, std::span<const std::uint32_t> part_of_poly) {
    for (const std::uint32_t part : part_of_poly) polys.resize(std::max<std::size_t>(polys.size(), part + 1));
    if (polys.empty()) polys.resize(1);
    for (std::uint32_t p = 0; p < part_of_poly.size(); ++p) polys[part_of_poly[p]].push_back(p);
    std::vector<bool> is_used(m.points.size());
    for (const vert_id v : m.poly_verts.values) is_used[v.raw()] = true;
    if (m.dimension == 3 && m.arity == 0) {
      const flat_polyhedra& all = m.polyhedra();
      for (const face_id f : all.poly_faces.values)
        for (const vert_id v : all.face_verts[f.raw()]) is_used[v.raw()] = true;
    }
    for (std::uint32_t v = 0; v < is_used.size(); ++v)
      if (!is_used[v]) loose_verts.push_back(v);
  }
};

/// Gives elements the numbers by which pieces are joined: the property "global_id" if there is one, else their own
/// numbers. Errors: invalid_argument if the property has a number twice, or no integers.
inline void number_elements(element_kind kind, std::size_t n, std::span<const std::uint32_t> indices,
                            property_set& all) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    const property_info p = all.info(i);
    if (p.kind != kind || p.name != global_id) continue;
    const vtk_property_type type = vtk_type_of(*p.type);
    std::vector<std::int64_t> numbers;
    if (type.components == 1 && type.number < vtk_number::float32)
      with_number_type(type.number, [&]<class T>(std::type_identity<T>) {
        const T* const values = static_cast<const T*>(all.values(i)->data());
        for (std::size_t k = 0; k < n; ++k)
          numbers.push_back(static_cast<std::int64_t>(values[indices.empty() ? k : indices[k]]));
      });
    std::sort(numbers.begin(), numbers.end());
    if (numbers.size() == n && std::adjacent_find(numbers.begin(), numbers.end()) == numbers.end()) return;
    core::throw_joined<invalid_argument>({"save_pvtu: the ", to_string(kind), " property \"global_id\" has to give ",
                                          "different integers, by which pieces are joined; remove_property removes it"});
  }
  std::size_t bound = n;
  for (const std::uint32_t i : indices) bound = std::max<std::size_t>(bound, i + std::size_t{1});
  auto* const ids = static_cast<std::int64_t*>(all.get(kind, global_id, values_of<std::int64_t>, bound)->data());
  for (std::size_t k = 0; k < n; ++k) ids[indices.empty() ? k : indices[k]] = static_cast<std::int64_t>(k);
}

/// The properties that pieces have: those that the file of the whole mesh would have, and the numbers of elements.
inline property_set properties_of_pieces(write_context& whole_file, flat_mesh& m) {
  const vtk_output_arrays<write_context> arrays(whole_file, m, false);
  property_set kept;
  const auto is_written = [&](const property_info& p) {
    const auto& list = p.kind == element_kind::vert   ? arrays.of_verts
                       : p.kind == element_kind::mesh ? arrays.of_mesh
                                                      : arrays.of_cells;
    const bool of_faces = p.kind == element_kind::face;
    const vtk_property_type type = vtk_type_of(*p.type);
    return p.kind != element_kind::edge && p.kind != element_kind::corner &&
           std::any_of(list.begin(), list.end(), [&](const vtk_output_array& a) {
             return a.name == p.name && a.type.number == type.number && a.type.components == type.components &&
                    static_cast<bool>(of_faces ? a.face_values : a.values);
           });
  };
  for (std::size_t i = 0; m.properties && i < m.properties->size(); ++i)
    if (const property_info p = m.properties->info(i); is_written(p)) {
      const column& values = *m.properties->values(i);
      column copies(values);
      kept.get(p.kind, p.name, values.operations(), values.size())->swap_values(copies);
    }
  number_elements(element_kind::vert, m.points.size(), m.vert_indices, kept);
  number_elements(element_kind::poly, m.num_polys, m.poly_indices, kept);
  return kept;
}

inline std::vector<piece_arrays::array> listed_arrays(const std::vector<vtk_output_array>& all) {
  std::vector<piece_arrays::array> r;
  for (const vtk_output_array& a : all) r.push_back({a.name, a.type.number, a.type.components});
  return r;
}

CONCINO_INLINE piece_arrays save_part(flat_mesh& part, text_sink& out, const std::string& name,
                                      const save_options& options) {
  save_report unused;  // what is lost was reported for the whole mesh
  write_context c{out, name, name, options, unused};
  c.num_elements = part.points.size() + part.num_polys;
  vtu_writer<write_context> writer(c, part, true);
  writer.write();
  const auto& arrays = writer.arrays();
  return {listed_arrays(arrays.of_verts), listed_arrays(arrays.of_cells), vtk_number::float64,
          active_vert_arrays(arrays.of_verts), global_ids_attribute(arrays.of_cells)};
}

CONCINO_INLINE void check_parts_are_wanted(const std::string& path, const save_options& options) {
  if (options.as_boundary)
    core::throw_joined<invalid_argument>({path, ": save_pvtu saves the parts of a mesh, and no boundary"});
}

CONCINO_INLINE void save_parts(flat_mesh_source mesh, std::span<const std::uint32_t> part_of_poly,
                               const std::string& path, const save_options& input_options) {
  const core::profiled_options profiled(input_options, "save_pvtu");
  const save_options& options = *profiled;
  check_parts_are_wanted(path, options);
  check_path(path);
  const std::string target = resolve_links(path);
  const std::string folder = target.substr(0, target.rfind('/') + 1), file_name = target.substr(folder.size()),
                    stem = file_name.substr(0, std::min(file_name.rfind('.'), file_name.size()));
  save_report unused_report, &report = options.report ? *options.report : unused_report;
  report = {};
  mesh([&](flat_mesh& m) {
    check_savable_points(path, m);
    text_sink nowhere = text_sink::nowhere();
    write_context whole_file{nowhere, path, path, options, report};
    const property_set properties = properties_of_pieces(whole_file, m);
    report_lost(whole_file, m, ".pvtu");
    if (m.dimension == 3) report_lost_faces(report, m, ".pvtu");
    if (options.strict && !report.lost.empty()) throw_lossy(path, report);
    const mesh_parts parts(m, part_of_poly);
    folder_files files(folder.empty() ? "." : folder, options.sync);
    piece_arrays arrays;
    std::vector<std::string> names;
    for (std::size_t k = 0; k < parts.polys.size(); ++k) {
      names.push_back(core::joined({stem, "_", k, ".vtu"}));
      const auto of_all = [&](double fraction, const char* label) {
        return options.progress((static_cast<double>(k) + fraction) / static_cast<double>(parts.polys.size()), label);
      };
      save_options of_part = options;
      if (options.progress) of_part.progress = of_all;
      using list = std::span<const std::uint32_t>;
      part_flat_mesh part(m, parts.polys[k], k == 0 ? list(parts.loose_verts) : list(), properties);
      arrays = save_part(part, files.file(names.back()), core::joined({folder, names.back()}), of_part);
    }
    write_pvtu(files.file(file_name), arrays, names);
    files.finish();
    if (options.progress) report_progress(options.progress, 1.0, "writing");
    files.commit();
  });
}

}  // namespace concino::detail
