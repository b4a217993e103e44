// slice_mesh: the layers of a closed surface or of a volume, for printing it.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/io/slice_layer.hpp>
#include <concino/print/detail/slices/mesh_sections.hpp>
#include <concino/print/slice_report.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace concino {

/// Slices of a mesh, and which of its polys their contours pass.
template<class M>
struct mesh_slices : slices {
  slice_report report;
  std::vector<detail::section_polys> outer_polys, inner_polys, open_polys;  // by layer
  std::vector<poly_t<M>> polys;                                             // that are numbered there

  /// The polys that a contour or open line passes, in its order; neighbours differ.
  std::vector<poly_t<M>> polys_of(std::size_t layer, slice_lines_kind kind, std::size_t contour) const {
    const auto& lists = (kind == slice_lines_kind::outer   ? outer_polys
                         : kind == slice_lines_kind::inner ? inner_polys
                                                           : open_polys)[layer];
    std::vector<poly_t<M>> result;
    for (std::size_t i = contour == 0 ? 0 : lists.ends[contour - 1]; i < lists.ends[contour]; ++i)
      result.push_back(polys[lists.polys[i]]);
    return result;
  }
};

struct slice_mesh_options {
  bool accept_open = false;           // whether surfaces may be open, or have edges of more than two polys; open lines
                                      // are then in the layers and in the report
  bool accept_intersections = false;  // whether surfaces may intersect themselves, which is then not looked for
  concino::progress progress = {};    // called with the fraction of the layers
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

namespace detail {

template<class M, class Section>
mesh_slices<M> slices_at(const M& m, const std::vector<double>& heights, const slice_mesh_options& input_options,
                         const Section& section) {
  const core::profiled_options profiled(input_options, "slice_mesh");
  const slice_mesh_options& options = *profiled;
  mesh_slices<M> result;
  mesh_sections<M> sections(m);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    report_progress(options.progress, static_cast<double>(i) / static_cast<double>(heights.size()), "slice_mesh");
    section_layer layer = section(sections, heights[i]);
    for (std::size_t k = 0; k < layer.layer.open.size(); ++k)
      result.report.notes.push_back({i, slice_lines_kind::open, k, contour_change::left_open});
    result.layers.push_back(std::move(layer.layer));
    result.outer_polys.push_back(std::move(layer.outer));
    result.inner_polys.push_back(std::move(layer.inner));
    result.open_polys.push_back(std::move(layer.open));
  }
  result.polys = std::move(sections.found);
  return result;
}

}  // namespace detail

/// The layers of a closed surface, or of a volume, at heights z: what lies right above each plane. So material above a
/// plane counts: the layer at the lowest face of a box is full, the one at its highest face is empty, whether verts,
/// edges or faces lie in the plane or not.
/// Needs:  EmbeddedMesh: a surface that is closed, oriented outward and does not intersect itself, or a volume. Finite
///         heights in any order, such as heights(m, thickness).
/// Result: slices, which save_slices writes, with one layer for each height. Contours are closed, outer ones
///         counter-clockwise, those of holes clockwise, all with the material to their left; each knows the polys that
///         it passes. Of parts within parts, a surface fills what it winds around with a positive number. Contours may
///         touch themselves where the mesh touches itself. Contours without area are left out.
/// Cost:   O(verts + polys) a height, and O(n log n) for layers of n points. The polys of a surface are compared for
///         intersections once.
/// Errors: invalid_argument that names a height, or a vert, that is not finite. invalid_mesh that names an edge where
///         the surface is open, branches or is not oriented alike, or two polys that intersect, if options do not
///         accept them; or if the surface is inside out. Others as isosurface. cancelled.
/// Source: paper section 2.2, 3D printing; for planes through verts, simulation of simplicity: Edelsbrunner and Muecke
///         1990.
template<SurfaceMesh M>
  requires Embedded<M>
mesh_slices<M> slice_mesh(const M& m, const std::vector<double>& heights, const slice_mesh_options& options = {}) {
  detail::check_heights(heights);
  if (!options.accept_open) detail::check_closed_outward(m);
  if (!options.accept_intersections) detail::check_no_intersections(m);
  return detail::slices_at(m, heights, options, [](detail::mesh_sections<M>& s, double z) { return s.of_surface(z); });
}
template<VolumeMesh M>
  requires Embedded<M>
mesh_slices<M> slice_mesh(const M& m, const std::vector<double>& heights, const slice_mesh_options& options = {}) {
  detail::check_heights(heights);
  return detail::slices_at(m, heights, options, [](detail::mesh_sections<M>& s, double z) {
    return s.of_volume(z, [](const poly_t<M>&) { return 0; });
  });
}

/// The layers of a volume with contours around the polys of each label.
/// Needs:  as slice_mesh of a volume; label[p] is an integer for each poly.
/// Result: as slice_mesh. Contours have the label as their id, and the slices have names "label 3" of the ids that
///         occur.
/// Cost:   as slice_mesh.      Errors: as slice_mesh.
template<VolumeMesh M, ReadableMap<poly_t<M>> Labels>
  requires Embedded<M> && requirement::gives_numbers<Labels, poly_t<M>>
mesh_slices<M> slice_mesh(const M& m, const std::vector<double>& heights, const Labels& label,
                          const slice_mesh_options& options = {}) {
  detail::check_heights(heights);
  const auto label_of = [&](const poly_t<M>& p) { return static_cast<std::int32_t>(label[p]); };
  mesh_slices<M> result = detail::slices_at(
      m, heights, options, [&](detail::mesh_sections<M>& s, double z) { return s.of_volume(z, label_of); });
  std::vector<std::int32_t> all;
  for (const slice_layer& layer : result.layers)
    all.insert(all.end(), layer.outer.ids.begin(), layer.outer.ids.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  for (const std::int32_t id : all) result.labels.push_back({id, core::joined({"label ", id})});
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void slice_mesh(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void slice_mesh(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
